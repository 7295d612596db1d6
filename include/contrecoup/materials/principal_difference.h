// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/small_matrix.h>

#include <cmath>

namespace contrecoup
{
/// Deviatoric part of a symmetric matrix.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Symmetric3<Number>
deviator(const Symmetric3<Number> &e)
{
  const Number mean = (e[0] + e[1] + e[2]) * Number(1. / 3.);
  return {{e[0] - mean, e[1] - mean, e[2] - mean, e[3], e[4], e[5]}};
}

/// Upper bound of the square of principal_difference(), at most a third above.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number
square_difference_bound(const Symmetric3<Number> &e)
{
  const Symmetric3<Number> d = deviator(e);
  return Number(2.) * contract(d, d);
}

/**
 * Difference of the largest and the least eigenvalue of a symmetric matrix: of
 * a strain the largest engineering shear strain. With the invariants J_2 and
 * J_3 of the deviator its square x has x (x - 3 J_2)^2 = 4 J_2^3 - 27 J_3^2.
 * Relative errors are below 1e-7, and round-off where no two eigenvalues are
 * alike.
 */
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number
principal_difference(const Symmetric3<Number> &e)
{
  using std::max;
  using std::sqrt;
  const Symmetric3<Number> d = deviator(e);
  const Number j2 = Number(0.5) * contract(d, d);
  const Number j3 = d[0] * (d[1] * d[2] - d[4] * d[4]) -
                    d[3] * (d[3] * d[2] - d[4] * d[5]) +
                    d[5] * (d[3] * d[4] - d[1] * d[5]);
  const Number ratio = j3 * j3 / (j2 * j2 * j2 + Number(1e-300));
  const Number target = sqrt(max(Number(), Number(4.) - Number(27.) * ratio));
  // Newton's method for x = (3 + t) J_2: t sqrt(3 + t) = target.
  Number t = target / sqrt(Number(3.) + Number(0.5) * target);
  for (unsigned int i = 0; i < 2; ++i)
  {
    const Number root = sqrt(Number(3.) + t);
    t -= (t * root - target) / (root + Number(0.5) * t / root);
  }
  return sqrt((Number(3.) + t) * j2);
}
} // namespace contrecoup
