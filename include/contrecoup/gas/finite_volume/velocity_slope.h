// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/state/primitive.h>

namespace contrecoup::gas
{
/**
 * Energy left by velocity differences of a reconstruction: with the states
 * u +- s at the ends of a cell its middle is left with the internal energy
 *
 *   rho (e - e_least) - rho |s|^2 (1 + (s_rho / rho)^2) / 2
 *
 * per volume, at least this function's result (Berthon 2005 and Waagan 2009
 * bound slopes this way). Where it is positive, fluxes cannot draw more
 * energy from the cell than it has.
 *
 * @param cell primitive state of the cell
 * @param s_square |s|^2 [m^2/s^2]
 */
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline Number
energy_left(const Gas &gas,
            const std::array<Number, n_conserved<dim, Gas>> &cell,
            const Number &s_square)
{
  using C = Component<dim>;
  Number products(0.);
  if constexpr (Gas::has_products)
    products = cell[C::products];
  return gas.internal_energy_density(
           cell[C::density], cell[C::pressure], products) -
         gas.least_energy_density(cell[C::density], products) -
         cell[C::density] * s_square;
}


/**
 * Scales the velocity in @p half, the difference of the primitive state
 * between a face and the centre of a cell, where energy_left() would be
 * negative.
 */
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline void
limit_velocity_slope(const Gas &gas,
                     const std::array<Number, n_conserved<dim, Gas>> &cell,
                     std::array<Number, n_conserved<dim, Gas>> &half)
{
  using C = Component<dim>;
  const Number zero(0.), one(1.);
  Number square(0.);
  for (unsigned int d = 0; d < dim; ++d)
    square += half[C::velocity + d] * half[C::velocity + d];
  const Number kinetic = cell[C::density] * square;
  // Cold curves are costly, and most cells are far from the bound.
  if (Gas::has_products && !any_less(cell[C::pressure], Number(kinetic * 16.)))
    return;
  const Number left = energy_left<dim>(gas, cell, square);
  if (!any_less(left, zero))
    return;
  const Number factor = select_less(
    left,
    zero,
    std::sqrt(std::max(Number(left + kinetic), zero) /
              std::max(kinetic, Number(std::numeric_limits<float>::min()))),
    one);
  for (unsigned int d = 0; d < dim; ++d)
    half[C::velocity + d] = half[C::velocity + d] * factor;
}
} // namespace contrecoup::gas
