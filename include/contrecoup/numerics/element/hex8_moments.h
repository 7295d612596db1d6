// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/hex8_geometry.h>

/**
 * @file
 * Volume and first moment of hexahedra with bilinear faces, and of the region
 * that such a face sweeps when its corners move. Regions swept by adjacent
 * faces share bilinear sides. The volume of a hexahedron with moved corners
 * thus equals the old volume plus the swept volumes of its faces up to
 * round-off, for any motion.
 */

namespace contrecoup
{
/// Corners of each face of a hexahedron, counterclockwise seen from outside;
/// faces in deal.II's order -x, +x, -y, +y, -z, +z.
inline constexpr unsigned int hex_faces[6][4] = {{0, 4, 7, 3},
                                                 {1, 2, 6, 5},
                                                 {0, 1, 5, 4},
                                                 {2, 3, 7, 6},
                                                 {0, 3, 2, 1},
                                                 {4, 5, 6, 7}};

/// Corners adjacent to each corner, ordered such that the determinant of the
/// edges is positive unless the hexahedron is inverted.
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
  Vector3<Number> first; ///< integral of position [m^4]
};

/// Position at reference coordinates @p p in [-1, 1]^3.
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
 * Exact volume and first moment of a hexahedron; both change sign if it is
 * inverted. Two Gauss points per direction are exact for the moment, which is
 * cubic in each coordinate.
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
 * Volume and first moment swept by a face whose corners move from @p before to
 * @p after; positive in the direction of its normal.
 * @param before counterclockwise seen from the side of the normal
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

/// Smallest determinant of the edges at a corner [m^3].
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
