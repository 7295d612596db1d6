// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/hex_mesh.h>

#include <array>
#include <vector>

namespace contrecoup
{
/// End points of the edges of a hexahedron, numbered as in HexMesh.
inline constexpr std::array<std::array<unsigned int, 2>, 12> hex_edges{
  {{{0, 1}},
   {{1, 2}},
   {{2, 3}},
   {{3, 0}},
   {{4, 5}},
   {{5, 6}},
   {{6, 7}},
   {{7, 4}},
   {{0, 4}},
   {{1, 5}},
   {{2, 6}},
   {{3, 7}}}};

/// Corners of a hexahedron, in the order of HexMesh.
using HexCorners = std::array<dealii::Point<3>, 8>;

/**
 * Scaled Jacobian [-]: the smallest, over the eight corners, of the
 * determinants of the unit vectors along a corner's edges; 1 for a box, not
 * positive for a folded corner (Knupp 2000).
 */
double scaled_jacobian(const HexCorners &corners);

/// Exact volume of a trilinear hexahedron [m^3].
double volume(const HexCorners &corners);

/// Volume over the area of the largest face [m], the length for the CFL limit.
double characteristic_length(const HexCorners &corners);

/// Quality measures of the elements of a part or a mesh.
struct HexQuality
{
  std::size_t n_cells = 0;
  double volume = 0.;            ///< [m^3]
  dealii::Point<3> first_moment; ///< integral of position [m^4]
  double smallest_scaled_jacobian = 1.;
  double mean_scaled_jacobian = 0.;
  double shortest_edge = 0.;   ///< [m]
  double longest_edge = 0.;    ///< [m]
  double shortest_length = 0.; ///< smallest characteristic_length() [m]
};

/// Quality measures of each part of a mesh.
std::vector<HexQuality> measure_quality(const HexMesh &mesh);

/// Quality measures of the union of two sets of elements.
HexQuality operator+(const HexQuality &a, const HexQuality &b);
} // namespace contrecoup
