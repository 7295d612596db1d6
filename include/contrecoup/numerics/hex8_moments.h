// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/hex8_geometry.h>

/**
 * @file
 * Volumes and first moments of hexahedra with bilinear faces, and of what such
 * a face sweeps when its corners move. Neighbouring faces sweep regions that
 * share their bilinear sides, so that the volume of a hexahedron with moved
 * corners is the old one plus what its faces sweep, to round-off, whatever the
 * motion.
 */

namespace contrecoup
{
/// Corners of the faces of a hexahedron, counterclockwise when seen from
/// outside, in the order of deal.II: -x, +x, -y, +y, -z, +z.
inline constexpr unsigned int hex_faces[6][4] = {{0, 4, 7, 3},
                                                 {1, 2, 6, 5},
                                                 {0, 1, 5, 4},
                                                 {2, 3, 7, 6},
                                                 {0, 3, 2, 1},
                                                 {4, 5, 6, 7}};

/// Corners that the edges of each corner go to; in this order they have a
/// positive determinant where the hexahedron is not inverted.
inline constexpr unsigned int hex_corner_edges[8][3] = {{1, 3, 4},
                                                        {2, 0, 5},
                                                        {3, 1, 6},
                                                        {0, 2, 7},
                                                        {7, 5, 0},
                                                        {4, 6, 1},
                                                        {5, 7, 2},
                                                        {6, 4, 3}};

/// Integrals over a hexahedron.
template <typename Number>
struct HexMoments
{
  Number volume;         ///< [m^3]
  Vector3<Number> first; ///< of the position [m^4]
};

/// A position as a polynomial of the reference coordinates in [-1, 1].
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Vector3<Number>
hex_position(const HexVectors<Number> &x, const Vector3<Number> &p)
{
  Vector3<Number> result;
  for (unsigned int d = 0; d < 3; ++d)
    result[d] = Number(0.125) *
                (x[0][d] + x[1][d] * p[0] + x[2][d] * p[1] + x[3][d] * p[2] +
                 x[4][d] * p[1] * p[2] + x[5][d] * p[2] * p[0] +
                 x[6][d] * p[0] * p[1] + x[7][d] * p[0] * p[1] * p[2]);
  return result;
}

/**
 * Exact volume and first moment of the hexahedron with these @p corners; both
 * are negative where it is turned inside out. Two Gauss points in each
 * direction are exact for the moment, which is cubic in each coordinate.
 */
template <typename Number>
inline HexMoments<Number> hex_moments(const HexVectors<Number> &corners)
{
  const HexVectors<Number> x = to_modes(corners);
  HexMoments<Number> result{hex_geometry(x).volume, {}};
  const double gauss = 0.577350269189625764509;
  for (unsigned int i = 0; i < 8; ++i)
  {
    const Vector3<Number> p{{Number(i & 1 ? gauss : -gauss),
                             Number(i & 2 ? gauss : -gauss),
                             Number(i & 4 ? gauss : -gauss)}};
    const Number weight = jacobian(x, p);
    const Vector3<Number> place = hex_position(x, p);
    for (unsigned int d = 0; d < 3; ++d)
      result.first[d] += weight * place[d];
  }
  return result;
}

/**
 * What a face sweeps when its corners go from @p before to @p after; positive
 * along its normal.
 * @param before counterclockwise when seen from where the normal points to
 */
template <typename Number>
inline HexMoments<Number>
swept_moments(const std::array<Vector3<Number>, 4> &before,
              const std::array<Vector3<Number>, 4> &after)
{
  HexVectors<Number> corners;
  for (unsigned int i = 0; i < 4; ++i)
  {
    corners[i] = before[i];
    corners[4 + i] = after[i];
  }
  return hex_moments(corners);
}

/// The smallest of the determinants that the edges at the corners have [m^3].
template <typename Number>
inline Number smallest_corner_jacobian(const HexVectors<Number> &corners)
{
  using std::min;
  Number smallest(std::numeric_limits<double>::max());
  for (unsigned int i = 0; i < 8; ++i)
  {
    std::array<Vector3<Number>, 3> edge;
    for (unsigned int e = 0; e < 3; ++e)
      for (unsigned int d = 0; d < 3; ++d)
        edge[e][d] = corners[hex_corner_edges[i][e]][d] - corners[i][d];
    smallest = min(smallest, dot(edge[0], cross(edge[1], edge[2])));
  }
  return smallest;
}
} // namespace contrecoup
