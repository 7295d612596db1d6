// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/scheme/lobatto_basis.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

using namespace contrecoup;

namespace
{
constexpr unsigned int most_points = 5;

std::vector<double> multiply(const dealii::FullMatrix<double> &matrix,
                             const std::vector<double> &values)
{
  std::vector<double> result(matrix.m(), 0.);
  for (unsigned int i = 0; i < matrix.m(); ++i)
    for (unsigned int j = 0; j < matrix.n(); ++j)
      result[i] += matrix(i, j) * values[j];
  return result;
}

/// x^degree at the nodes of [@p start, @p start + @p length].
std::vector<double> monomial(const LobattoBasis &basis,
                             const unsigned int degree,
                             const double start = 0.,
                             const double length = 1.)
{
  std::vector<double> values;
  for (const double x : basis.nodes())
    values.push_back(std::pow(start + length * x, degree));
  return values;
}
} // namespace


TEST(LobattoBasis, HasTheKnownPointsAndWeights)
{
  const LobattoBasis two(2), three(3), four(4), five(5);
  EXPECT_EQ(two.nodes(), (std::vector<double>{0., 1.}));
  EXPECT_DOUBLE_EQ(three.weights()[1], 2. / 3.);
  EXPECT_DOUBLE_EQ(four.nodes()[1], 0.5 - 0.5 / std::sqrt(5.));
  EXPECT_DOUBLE_EQ(four.weights()[0], 1. / 12.);
  EXPECT_DOUBLE_EQ(five.nodes()[1], 0.5 - 0.5 * std::sqrt(3. / 7.));
  EXPECT_DOUBLE_EQ(five.weights()[0], 1. / 20.);
  for (unsigned int n = 2; n <= most_points; ++n)
  {
    const LobattoBasis basis(n);
    EXPECT_EQ(basis.n_points(), n);
    for (unsigned int degree = 0; degree <= 2 * n - 3; ++degree)
    {
      const std::vector<double> values = monomial(basis, degree);
      EXPECT_NEAR(std::inner_product(
                    values.begin(), values.end(), basis.weights().begin(), 0.),
                  1. / (degree + 1.),
                  1e-15);
    }
  }
}


TEST(LobattoBasis, DifferentiatesPolynomialsExactly)
{
  for (unsigned int n = 2; n <= most_points; ++n)
  {
    const LobattoBasis basis(n);
    for (unsigned int degree = 0; degree < n; ++degree)
    {
      const auto slopes = multiply(basis.derivative(), monomial(basis, degree));
      for (unsigned int i = 0; i < n; ++i)
        EXPECT_NEAR(
          slopes[i],
          degree == 0 ? 0. : degree * std::pow(basis.nodes()[i], degree - 1.),
          1e-13);
    }
    // Summation by parts: W D + (W D)^T = diag(-1, 0, ..., 0, 1).
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        const double boundary = i != j ? 0. : (i == n - 1) - double(i == 0);
        EXPECT_NEAR(basis.weights()[i] * basis.derivative()(i, j) +
                      basis.weights()[j] * basis.derivative()(j, i),
                    boundary,
                    1e-14);
      }
    // In the form that the documentation recommends, constants vanish.
    for (unsigned int i = 0; i < n; ++i)
    {
      double row = 0.;
      for (unsigned int j = 0; j < n; ++j)
        row += basis.derivative()(i, j) * (101325.7 - 101325.7);
      EXPECT_EQ(row, 0.);
    }
  }
}


TEST(LobattoBasis, InterpolatesToChildrenExactly)
{
  for (unsigned int n = 2; n <= most_points; ++n)
  {
    const LobattoBasis basis(n);
    for (unsigned int child = 0; child < 2; ++child)
      for (unsigned int degree = 0; degree < n; ++degree)
      {
        const auto values =
          multiply(basis.to_child(child), monomial(basis, degree));
        const auto expected = monomial(basis, degree, 0.5 * child, 0.5);
        for (unsigned int i = 0; i < n; ++i)
          EXPECT_NEAR(values[i], expected[i], 1e-15);
      }
  }
}


TEST(LobattoBasis, ProjectsFromChildrenConservatively)
{
  for (unsigned int n = 2; n <= most_points; ++n)
  {
    const LobattoBasis basis(n);
    // Each child's integral is kept.
    for (unsigned int child = 0; child < 2; ++child)
      for (unsigned int j = 0; j < n; ++j)
      {
        double sum = 0.;
        for (unsigned int i = 0; i < n; ++i)
          sum += basis.weights()[i] * basis.from_child(child)(i, j);
        EXPECT_NEAR(sum, 0.5 * basis.weights()[j], 1e-15);
      }
    // A polynomial on the parent comes back.
    dealii::FullMatrix<double> product(n, n);
    basis.from_child(0).mmult(product, basis.to_child(0));
    basis.from_child(1).mmult(product, basis.to_child(1), true);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        EXPECT_NEAR(product(i, j), i == j ? 1. : 0., 2e-15);
    // The residual is orthogonal to all polynomials of the parent: moments of
    // a function that lives on the upper half alone.
    std::vector<double> bump(n, 0.);
    bump[n / 2] = 1.;
    const auto projected =
      multiply(basis.to_modal(), multiply(basis.from_child(1), bump));
    const auto on_child = multiply(basis.to_modal(), bump);
    EXPECT_NEAR(projected[0], 0.5 * on_child[0], 1e-15);
    // First moment: phi_1 = sqrt(3) (2 x - 1), x = 1/2 + xi/2 on the child.
    EXPECT_NEAR(projected[1],
                0.5 * (std::sqrt(3.) * 0.5 * on_child[0] + 0.5 * on_child[1]),
                1e-15);
  }
}


TEST(LobattoBasis, TransformsToOrthonormalModes)
{
  for (unsigned int n = 2; n <= most_points; ++n)
  {
    const LobattoBasis basis(n);
    const auto constant = multiply(basis.to_modal(), monomial(basis, 0));
    const auto linear = multiply(basis.to_modal(), monomial(basis, 1));
    EXPECT_NEAR(constant[0], 1., 1e-15);
    EXPECT_NEAR(linear[0], 0.5, 1e-15);
    EXPECT_NEAR(linear[1], 0.5 / std::sqrt(3.), 1e-15);
    for (unsigned int k = 1; k < n; ++k)
      EXPECT_NEAR(constant[k], 0., 1e-15);
    for (unsigned int k = 2; k < n; ++k)
      EXPECT_NEAR(linear[k], 0., 1e-15);
    // Parseval's identity for a polynomial of full degree.
    const auto modes = multiply(basis.to_modal(), monomial(basis, n - 1));
    double energy = 0.;
    for (const double mode : modes)
      energy += mode * mode;
    EXPECT_NEAR(energy, 1. / (2. * n - 1.), 1e-15);
  }
}


TEST(LobattoBasis, EvaluatesAnywhere)
{
  const LobattoBasis basis(4);
  for (const double x : {-0.2, 0., 0.31, 1., 1.4})
  {
    const std::vector<double> l = basis.values(x);
    double sum = 0., cubic = 0.;
    for (unsigned int j = 0; j < 4; ++j)
    {
      sum += l[j];
      cubic += l[j] * std::pow(basis.nodes()[j], 3.);
    }
    EXPECT_NEAR(sum, 1., 1e-14);
    EXPECT_NEAR(cubic, x * x * x, 1e-14);
  }
  EXPECT_THROW(LobattoBasis(1), InputError);
}
