// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/scheme/wave_speeds.h>

#include <array>
#include <limits>

namespace contrecoup
{
/// Flux through a face per area and time, in face coordinates.
template <int dim, typename Number>
struct FaceFlux
{
  Number mass;                      ///< [kg/(m^2 s)]
  std::array<Number, dim> momentum; ///< [0] normal, others tangential [Pa]
  Number energy;                    ///< [W/m^2]
  Number products;                  ///< rho Y u [kg/(m^2 s)]
};

namespace internal
{
  /// Flux of the Euler equations.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE FaceFlux<dim, Number>
  euler_flux(const FaceState<dim, Number> &state)
  {
    FaceFlux<dim, Number> flux;
    flux.mass = state.density * state.velocity[0];
    for (int d = 0; d < dim; ++d)
      flux.momentum[d] = flux.mass * state.velocity[d];
    flux.momentum[0] = flux.momentum[0] + state.pressure;
    flux.energy = (state.energy_density + state.pressure) * state.velocity[0];
    flux.products = flux.mass * state.products;
    return flux;
  }

  /// (F_L + F_R)/2 + bias (F_L - F_R) + viscosity (U_L - U_R): exact at rest.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE FaceFlux<dim, Number>
  blended_flux(const FaceState<dim, Number> &left,
               const FaceState<dim, Number> &right,
               const Number &bias,
               const Number &viscosity)
  {
    const FaceFlux<dim, Number> a = euler_flux(left);
    const FaceFlux<dim, Number> b = euler_flux(right);

    const auto blend =
      [&](const Number &flux_a, const Number &flux_b, const Number &jump) {
        return (flux_a + flux_b) * 0.5 +
               (bias * (flux_a - flux_b) + viscosity * jump);
      };
    FaceFlux<dim, Number> flux;
    flux.mass = blend(a.mass, b.mass, left.density - right.density);
    for (int d = 0; d < dim; ++d)
      flux.momentum[d] = blend(a.momentum[d],
                               b.momentum[d],
                               left.density * left.velocity[d] -
                                 right.density * right.velocity[d]);
    flux.energy =
      blend(a.energy, b.energy, left.energy_density - right.energy_density);
    flux.products =
      blend(a.products,
            b.products,
            left.density * left.products - right.density * right.products);
    return flux;
  }

  /// HLL flux of Harten, Lax and van Leer (1983) between two wave speeds.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE FaceFlux<dim, Number>
  hll_flux(const FaceState<dim, Number> &left,
           const FaceState<dim, Number> &right,
           const WaveSpeeds<Number> &speeds)
  {
    const Number tiny(std::numeric_limits<float>::min());
    const Number lowest = std::min(speeds.left, Number(-tiny));
    const Number highest = std::max(speeds.right, tiny);
    const Number inverse = Number(1.) / (highest - lowest);
    return blended_flux(left,
                        right,
                        Number((highest + lowest) * inverse * 0.5),
                        Number(-(lowest * highest) * inverse));
  }

  /// Rusanov flux (1961): the largest wave speed as viscosity.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE FaceFlux<dim, Number>
  rusanov_flux(const FaceState<dim, Number> &left,
               const FaceState<dim, Number> &right,
               const WaveSpeeds<Number> &speeds)
  {
    const Number fastest =
      std::max(std::abs(speeds.left), std::abs(speeds.right));
    return blended_flux(left, right, Number(0.), Number(fastest * 0.5));
  }
} // namespace internal
} // namespace contrecoup
