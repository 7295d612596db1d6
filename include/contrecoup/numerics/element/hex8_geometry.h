// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/materials/solid_law.h>

#include <array>

/**
 * @file
 * The trilinear hexahedron in terms of its eight modes 1, xi, eta, zeta, eta
 * zeta, zeta xi, xi eta, xi eta zeta, in this order. The modal value of a
 * field is the sum of its corner values with the signs of the mode, 8 times
 * the coefficient. Corners are numbered as in HexMesh.
 *
 * Volume and mean gradient are exact (Flanagan and Belytschko 1981): the
 * gradient operator is the derivative of the volume with respect to the
 * corners. In modes it has six vectors instead of eight, and the volume does
 * not depend on the last mode.
 */

namespace contrecoup
{
template <typename Number>
using Vector3 = std::array<Number, 3>;

/// A vector for each corner, or each mode, of a hexahedron.
template <typename Number>
using HexVectors = std::array<Vector3<Number>, 8>;

template <typename Number>
inline DEAL_II_ALWAYS_INLINE Vector3<Number> cross(const Vector3<Number> &a,
                                                   const Vector3<Number> &b)
{
  return {{a[1] * b[2] - a[2] * b[1],
           a[2] * b[0] - a[0] * b[2],
           a[0] * b[1] - a[1] * b[0]}};
}

template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number dot(const Vector3<Number> &a,
                                        const Vector3<Number> &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Transforms corner values to modes.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE HexVectors<Number>
to_modes(const HexVectors<Number> &corner)
{
  HexVectors<Number> mode;
  for (unsigned int d = 0; d < 3; ++d)
  {
    std::array<Number, 4> sum, jump; // along xi, at (eta, zeta) = -- +- -+ ++
    constexpr unsigned int low[] = {0, 3, 4, 7}, high[] = {1, 2, 5, 6};
    for (unsigned int i = 0; i < 4; ++i)
    {
      sum[i] = corner[high[i]][d] + corner[low[i]][d];
      jump[i] = corner[high[i]][d] - corner[low[i]][d];
    }
    const Number s0 = sum[0] + sum[1], s1 = sum[2] + sum[3];
    const Number e0 = sum[1] - sum[0], e1 = sum[3] - sum[2];
    const Number x0 = jump[0] + jump[1], x1 = jump[2] + jump[3];
    const Number y0 = jump[1] - jump[0], y1 = jump[3] - jump[2];
    mode[0][d] = s0 + s1;
    mode[1][d] = x0 + x1;
    mode[2][d] = e0 + e1;
    mode[3][d] = s1 - s0;
    mode[4][d] = e1 - e0;
    mode[5][d] = x1 - x0;
    mode[6][d] = y0 + y1;
    mode[7][d] = y1 - y0;
  }
  return mode;
}

/// Transpose of to_modes(): transforms modal forces to corner forces. Mode 0
/// carries no force and is ignored.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE HexVectors<Number>
to_corners(const HexVectors<Number> &mode)
{
  HexVectors<Number> corner;
  for (unsigned int d = 0; d < 3; ++d)
  {
    // The part multiplied by +-zeta, for each sign of eta and xi.
    const Number s0 = Number() - mode[3][d], s1 = mode[3][d];
    const Number e0 = mode[2][d] - mode[4][d], e1 = mode[2][d] + mode[4][d];
    const Number x0 = mode[1][d] - mode[5][d], x1 = mode[1][d] + mode[5][d];
    const Number y0 = mode[6][d] - mode[7][d], y1 = mode[6][d] + mode[7][d];
    const std::array<Number, 4> sum{{s0 - e0, s0 + e0, s1 - e1, s1 + e1}};
    const std::array<Number, 4> jump{{x0 - y0, x0 + y0, x1 - y1, x1 + y1}};
    constexpr unsigned int low[] = {0, 3, 4, 7}, high[] = {1, 2, 5, 6};
    for (unsigned int i = 0; i < 4; ++i)
    {
      corner[low[i]][d] = sum[i] - jump[i];
      corner[high[i]][d] = sum[i] + jump[i];
    }
  }
  return corner;
}

/// Geometry of the undeformed hexahedron.
template <typename Number>
struct HexGeometry
{
  /// Derivative of the volume with respect to modes 1 to 6 [m^2].
  std::array<Vector3<Number>, 6> volume_gradient;
  /// Modes 4 to 7 of the corners [m].
  std::array<Vector3<Number>, 4> warp;
  Number volume;         ///< [m^3]
  Number inverse_volume; ///< [1/m^3]
  /// Sum over corners of |d volume / d corner|^2 [m^4]; 1.5 h^4 for a cube.
  Number gradient_square;

  /// Edge of a cube with the same ratio of squared gradients to volume [m];
  /// hourglass stiffness is proportional to this length.
  Number stiffness_length() const
  {
    return Number(2. / 3.) * gradient_square * inverse_volume;
  }

  /// Face of a cube with the same squared gradients [m^2]; hourglass damping
  /// is proportional to this area. Divided by the volume, it scales like the
  /// highest frequency of the element, and thus like the inverse stable step.
  Number damping_area() const
  {
    using std::sqrt;
    return sqrt(Number(2. / 3.) * gradient_square);
  }

  /// Edge of a cube with the same highest frequency [m].
  Number wave_length() const
  {
    using std::sqrt;
    return volume * sqrt(Number(1.5) / gradient_square);
  }
};

/// Geometry of a hexahedron with corner modes @p x.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE HexGeometry<Number>
hex_geometry(const HexVectors<Number> &x)
{
  HexGeometry<Number> g;
  const Number scale(1. / 64.), third(1. / 192.);
  const Vector3<Number> &a1 = x[1], &a2 = x[2], &a3 = x[3];
  const Vector3<Number> &w1 = x[4], &w2 = x[5], &w3 = x[6];
  const auto set = [&](const unsigned int i,
                       const Number &factor,
                       const Vector3<Number> &first,
                       const Vector3<Number> &second) {
    for (unsigned int d = 0; d < 3; ++d)
      g.volume_gradient[i][d] = factor * first[d] + third * second[d];
  };
  const auto sum = [](const Vector3<Number> &a, const Vector3<Number> &b) {
    return Vector3<Number>{{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
  };
  const Vector3<Number> w32 = cross(w3, w2), w13 = cross(w1, w3),
                        w21 = cross(w2, w1);
  const Vector3<Number> a23 = cross(a2, a3);
  set(0, scale, a23, w32);
  set(1, scale, cross(a3, a1), w13);
  set(2, scale, cross(a1, a2), w21);
  const Vector3<Number> none{{Number(), Number(), Number()}};
  set(3, scale, none, sum(cross(a3, w2), cross(w3, a2)));
  set(4, scale, none, sum(cross(a1, w3), cross(w1, a3)));
  set(5, scale, none, sum(cross(w2, a1), cross(a2, w1)));
  g.volume =
    dot(a1, g.volume_gradient[0]) + third * (dot(a2, w13) + dot(a3, w21));
  g.inverse_volume = Number(1.) / g.volume;
  g.gradient_square = Number();
  for (unsigned int m = 0; m < 6; ++m)
    g.gradient_square += dot(g.volume_gradient[m], g.volume_gradient[m]);
  g.gradient_square *= Number(8.);
  for (unsigned int m = 0; m < 4; ++m)
    g.warp[m] = x[4 + m];
  return g;
}

/// Mean gradient over the hexahedron of a field with modes @p u.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Matrix3<Number>
mean_gradient(const HexGeometry<Number> &g, const HexVectors<Number> &u)
{
  Matrix3<Number> h;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
    {
      Number sum = u[1][i] * g.volume_gradient[0][j];
      for (unsigned int m = 1; m < 6; ++m)
        sum += u[m + 1][i] * g.volume_gradient[m][j];
      h[i][j] = g.inverse_volume * sum;
    }
  return h;
}
/// Jacobian determinant at a point of the reference cube [-1, 1]^3 of a
/// hexahedron with corner modes @p x [m^3].
template <typename Number>
inline Number jacobian(const HexVectors<Number> &x, const Vector3<Number> &p)
{
  Vector3<Number> a, b, c;
  for (unsigned int d = 0; d < 3; ++d)
  {
    a[d] = x[1][d] + x[5][d] * p[2] + x[6][d] * p[1] + x[7][d] * p[1] * p[2];
    b[d] = x[2][d] + x[4][d] * p[2] + x[6][d] * p[0] + x[7][d] * p[2] * p[0];
    c[d] = x[3][d] + x[4][d] * p[1] + x[5][d] * p[0] + x[7][d] * p[0] * p[1];
  }
  return Number(1. / 512.) * dot(a, cross(b, c));
}

/// Smallest Jacobian determinant at the eight Gauss points [m^3].
template <typename Number>
inline Number smallest_gauss_jacobian(const HexVectors<Number> &x)
{
  using std::min;
  const double gauss = 0.577350269189625764509;
  Number smallest = jacobian(x, {{gauss, gauss, gauss}});
  for (unsigned int i = 0; i < 7; ++i)
    smallest = min(smallest,
                   jacobian(x,
                            Vector3<Number>{{i & 1 ? gauss : -gauss,
                                             i & 2 ? gauss : -gauss,
                                             i & 4 ? gauss : -gauss}}));
  return smallest;
}
} // namespace contrecoup
