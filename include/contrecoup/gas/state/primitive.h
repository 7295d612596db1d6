// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/state/gas_state.h>
#include <contrecoup/numerics/scheme/riemann_flux.h>

#include <array>

namespace contrecoup::gas
{
/// Number of conserved quantities of a gas: density, momentum, total energy
/// and, for a mixture, the density of explosive products.
template <int dim, typename Gas>
inline constexpr unsigned int n_conserved = dim + 2 +
                                            (Gas::has_products ? 1 : 0);

/// Indices in an array of conserved quantities or of their fluxes, or of
/// primitive quantities, which have velocity and pressure (and the mass
/// fraction of products) in the same places.
template <int dim>
struct Component
{
  static constexpr unsigned int density = 0;
  static constexpr unsigned int momentum = 1;
  static constexpr unsigned int velocity = momentum;
  static constexpr unsigned int energy = dim + 1;
  static constexpr unsigned int pressure = energy;
  static constexpr unsigned int products = dim + 2;
};

/**
 * Converts conserved to primitive quantities (density, velocity, pressure,
 * mass fraction of products); arrays of n_conserved values each.
 */
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline std::array<Number, n_conserved<dim, Gas>>
to_primitive(const Gas &gas, const std::array<Number, n_conserved<dim, Gas>> &u)
{
  using C = Component<dim>;
  std::array<Number, n_conserved<dim, Gas>> p;
  const Number inverse_density = Number(1.) / u[C::density];
  p[C::density] = u[C::density];
  Number kinetic(0.);
  for (unsigned int d = 0; d < dim; ++d)
  {
    p[C::velocity + d] = u[C::momentum + d] * inverse_density;
    kinetic += p[C::velocity + d] * u[C::momentum + d];
  }
  Number products(0.);
  if constexpr (Gas::has_products)
    products = p[C::products] = u[C::products] * inverse_density;
  p[C::pressure] =
    gas.pressure(u[C::density], Number(u[C::energy] - kinetic * 0.5), products);
  return p;
}

/// Converts primitive quantities to an argument of a Riemann flux, and to the
/// internal energy per volume rho e [J/m^3]. The velocity must be in the frame
/// of the face (normal component first).
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline FaceState<dim, Number>
to_face_state(const Gas &gas,
              const std::array<Number, n_conserved<dim, Gas>> &p,
              Number &internal_energy_density)
{
  using C = Component<dim>;
  FaceState<dim, Number> state;
  state.density = p[C::density];
  Number square(0.);
  for (unsigned int d = 0; d < dim; ++d)
  {
    state.velocity[d] = p[C::velocity + d];
    square += state.velocity[d] * state.velocity[d];
  }
  state.pressure = p[C::pressure];
  if constexpr (Gas::has_products)
    state.products = p[C::products];
  else
    state.products = Number(0.);
  Number sound_speed_squared;
  gas.energy_and_sound_speed(state.density,
                             state.pressure,
                             state.products,
                             internal_energy_density,
                             sound_speed_squared);
  state.energy_density = internal_energy_density + state.density * square * 0.5;
  state.sound_speed = std::sqrt(std::max(sound_speed_squared, Number(0.)));
  return state;
}

/// Converts primitive quantities to an argument of a Riemann flux alone.
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline FaceState<dim, Number>
to_face_state(const Gas &gas,
              const std::array<Number, n_conserved<dim, Gas>> &p)
{
  Number internal_energy_density;
  return to_face_state<dim>(gas, p, internal_energy_density);
}

/// Converts a flux to an array of n_conserved values, in the frame of the
/// face.
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline std::array<Number, n_conserved<dim, Gas>>
to_array(const FaceFlux<dim, Number> &flux)
{
  using C = Component<dim>;
  std::array<Number, n_conserved<dim, Gas>> f;
  f[C::density] = flux.mass;
  for (unsigned int d = 0; d < dim; ++d)
    f[C::momentum + d] = flux.momentum[d];
  f[C::energy] = flux.energy;
  if constexpr (Gas::has_products)
    f[C::products] = flux.products;
  return f;
}

/**
 * Component at index @p i in the frame of a face with normal direction @p
 * direction: velocity components rotate cyclically, all others stay.
 */
template <int dim>
DEAL_II_ALWAYS_INLINE inline constexpr unsigned int
rotated_component(const unsigned int i, const unsigned int direction)
{
  return i == 0 || i > dim ? i : 1 + (direction + i - 1) % dim;
}

/// Internal energy above the least admissible one [J/m^3]; but for JWL with B <
/// 0 concave in the conserved quantities where the density is positive.
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline Number
spare_energy(const Gas &gas, const std::array<Number, n_conserved<dim, Gas>> &u)
{
  using C = Component<dim>;
  Number kinetic(0.);
  for (unsigned int d = 0; d < dim; ++d)
    kinetic += u[C::momentum + d] * u[C::momentum + d];
  const Number inverse_density = Number(1.) / u[C::density];
  Number products(0.);
  if constexpr (Gas::has_products)
    products = u[C::products] * inverse_density;
  return u[C::energy] - kinetic * inverse_density * 0.5 -
         gas.least_energy_density(u[C::density], products);
}

/// One for a conserved state with positive density and with more internal
/// energy than the least admissible one, else zero (also for NaN).
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline Number
is_admissible(const Gas &gas,
              const std::array<Number, n_conserved<dim, Gas>> &u)
{
  const Number zero(0.), one(1.);
  return select_less(zero,
                     u[Component<dim>::density],
                     select_less(zero, spare_energy<dim>(gas, u), one, zero),
                     zero);
}

/// Replaces the reconstructed primitive state @p trace by the subcell's mean
/// @p cell where @p trace has less energy than is admissible or no positive
/// density.
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline void
restore_if_inadmissible(const Gas &gas,
                        const std::array<Number, n_conserved<dim, Gas>> &cell,
                        std::array<Number, n_conserved<dim, Gas>> &trace)
{
  using C = Component<dim>;
  const Number zero(0.);
  Number products(0.);
  if constexpr (Gas::has_products)
    products = trace[C::products];
  const Number spare = gas.internal_energy_density(
                         trace[C::density], trace[C::pressure], products) -
                       gas.least_energy_density(trace[C::density], products);
  for (unsigned int c = 0; c < n_conserved<dim, Gas>; ++c)
    trace[c] =
      select_less(zero, std::min(spare, trace[C::density]), trace[c], cell[c]);
}

/// sum_d (|u_d| + c) / h_d [1/s] of a primitive state, with a sound speed c
/// of at least @p least_sound_speed.
template <int dim, typename Gas, typename Number>
DEAL_II_ALWAYS_INLINE inline Number
signal_rate(const Gas &gas,
            const std::array<Number, n_conserved<dim, Gas>> &p,
            const std::array<Number, dim> &extents,
            const Number &least_sound_speed = Number(0.))
{
  using C = Component<dim>;
  Number products(0.);
  if constexpr (Gas::has_products)
    products = p[C::products];
  const Number sound_speed = std::sqrt(
    std::max(gas.sound_speed_squared(p[C::density], p[C::pressure], products),
             least_sound_speed * least_sound_speed));
  Number rate(0.);
  for (unsigned int d = 0; d < dim; ++d)
    rate += (std::abs(p[C::velocity + d]) + sound_speed) / extents[d];
  return rate;
}
} // namespace contrecoup::gas
