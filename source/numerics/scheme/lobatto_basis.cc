// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/scheme/lobatto_basis.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace contrecoup
{
namespace
{
  using Matrix = dealii::FullMatrix<double>;

  /// l_j'(x_i) from the barycentric weights of the nodes (Berrut and
  /// Trefethen 2004, section 9.3).
  Matrix derivative_matrix(const std::vector<double> &x)
  {
    const unsigned int n = x.size();
    std::vector<double> barycentric(n, 1.);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        if (j != i)
          barycentric[i] /= x[i] - x[j];

    Matrix matrix(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        if (j != i)
        {
          matrix(i, j) = barycentric[j] / barycentric[i] / (x[i] - x[j]);
          matrix(i, i) -= matrix(i, j);
        }
    return matrix;
  }

  /// Orthonormal Legendre polynomials on [0, 1], degrees 0 to n - 1.
  std::vector<double> legendre_values(const unsigned int n, const double x)
  {
    const double z = 2. * x - 1.;
    std::vector<double> values(n, 1.);
    if (n > 1)
      values[1] = z;
    for (unsigned int k = 2; k < n; ++k)
      values[k] =
        ((2. * k - 1.) * z * values[k - 1] - (k - 1.) * values[k - 2]) / k;
    for (unsigned int k = 0; k < n; ++k)
      values[k] *= std::sqrt(2. * k + 1.);
    return values;
  }

  /// Exact mass matrix, M(i, j) = int l_i l_j over [0, 1].
  Matrix mass_matrix(const LobattoBasis &basis)
  {
    const unsigned int n = basis.n_points();
    const dealii::QGauss<1> gauss(n);
    Matrix mass(n, n);
    for (unsigned int q = 0; q < gauss.size(); ++q)
    {
      const std::vector<double> l = basis.values(gauss.point(q)[0]);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          mass(i, j) += l[i] * l[j] * gauss.weight(q);
    }
    return mass;
  }

  /// M^-1 I^T M / 2 with I = @p to_child.
  Matrix projection_matrix(const Matrix &mass, const Matrix &to_child)
  {
    const unsigned int n = mass.m();
    Matrix inverse(n, n), moments(n, n), projection(n, n);
    inverse.invert(mass);
    to_child.Tmmult(moments, mass);
    inverse.mmult(projection, moments);
    projection *= 0.5;
    return projection;
  }
} // namespace

LobattoBasis::LobattoBasis(const unsigned int n_points)
  : to_modal_(n_points, n_points)
{
  if (n_points < 2)
    throw InputError("A Gauss-Lobatto basis needs at least 2 points, not " +
                     std::to_string(n_points) + ".");
  const dealii::QGaussLobatto<1> quadrature(n_points);
  for (unsigned int i = 0; i < n_points; ++i)
    nodes_.push_back(quadrature.point(i)[0]);
  weights_ = quadrature.get_weights();
  derivative_ = derivative_matrix(nodes_);

  const Matrix mass = mass_matrix(*this);
  for (unsigned int child = 0; child < 2; ++child)
  {
    to_child_[child].reinit(n_points, n_points);
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const std::vector<double> l = values(0.5 * (child + nodes_[i]));
      for (unsigned int j = 0; j < n_points; ++j)
        to_child_[child](i, j) = l[j];
    }
    from_child_[child] = projection_matrix(mass, to_child_[child]);
  }

  Matrix to_nodal(n_points, n_points);
  for (unsigned int i = 0; i < n_points; ++i)
  {
    const std::vector<double> modes = legendre_values(n_points, nodes_[i]);
    for (unsigned int j = 0; j < n_points; ++j)
      to_nodal(i, j) = modes[j];
  }
  to_modal_.invert(to_nodal);
}

unsigned int LobattoBasis::n_points() const
{
  return nodes_.size();
}

const std::vector<double> &LobattoBasis::nodes() const
{
  return nodes_;
}

const std::vector<double> &LobattoBasis::weights() const
{
  return weights_;
}

const Matrix &LobattoBasis::derivative() const
{
  return derivative_;
}

const Matrix &LobattoBasis::to_child(const unsigned int child) const
{
  return to_child_.at(child);
}

const Matrix &LobattoBasis::from_child(const unsigned int child) const
{
  return from_child_.at(child);
}

const Matrix &LobattoBasis::to_modal() const
{
  return to_modal_;
}

std::vector<double> LobattoBasis::values(const double x) const
{
  std::vector<double> result(nodes_.size(), 1.);
  for (unsigned int j = 0; j < nodes_.size(); ++j)
    for (unsigned int k = 0; k < nodes_.size(); ++k)
      if (k != j)
        result[j] *= (x - nodes_[k]) / (nodes_[j] - nodes_[k]);
  return result;
}
} // namespace contrecoup
