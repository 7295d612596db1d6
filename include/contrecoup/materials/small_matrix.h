// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

#include <array>

namespace contrecoup
{
/// Entry [i][j] of a gradient: derivative of component i in direction j.
template <typename Number>
using Matrix3 = std::array<std::array<Number, 3>, 3>;

/// A symmetric matrix, stored as xx, yy, zz, xy, yz, zx.
template <typename Number>
using Symmetric3 = std::array<Number, 6>;

/// Double contraction a : b of symmetric matrices.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number contract(const Symmetric3<Number> &a,
                                             const Symmetric3<Number> &b)
{
  const Number shear = a[3] * b[3] + a[4] * b[4] + a[5] * b[5];
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + (shear + shear);
}

/// Cofactor matrix of H, d det(H) / d H.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Matrix3<Number> cofactor(const Matrix3<Number> &h)
{
  Matrix3<Number> c;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
    {
      const unsigned int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      const unsigned int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      c[i][j] = h[i1][j1] * h[i2][j2] - h[i1][j2] * h[i2][j1];
    }
  return c;
}

/// x^(-1/3) for 0.05 <= x <= 20, by Newton's method.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number inverse_cube_root(const Number &x)
{
  Number y = Number(1.) / (Number(2. / 3.) + Number(1. / 3.) * x);
  for (unsigned int i = 0; i < 6; ++i)
    y = y * (Number(4. / 3.) - Number(1. / 3.) * x * y * y * y);
  return y;
}
} // namespace contrecoup
