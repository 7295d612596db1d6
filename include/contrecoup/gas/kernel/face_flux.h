// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/kernel/line.h>
#include <contrecoup/gas/kernel/products_slope.h>
#include <contrecoup/gas/kernel/velocity_slope.h>
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

  // What few lines need stays out of the pass that all others take.
  template <int dim, typename Gas, typename Number>
  __attribute__((noinline)) FaceFlux<dim, Number>
  other_flux(const RiemannFlux kind,
             const FaceState<dim, Number> &left,
             const FaceState<dim, Number> &right)
  {
    return numerical_flux(kind, left, right, Number(1.));
  }

  template <int dim, typename Gas, typename Number>
  __attribute__((noinline)) void
  bound_velocity(const Gas &gas,
                 const std::array<Number, n_conserved<dim, Gas>> &cell,
                 std::array<Number, n_conserved<dim, Gas>> &half)
  {
    limit_velocity_slope<dim>(gas, cell, half);
  }

  /// State of the subcell itself in lanes where the trace is not admissible.
  template <int dim, typename Gas, typename Number>
  __attribute__((noinline)) FaceState<dim, Number>
  restored_state(const Gas &gas,
                 const std::array<Number, n_conserved<dim, Gas>> &cell,
                 std::array<Number, n_conserved<dim, Gas>> trace)
  {
    restore_if_inadmissible<dim>(gas, cell, trace);
    return to_face_state<dim>(gas, trace);
  }
} // namespace internal


/**
 * State at a face from the trace of the reconstruction in the subcell @p cell;
 * the state of the subcell itself where the trace would hold less energy than
 * the cold gas.
 */
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline FaceState<dim, Number>
trace_state(const Gas &gas,
            const std::array<Number, n_conserved<dim, Gas>> &cell,
            const std::array<Number, n_conserved<dim, Gas>> &trace)
{
  using C = Component<dim>;
  Number internal_energy;
  FaceState<dim, Number> state =
    to_face_state<dim>(gas, trace, internal_energy);
  if constexpr (Gas::has_products)
  {
    const Number spare =
      internal_energy -
      gas.cold_energy_density(trace[C::density], trace[C::products]);
    if (!internal::all_positive(std::min(spare, trace[C::density])))
    {
      const auto own = cell;
      state = internal::restored_state<dim>(gas, own, trace);
    }
  }
  return state;
}


/// Traces at the low and high face of a subcell; see bound_products().
/// @param half difference of the primitive values from the centre to the high
/// face
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline void
find_traces(const std::array<Number, n_conserved<dim, Gas>> &cell,
            const std::array<Number, n_conserved<dim, Gas>> &half,
            std::array<Number, n_conserved<dim, Gas>> &low,
            std::array<Number, n_conserved<dim, Gas>> &high)
{
  for (unsigned int c = 0; c < n_conserved<dim, Gas>; ++c)
  {
    low[c] = cell[c] - half[c];
    high[c] = cell[c] + half[c];
  }
  if constexpr (Gas::has_products)
    if (any_less(Number(0.), Number(std::abs(half[Component<dim>::products]))))
      bound_products<dim, Gas>(cell, half, low, high);
}


/// Share of HLLC in the flux through face @p f, for
/// RiemannFlux::hllc_shock_stable; see shear_factor().
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline Number
share_of_hllc(const Line<Number, n_conserved<dim, Gas>> &line,
              const int f,
              const int n,
              const Number &sound_speed)
{
  constexpr unsigned int normal = Component<dim>::momentum;
  const Number &shock = line.shock[f == 0 ? 0 : (f == n ? 2 : 1)];
  const Number factor = shear_factor(
    sound_speed,
    Number(line.subcells[f][normal] - line.subcells[f - 1][normal]),
    std::min(line.compression[f - 1], line.compression[f]));
  return select_less(Number(0.), shock, factor, Number(1.));
}


/// Numerical flux through face @p f, between subcells f - 1 and f.
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline std::array<Number, n_conserved<dim, Gas>>
face_flux(const Gas &gas,
          const Line<Number, n_conserved<dim, Gas>> &line,
          const int f,
          const int n,
          FaceState<dim, Number> left,
          FaceState<dim, Number> right)
{
  if (line.burn != nullptr)
  {
    line.burn->template apply_burn_pressure<dim>(line.progress[f - 1], left);
    line.burn->template apply_burn_pressure<dim>(line.progress[f], right);
  }
  Number share(1.);
  if (line.compression != nullptr)
    share = share_of_hllc<dim, Gas>(
      line, f, n, std::max(left.sound_speed, right.sound_speed));

  const RiemannFlux kind = line.scheme->flux;
  std::array<Number, n_conserved<dim, Gas>> flux;
  if (kind == RiemannFlux::hllc || kind == RiemannFlux::hllc_shock_stable)
    flux = to_array<dim, Gas>(
      numerical_flux(RiemannFlux::hllc_shock_stable, left, right, share));
  else
  {
    const auto a = left, b = right;
    flux = to_array<dim, Gas>(internal::other_flux<dim, Gas>(kind, a, b));
  }

  // Faces to other leaves keep the flux that the neighbour computes too. The
  // wider a front is numerically when it leaves, the less of it comes back.
  if (line.leaving != nullptr && f > 0 && f < n && line.burn == nullptr)
  {
    const auto wide = to_array<dim, Gas>(internal::other_flux<dim, Gas>(
      RiemannFlux::rusanov,
      to_face_state<dim>(gas, line.subcells[f - 1]),
      to_face_state<dim>(gas, line.subcells[f])));
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
  return flux;
}
} // namespace contrecoup::gas
