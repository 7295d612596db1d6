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
 * small matrices that one-dimensional parts of a tensor-product element
 * need. Point 0 is at 0, point n - 1 at 1.
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

  /// D(i, j) = l_j'(x_i). The diagonal is minus the sum of the rest of its
  /// row, so sum_j D(i, j) (u_j - u_i) is the derivative too, and exactly
  /// zero for a constant.
  const dealii::FullMatrix<double> &derivative() const;

  /// I(i, j) = l_j at point i of the lower (0) or upper (1) half interval:
  /// from the parent's values to the child's.
  const dealii::FullMatrix<double> &to_child(unsigned int child) const;

  /// P such that P(0) u(0) + P(1) u(1) is the L2 projection of a function
  /// given on both halves; the children's integrals are kept (w^T P = w^T/2)
  /// and a polynomial on the parent comes back unchanged.
  const dealii::FullMatrix<double> &from_child(unsigned int child) const;

  /// Coefficients of the orthonormal Legendre polynomials from the values at
  /// the nodes, lowest degree first.
  const dealii::FullMatrix<double> &to_modal() const;

  /// l_j(@p x) for all j.
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
