// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/finite_volume/line.h>
#include <contrecoup/gas/finite_volume/products_slope.h>
#include <contrecoup/gas/finite_volume/velocity_slope.h>
#include <contrecoup/numerics/scheme/shear_factor.h>

/**
 * @file
 * States at the faces of a line of subcells and the Riemann fluxes between
 * them, for sweep_line().
 */

namespace contrecoup::gas
{
namespace internal
{
  template <typename Number>
  DEAL_II_ALWAYS_INLINE inline bool all_positive(const Number &x)
  {
    const Number zero(0.), one(1.);
    return !any_less(select_less(zero, x, one, zero), one);
  }

  // Not inlined: most runs use HLLC alone, and sweep_line() stays small.
  template <int dim, typename Gas, typename Number>
  __attribute__((noinline)) FaceFlux<dim, Number>
  other_flux(const RiemannFlux kind,
             const FaceState<dim, Number> &left,
             const FaceState<dim, Number> &right,
             const Number &shear_factor)
  {
    return numerical_flux(kind, left, right, shear_factor);
  }

  /// Primitive values at the low (side 0) or high face of subcell @p i.
  template <int dim, typename Gas, typename Number>
  DEAL_II_ALWAYS_INLINE inline std::array<Number, n_conserved<dim, Gas>>
  trace(const Line<Number, n_conserved<dim, Gas>> &line,
        const int i,
        const unsigned int side)
  {
    constexpr unsigned int n_linear =
      n_conserved<dim, Gas> - (Gas::has_products ? 1 : 0);
    const auto &cell = line.subcells[i];
    const auto &half = line.half_slopes[i];
    std::array<Number, n_conserved<dim, Gas>> result;
    for (unsigned int c = 0; c < n_linear; ++c)
      result[c] = side == 0 ? cell[c] - half[c] : cell[c] + half[c];
    if constexpr (Gas::has_products)
      result[Component<dim>::products] = line.end_products[i][side];
    return result;
  }

  /// State at a face of subcell @p i; the state of the subcell itself in lanes
  /// where the trace is not admissible.
  template <int dim, typename Gas, typename Number>
  __attribute__((noinline)) FaceState<dim, Number>
  restored_state(const Gas &gas,
                 const Line<Number, n_conserved<dim, Gas>> &line,
                 const int i,
                 const unsigned int side)
  {
    auto values = trace<dim, Gas>(line, i, side);
    restore_if_inadmissible<dim>(gas, line.subcells[i], values);
    return to_face_state<dim>(gas, values);
  }

  /// State at a face of subcell @p i, and what lies above the bound of
  /// admissible energy there.
  template <int dim, typename Gas, typename Number>
  DEAL_II_ALWAYS_INLINE inline FaceState<dim, Number>
  trace_state(const Gas &gas,
              const Line<Number, n_conserved<dim, Gas>> &line,
              const int i,
              const unsigned int side,
              Number &spare)
  {
    const auto values = trace<dim, Gas>(line, i, side);
    Number internal_energy;
    const FaceState<dim, Number> state =
      to_face_state<dim>(gas, values, internal_energy);
    if constexpr (Gas::has_products)
      spare =
        std::min(Number(internal_energy - gas.least_energy_density(
                                            state.density, state.products)),
                 state.density);
    return state;
  }
} // namespace internal


/// shear_factor() at face @p f, between subcells f - 1 and f.
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline Number
shear_factor_at(const Line<Number, n_conserved<dim, Gas>> &line,
                const int f,
                const int n,
                const Number &sound_speed)
{
  constexpr unsigned int normal = Component<dim>::velocity;
  return shear_factor(
    line.shock[f == 0 ? 0 : (f == n ? 2 : 1)],
    sound_speed,
    Number(line.subcells[f][normal] - line.subcells[f - 1][normal]),
    std::min(line.compression[f - 1], line.compression[f]));
}


/**
 * Finds the numerical flux through face @p f, between subcells f - 1 and f.
 *
 * @param stored_gas the gas in memory, for what few faces call
 * @param gas a copy, of which the compiler keeps the constants in registers
 */
template <int dim, typename Gas, typename SomeScheme, typename Number>
DEAL_II_ALWAYS_INLINE inline void
face_flux(const Gas &stored_gas,
          const Gas &gas,
          const Line<Number, n_conserved<dim, Gas>> &line,
          const int f,
          const int n,
          std::array<Number, n_conserved<dim, Gas>> &flux)
{
  Number left_spare, right_spare;
  FaceState<dim, Number> left =
    internal::trace_state<dim>(gas, line, f - 1, 1, left_spare);
  FaceState<dim, Number> right =
    internal::trace_state<dim>(gas, line, f, 0, right_spare);
  if constexpr (Gas::has_products)
    if (!internal::all_positive(std::min(left_spare, right_spare)))
    {
      left = internal::restored_state<dim>(stored_gas, line, f - 1, 1);
      right = internal::restored_state<dim>(stored_gas, line, f, 0);
    }
  if (line.burn != nullptr)
  {
    line.burn->template apply_burn_pressure<dim>(line.progress[f - 1], left);
    line.burn->template apply_burn_pressure<dim>(line.progress[f], right);
  }
  Number factor(1.);
  if (line.compression != nullptr)
    factor = shear_factor_at<dim, Gas>(
      line, f, n, std::max(left.sound_speed, right.sound_speed));

  if (!SomeScheme(*line.scheme).has_hllc)
  {
    const auto a = left, b = right;
    const Number c = factor;
    flux = to_array<dim, Gas>(
      internal::other_flux<dim, Gas>(line.scheme->flux, a, b, c));
  }
  else
    flux = to_array<dim, Gas>(
      numerical_flux(RiemannFlux::hllc_shock_stable, left, right, factor));

  // Faces to other leaves keep the flux that the neighbour computes too. The
  // wider a front is numerically when it leaves, the less of it comes back.
  if (line.leaving != nullptr && f > 0 && f < n && line.burn == nullptr)
  {
    const auto wide = to_array<dim, Gas>(internal::other_flux<dim, Gas>(
      RiemannFlux::rusanov,
      to_face_state<dim>(gas, line.subcells[f - 1]),
      to_face_state<dim>(gas, line.subcells[f]),
      Number(1.)));
    for (unsigned int c = 0; c < n_conserved<dim, Gas>; ++c)
      flux[c] = select_less(Number(0.), *line.leaving, wide[c], flux[c]);
  }
  if (f == 0 || f == n)
    if (const Number *hanging = line.has_hanging[f == 0 ? 0 : 1])
      for (unsigned int c = 0; c < n_conserved<dim, Gas>; ++c)
        flux[c] = select_less(Number(0.),
                              *hanging,
                              (*line.hanging_flux[f == 0 ? 0 : 1])[c],
                              flux[c]);
}
} // namespace contrecoup::gas
