// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/image/body_part.h>
#include <contrecoup/geometry/image/label_grid.h>

#include <array>
#include <cstdint>
#include <vector>

namespace contrecoup
{
/// In place of the index of a node, cell or facet that there is not.
constexpr std::uint32_t no_index = -1;

/// deal.II's vertex number of each corner of HexMesh, and the reverse.
constexpr unsigned int vertex_of_corner[] = {0, 1, 3, 2, 4, 5, 7, 6};

/// Corners of the faces at -x, +x, -y, +y, -z, +z, seen from outside.
constexpr unsigned int hex_face_corners[6][4] = {{0, 4, 7, 3},
                                                 {1, 2, 6, 5},
                                                 {0, 1, 5, 4},
                                                 {3, 7, 6, 2},
                                                 {0, 3, 2, 1},
                                                 {4, 5, 6, 7}};

/// A hexahedral mesh of a body. Corners are numbered as in VTK and Gmsh:
/// around the bottom, then around the top; corner 0 is joined to corners 1, 3
/// and 4.
struct HexMesh
{
  using Cell = std::array<std::uint32_t, 8>;

  /// A quadrilateral of the boundary, with corners counterclockwise seen from
  /// outside.
  struct Facet
  {
    std::array<std::uint32_t, 4> nodes;
    std::uint32_t cell;
  };

  /// A hanging node in the middle of an edge (two masters) or face (four
  /// masters) of a larger neighbour. Its displacement is interpolated from the
  /// masters.
  struct HangingNode
  {
    std::uint32_t node;
    std::vector<std::uint32_t> masters; ///< nodes that do not hang
    std::vector<double> weights;        ///< of the masters, sum 1
  };

  std::vector<dealii::Point<3>> nodes; ///< [m]
  std::vector<Cell> cells;
  std::vector<unsigned char> part; ///< part number of each cell
  std::vector<BodyPart> parts;     ///< by number
  std::vector<Facet> boundary;
  /// Faces between two parts, without boundary faces.
  std::vector<std::array<std::uint32_t, 4>> interfaces;
  std::vector<HangingNode> hanging_nodes;

  dealii::Point<3> center(const Facet &facet) const;

  /// Normal times area, exact for a bilinear facet [m^2].
  dealii::Tensor<1, 3> area_vector(const Facet &facet) const;
};

/**
 * Converts the labelled voxels of a grid to hexahedra, in the order of the
 * grid. With @p levels > 0, voxels away from boundary and interfaces are
 * merged to cubes of 2, 4, ... 2^levels voxels, with 2:1 balance across faces,
 * edges and corners. Cubes at the boundary and at interfaces, and their
 * neighbours, are not merged.
 * @param levels largest number of doublings
 */
HexMesh make_hex_mesh(const LabelGrid &grid,
                      const std::vector<BodyPart> &parts,
                      unsigned int levels = 0);

/// Numbers of hexahedra and boundary facets.
struct HexMeshSize
{
  double cells = 0.;
  double facets = 0.;
};

/// Size of the mesh that make_hex_mesh() would give.
HexMeshSize count_hexahedra(const LabelGrid &grid, unsigned int levels);
} // namespace contrecoup
