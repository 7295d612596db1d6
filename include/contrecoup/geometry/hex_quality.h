// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/hex_mesh.h>

#include <array>
#include <vector>

namespace contrecoup
{
/// The corners at both ends of each edge of a hexahedron, numbered as in
/// HexMesh.
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

/// The corners of one hexahedron, in the order of HexMesh.
using HexCorners = std::array<dealii::Point<3>, 8>;

/**
 * The smallest of the eight corners' scaled Jacobians [-]: the determinant of
 * the three unit vectors along the edges of a corner; 1 for a box, at most 0
 * when a corner is folded (Knupp 2000).
 */
double scaled_jacobian(const HexCorners &corners);

/// Exact volume of a trilinear hexahedron [m^3].
double volume(const HexCorners &corners);

/// Volume over the area of the largest face, the length that stable time
/// steps are made of [m].
double characteristic_length(const HexCorners &corners);

/// What the elements of one part, or of a whole mesh, amount to.
struct HexQuality
{
  std::size_t n_cells = 0;
  double volume = 0.;            ///< [m^3]
  dealii::Point<3> first_moment; ///< of the volume [m^4]
  double smallest_scaled_jacobian = 1.;
  double mean_scaled_jacobian = 0.;
  double shortest_edge = 0.;   ///< [m]
  double longest_edge = 0.;    ///< [m]
  double shortest_length = 0.; ///< characteristic_length() [m]
};

/// The quality of each part of a mesh.
std::vector<HexQuality> measure_quality(const HexMesh &mesh);

/// That of two sets of elements together.
HexQuality operator+(const HexQuality &a, const HexQuality &b);
} // namespace contrecoup
