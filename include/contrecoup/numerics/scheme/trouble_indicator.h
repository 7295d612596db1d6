// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/exponential.h>
#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/numerics/scheme/lobatto_basis.h>

#include <deal.II/base/utilities.h>

#include <array>

namespace contrecoup
{
/**
 * Trouble indicator of discontinuous Galerkin cells: the blending factor with
 * a finite-volume scheme for a polynomial of degree n - 1, from the fraction
 * of energy in its highest Legendre modes, which decay fast in smooth flow
 * (Persson and Peraire 2006, with the threshold and the transition of
 * Hennemann, Rueda-Ramirez, Hindenlang and Gassner 2021, section 3.3).
 */
template <int dim, int n>
class TroubleIndicator
{
public:
  static constexpr unsigned int n_points = dealii::Utilities::pow(n, dim);

  /// @param threshold_factor factor on the threshold; smaller values flag more
  /// cells [-]
  explicit TroubleIndicator(const LobattoBasis &basis,
                            const double threshold_factor = 1.)
    : threshold_(threshold_factor * 0.5 *
                 std::pow(10., -1.8 * std::pow(double(n), 0.25)))
  {
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        to_modal_[i][j] = basis.to_modal()(i, j);
  }

  /// 0 if the polynomial with these nodal values (x fastest) is smooth, 1 if
  /// it is not resolved.
  template <typename Number>
  Number blending_factor(std::array<Number, n_points> values) const
  {
    transform(values);
    std::array<Number, n> energy; // by the largest degree in any direction
    energy.fill(Number(0.));
    for (unsigned int q = 0; q < n_points; ++q)
    {
      unsigned int degree = 0, rest = q;
      for (unsigned int d = 0; d < dim; ++d, rest /= n)
        degree = std::max(degree, rest % n);
      energy[degree] += values[q] * values[q];
    }
    const Number tiny(std::numeric_limits<float>::min());
    Number below = tiny;
    for (unsigned int i = 0; i + 1 < n; ++i)
      below += energy[i];
    Number energy_fraction = energy[n - 1] / (below + energy[n - 1]);
    if (n > 2)
      energy_fraction = std::max(energy_fraction, energy[n - 2] / below);

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
  template <typename Number>
  void transform(std::array<Number, n_points> &values) const
  {
    unsigned int stride = 1;
    for (unsigned int d = 0; d < dim; ++d, stride *= n)
      for (unsigned int line = 0; line < n_points / n; ++line)
      {
        const unsigned int first = line % stride + (line / stride) * stride * n;
        std::array<Number, n> nodal;
        for (unsigned int i = 0; i < n; ++i)
          nodal[i] = values[first + i * stride];
        for (unsigned int i = 0; i < n; ++i)
        {
          Number sum = nodal[0] * to_modal_[i][0];
          for (unsigned int j = 1; j < n; ++j)
            sum += nodal[j] * to_modal_[i][j];
          values[first + i * stride] = sum;
        }
      }
  }

  const double threshold_;
  std::array<std::array<double, n>, n> to_modal_;
};
} // namespace contrecoup
