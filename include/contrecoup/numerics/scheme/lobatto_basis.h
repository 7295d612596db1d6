// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace contrecoup
{
/**
 * Lagrange polynomials l_j on the n Gauss-Lobatto points of [0, 1], and the
 * one-dimensional matrices of a tensor-product element. Point 0 is at 0, point
 * n - 1 at 1.
 */
class LobattoBasis
{
public:
  /// @param n_points n >= 2; the polynomials have degree n - 1
  explicit LobattoBasis(unsigned int n_points);

  unsigned int n_points() const;

  /// The points x_i.
  const std::vector<double> &nodes() const;

  /// Quadrature weights w_i, exact for degree 2 n - 3; their sum is 1.
  const std::vector<double> &weights() const;

  /// D(i, j) = l_j'(x_i). Each diagonal entry is minus the sum of the other
  /// entries of its row; sum_j D(i, j) (u_j - u_i) is thus the derivative as
  /// well, and exactly zero for constants.
  const dealii::FullMatrix<double> &derivative() const;

  /// I(i, j) = l_j at point i of the lower (0) or upper (1) half interval:
  /// interpolates from parent to child.
  const dealii::FullMatrix<double> &to_child(unsigned int child) const;

  /// P(0) u(0) + P(1) u(1) is the L2 projection of a function on both halves
  /// to the parent. It conserves integrals (w^T P = w^T/2) and reproduces
  /// polynomials on the parent.
  const dealii::FullMatrix<double> &from_child(unsigned int child) const;

  /// Transforms nodal values to coefficients of orthonormal Legendre
  /// polynomials, lowest degree first.
  const dealii::FullMatrix<double> &to_modal() const;

  /// Values l_j(@p x) for all j.
  std::vector<double> values(double x) const;

private:
  std::vector<double> nodes_;
  std::vector<double> weights_;
  dealii::FullMatrix<double> derivative_;
  std::array<dealii::FullMatrix<double>, 2> to_child_;
  std::array<dealii::FullMatrix<double>, 2> from_child_;
  dealii::FullMatrix<double> to_modal_;
};
} // namespace contrecoup
