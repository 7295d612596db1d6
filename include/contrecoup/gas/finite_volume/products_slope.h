// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/state/primitive.h>

namespace contrecoup::gas
{
/**
 * Replaces the mass fraction of explosive products at both ends of a cell,
 * Y - s and Y + s, such that the halves of the cell, with the densities
 * rho - r and rho + r at its ends, hold the products that the whole holds:
 *
 *   Y -+ s (1 +- r / rho) / (1 + |r| / rho).
 *
 * The outflow of a half then has its own mass fraction, and an update
 * with fluxes of mass and products is a convex mean of mass fractions
 * (Larrouturou 1991): bounded, for time steps that leave mass in each half.
 *
 * @param cell primitive state of the cell
 * @param half difference of the primitive state from the centre to the high
 * end
 */
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline std::array<Number, 2>
bounded_products(const std::array<Number, n_conserved<dim, Gas>> &cell,
                 const std::array<Number, n_conserved<dim, Gas>> &half)
{
  using C = Component<dim>;
  const Number &mean = cell[C::products];
  // Most cells have no slope.
  if (!any_less(Number(0.), Number(std::abs(half[C::products]))))
    return {{mean, mean}};
  const Number one(1.);
  const Number tilt = half[C::density] / cell[C::density];
  const Number slope = half[C::products] / (one + std::abs(tilt));
  return {{mean - slope * (one + tilt), mean + slope * (one - tilt)}};
}
} // namespace contrecoup::gas
