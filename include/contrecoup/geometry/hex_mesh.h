// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body.h>

#include <array>
#include <cstdint>
#include <vector>

namespace contrecoup
{
/**
 * Hexahedra of a body. Corners are numbered as VTK and Gmsh do: around the
 * bottom, then around the top, so that the three edges of corner 0 go to
 * corners 1, 3 and 4.
 */
struct HexMesh
{
  using Cell = std::array<std::uint32_t, 8>;

  /// A quadrilateral of the outer surface; its corners go around
  /// counterclockwise when seen from outside.
  struct Facet
  {
    std::array<std::uint32_t, 4> nodes;
    std::uint32_t cell;
  };

  /// A node in the middle of an edge (two masters) or a face (four) of a
  /// larger neighbour: its displacement is the mean of theirs.
  struct HangingNode
  {
    std::uint32_t node;
    std::vector<std::uint32_t> masters; ///< none of them hangs
    std::vector<double> weights;        ///< of the masters, sum 1
  };

  std::vector<dealii::Point<3>> nodes; ///< [m]
  std::vector<Cell> cells;
  std::vector<unsigned char> part; ///< of each cell
  std::vector<BodyPart> parts;     ///< by number
  std::vector<Facet> boundary;
  /// Faces between two parts, the boundary left out.
  std::vector<std::array<std::uint32_t, 4>> interfaces;
  std::vector<HangingNode> hanging_nodes;

  dealii::Point<3> center(const Facet &facet) const;

  /// Its normal times its area, exact for a bilinear facet [m^2].
  dealii::Tensor<1, 3> area_vector(const Facet &facet) const;
};

/**
 * Makes cubes of the labelled cubes of a grid, in the order of the grid: one of
 * each, or larger ones away from what bounds the parts. Cubes at the boundary
 * and at interfaces, and their neighbours, are as small as those of the grid;
 * each merged one is as large as 2, 4, ... 2^levels of them, and its neighbours
 * through faces, edges and corners are at least half as large.
 * @param levels times that cubes may double
 */
HexMesh make_hex_mesh(const LabelGrid &grid,
                      const std::vector<BodyPart> &parts,
                      unsigned int levels = 0);
} // namespace contrecoup
