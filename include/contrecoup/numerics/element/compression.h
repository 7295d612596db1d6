// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/numerics/element/hex8_geometry.h>

namespace contrecoup
{
/// Symmetric part of a velocity gradient, and the direction of strongest
/// compression.
template <typename Number>
struct Compression
{
  Matrix3<Number> rate;       ///< symmetric [1/s]
  Number smallest_eigenvalue; ///< smallest eigenvalue of `rate` [1/s]
  Number norm;                ///< Frobenius norm of `rate` [1/s]
  /// Projector on the eigenspace of `smallest_eigenvalue`, with unit trace.
  Matrix3<Number> direction;
};

/**
 * Computes the smallest eigenvalue of a symmetric matrix from its invariants:
 * with f = -1/2 - d it is the smallest root of 4 f^3 - 3 f = r, hence d solves
 * d^2 (6 + 4 d) = 1 - r in [0, 1/2]; by Newton's method. If the two smallest
 * eigenvalues nearly coincide, the projector is on both directions.
 */
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Compression<Number>
find_compression(const Matrix3<Number> &gradient)
{
  using std::max;
  using std::min;
  using std::sqrt;
  Compression<Number> result;
  Matrix3<Number> &e = result.rate;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      e[i][j] = Number(0.5) * (gradient[i][j] + gradient[j][i]);
  const Number mean = Number(1. / 3.) * (e[0][0] + e[1][1] + e[2][2]);
  const Number a = e[0][0] - mean, b = e[1][1] - mean, c = e[2][2] - mean;
  const Number xy = e[0][1], yz = e[1][2], zx = e[2][0];
  const Number tiny(1e-200);
  const Number square = Number(1. / 6.) * (a * a + b * b + c * c) +
                        Number(1. / 3.) * (xy * xy + yz * yz + zx * zx);
  const Number determinant =
    a * (b * c - yz * yz) - xy * (xy * c - yz * zx) + zx * (xy * yz - b * zx);
  const Number size = sqrt(square);
  const Number r =
    max(Number(-1.),
        min(Number(1.), Number(0.5) * determinant / (square * size + tiny)));
  const Number right = Number(1.) - r;
  Number d = sqrt(Number(1. / 6.) * right);
  for (unsigned int i = 0; i < 4; ++i)
    d -= (d * d * (Number(6.) + Number(4.) * d) - right) /
         (Number(12.) * d * (Number(1.) + d) + tiny);
  const Number f = Number(-0.5) - d;
  result.smallest_eigenvalue = mean + Number(2.) * size * f;
  result.norm = sqrt(Number(3.) * mean * mean + Number(6.) * square);

  // Regularise the case of three equal eigenvalues.
  const Number all = Number(1e-12) * square + tiny;
  Matrix3<Number> &direction = result.direction;
  const auto find_direction = [&](const Number &root) {
    Matrix3<Number> rest = e;
    for (unsigned int i = 0; i < 3; ++i)
      rest[i][i] -= root;
    direction = cofactor(rest);
    for (unsigned int i = 0; i < 3; ++i)
      direction[i][i] += Number(1. / 3.) * all;
  };
  find_direction(result.smallest_eigenvalue);
  // A double root is accurate to half of the digits only; between the two
  // roots the formula gives no projector, slightly below both it does.
  const Number trace = direction[0][0] + direction[1][1] + direction[2][2];
  Number norm_square{};
  for (const auto &row : direction)
    norm_square += dot(row, row);
  find_direction(result.smallest_eigenvalue -
                 select_less(Number(1. + 1e-6) * trace * trace,
                             norm_square,
                             Number(1e-6) * result.norm,
                             Number()));
  const Number scale =
    Number(1.) / (direction[0][0] + direction[1][1] + direction[2][2]);
  for (auto &row : direction)
    for (Number &value : row)
      value *= scale;
  return result;
}
} // namespace contrecoup
