// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

namespace contrecoup
{
/// Artificial bulk viscosity in compression (von Neumann, Landshoff).
template <typename Number>
struct BulkViscosity
{
  Number linear;       ///< c_2 rho c [Pa s/m]
  Number quadratic;    ///< c_1 rho [kg/m^3]
  Number inverse_step; ///< inverse of the size of the last step [1/s]

  /// Viscous pressure [Pa] for a change of dilatation in the last step, in an
  /// element of this length [m].
  DEAL_II_ALWAYS_INLINE Number pressure(const Number &change,
                                        const Number &length) const
  {
    const Number speed =
      length * inverse_step * select_less(change, Number(), change, Number());
    return speed * (quadratic * speed - linear);
  }
};
} // namespace contrecoup
