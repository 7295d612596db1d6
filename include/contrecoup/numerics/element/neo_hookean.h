// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cmath>

namespace contrecoup
{
/// Strain energy functions of a neo-Hookean solid, with C = F^T F and J = det
/// F.
enum class NeoHookeanForm
{
  /// G / 2 (J^(-2/3) tr C - 3) + K / 2 (J - 1)^2, as in solid_law.h.
  split,
  /// G / 2 (tr C - 3 - 2 ln J) + lambda / 2 (ln J)^2, usual in papers on the
  /// material point method.
  coupled
};

/// A neo-Hookean solid, for exact solutions.
struct NeoHookean
{
  double density = 1000.; ///< undeformed [kg/m^3]
  double shear = 384.615; ///< G [Pa]
  double bulk = 833.333;  ///< K [Pa]; lambda is K - 2 G / 3
  NeoHookeanForm form = NeoHookeanForm::split;

  /// Strain energy per undeformed volume [J/m^3].
  /// @param squares tr C
  double energy(const double squares, const double j) const
  {
    if (form == NeoHookeanForm::split)
      return 0.5 * shear * (squares / std::cbrt(j * j) - 3.) +
             0.5 * bulk * (j - 1.) * (j - 1.);
    const double logarithm = std::log(j);
    return 0.5 * shear * (squares - 3. - 2. * logarithm) +
           0.5 * (bulk - 2. / 3. * shear) * logarithm * logarithm;
  }
};
} // namespace contrecoup
