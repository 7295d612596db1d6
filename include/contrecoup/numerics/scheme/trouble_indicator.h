// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/exponential.h>
#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/numerics/scheme/lobatto_basis.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/utilities.h>

namespace contrecoup
{
/**
 * Trouble indicator of discontinuous Galerkin cells: the blending factor with
 * a finite-volume scheme for a polynomial of degree n - 1, from the fraction
 * of energy in its highest Legendre modes, which decay fast in smooth flow
 * (Persson and Peraire 2006, with the threshold and the transition of
 * Hennemann, Rueda-Ramirez, Hindenlang and Gassner 2021, section 3.3).
 */
template <int dim>
class TroubleIndicator
{
public:
  /// @param n nodes along an edge
  /// @param threshold_factor factor on the threshold; smaller values flag more
  /// cells [-]
  explicit TroubleIndicator(const unsigned int n,
                            const double threshold_factor = 1.)
    : n_(n)
    , threshold_(threshold_factor * 0.5 *
                 std::pow(10., -1.8 * std::pow(double(n), 0.25)))
  {
    const LobattoBasis basis(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        to_modal_.push_back(basis.to_modal()(i, j));
    for (unsigned int q = 0; q < dealii::Utilities::pow(n, dim); ++q)
    {
      unsigned int degree = 0, rest = q;
      for (unsigned int d = 0; d < dim; ++d, rest /= n)
        degree = std::max(degree, rest % n);
      degree_.push_back(degree);
    }
  }

  /// 0 where the polynomial with these nodal values (x fastest) is smooth,
  /// 1 where it is not resolved. The values are overwritten; their squares
  /// must not overflow.
  template <typename Number>
  Number blending_factor(dealii::AlignedVector<Number> &values) const
  {
    transform(values);
    const Number tiny(std::numeric_limits<float>::min());
    Number highest(0.), second(0.), below(tiny);
    for (unsigned int q = 0; q < degree_.size(); ++q)
    {
      Number &sum = degree_[q] + 1 == n_   ? highest
                    : degree_[q] + 2 == n_ ? second
                                           : below;
      sum += values[q] * values[q];
    }
    // Energy fractions of the highest modes in all modes, and of the second
    // highest in those below the highest.
    below += second;
    Number energy_fraction = highest / (below + highest);
    if (n_ > 2)
      energy_fraction = std::max(energy_fraction, second / below);

    const double sharpness = std::log((1. - 1e-4) / 1e-4);
    Number alpha =
      Number(1.) /
      (Number(1.) + exponential(Number((energy_fraction - threshold_) *
                                       (-sharpness / threshold_))));
    // Clip the tails of the transition.
    alpha = select_less(alpha, Number(1e-3), Number(0.), alpha);
    return select_less(Number(1. - 1e-3), alpha, Number(1.), alpha);
  }

private:
  /// From nodal values to the coefficients of Legendre polynomials.
  template <typename Number>
  void transform(dealii::AlignedVector<Number> &values) const
  {
    std::array<Number, 16> nodal;
    for (unsigned int stride = 1; stride < degree_.size(); stride *= n_)
      for (unsigned int line = 0; line < degree_.size() / n_; ++line)
      {
        Number *const first =
          &values[line % stride + (line / stride) * stride * n_];
        for (unsigned int i = 0; i < n_; ++i)
          nodal[i] = first[i * stride];
        for (unsigned int i = 0; i < n_; ++i)
        {
          Number sum = nodal[0] * to_modal_[i * n_];
          for (unsigned int j = 1; j < n_; ++j)
            sum += nodal[j] * to_modal_[i * n_ + j];
          first[i * stride] = sum;
        }
      }
  }

  unsigned int n_;
  double threshold_;
  std::vector<double> to_modal_;
  std::vector<unsigned int> degree_; ///< largest one in any direction
};
} // namespace contrecoup
