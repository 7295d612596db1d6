// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/wave_speeds.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// Flux through a face, along its normal, per area and time.
template <int dim, typename Number>
struct FaceFlux
{
  Number mass;                      ///< [kg/(m^2 s)]
  std::array<Number, dim> momentum; ///< [Pa], [0] normal, rest tangential
  Number energy;                    ///< [W/m^2]
  Number products;                  ///< rho Y u [kg/(m^2 s)]
};

/// The numerical fluxes to choose from.
enum class RiemannFlux
{
  hllc,
  hll,
  rusanov,
  hllc_shock_stable
};

/// All names of fluxes.
std::vector<std::string> riemann_flux_names();

/// The flux of this name. @throws InputError when there is none.
RiemannFlux parse_riemann_flux(const std::string &name);

namespace internal
{
  /// The flux of the Euler equations.
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

  /// (F_L + F_R)/2 + lean (F_L - F_R) + viscosity (U_L - U_R): exact at
  /// rest, and mirrored exactly when the states are.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE FaceFlux<dim, Number>
  blended_flux(const FaceState<dim, Number> &left,
               const FaceState<dim, Number> &right,
               const Number &lean,
               const Number &viscosity)
  {
    const FaceFlux<dim, Number> a = euler_flux(left);
    const FaceFlux<dim, Number> b = euler_flux(right);

    const auto blend =
      [&](const Number &flux_a, const Number &flux_b, const Number &jump) {
        return (flux_a + flux_b) * 0.5 +
               (lean * (flux_a - flux_b) + viscosity * jump);
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

  /// Harten, Lax and van Leer (1983) between two wave speeds.
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

  /// Rusanov (1961): the largest wave speed as viscosity.
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

  /// Lane by lane a < b ? chosen : flux, for each component.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE void
  replace_where_less(const Number &a,
                     const Number &b,
                     const FaceFlux<dim, Number> &chosen,
                     FaceFlux<dim, Number> &flux)
  {
    flux.mass = select_less(a, b, chosen.mass, flux.mass);
    for (int d = 0; d < dim; ++d)
      flux.momentum[d] =
        select_less(a, b, chosen.momentum[d], flux.momentum[d]);
    flux.energy = select_less(a, b, chosen.energy, flux.energy);
    flux.products = select_less(a, b, chosen.products, flux.products);
  }

  /// HLLC (Toro, Spruce and Speares 1994), written for the one side that the
  /// contact leaves the face in. With the contact speed s and the outer
  /// speed S of that side, the flux is w F_S + (1 - w) (0, p*, 0, p* s) with
  /// w = s / (s - S) and F_S the flux relative to the outer wave.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE FaceFlux<dim, Number>
  hllc_flux(const FaceState<dim, Number> &left,
            const FaceState<dim, Number> &right,
            const WaveSpeeds<Number> &speeds,
            const Number &shear_factor)
  {
    const Number zero(0.), one(1.), tiny(std::numeric_limits<float>::min());

    const Number left_rate = left.density * (speeds.left - left.velocity[0]);
    const Number right_rate =
      right.density * (speeds.right - right.velocity[0]);
    const Number inverse =
      one / std::min(Number(left_rate - right_rate), Number(-tiny));
    const Number plain_contact =
      ((right.pressure - right_rate * right.velocity[0]) -
       (left.pressure - left_rate * left.velocity[0])) *
      inverse;
    const Number contact = plain_contact - (one - shear_factor) *
                                             (right.pressure - left.pressure) *
                                             inverse;

    const auto pick = [&](const Number &from_left, const Number &from_right) {
      return select_less(contact, zero, from_right, from_left);
    };
    const Number density = pick(left.density, right.density);
    const Number normal = pick(left.velocity[0], right.velocity[0]);
    const Number pressure = pick(left.pressure, right.pressure);
    const Number energy = pick(left.energy_density, right.energy_density);
    const Number rate = pick(left_rate, right_rate);
    const Number outer =
      pick(std::min(speeds.left, Number(-tiny)), std::max(speeds.right, tiny));

    const Number middle = pressure + rate * (plain_contact - normal);
    const Number weight = contact / (contact - outer);
    const Number rest = one - weight;
    const Number relative = normal - outer;

    FaceFlux<dim, Number> flux;
    flux.mass = weight * (density * relative);
    flux.momentum[0] = flux.mass * normal + weight * pressure + rest * middle;
    for (int d = 1; d < dim; ++d)
      flux.momentum[d] = flux.mass * pick(left.velocity[d], right.velocity[d]);
    flux.energy = weight * (energy * relative + pressure * normal) +
                  rest * (middle * contact);
    flux.products = flux.mass * pick(left.products, right.products);

    // Both the order of the waves and the internal energy behind the outer
    // one must hold: S - s has the sign of S - u, and, without divisions,
    // (rho e + rho (s - u)^2 / 2) (S - u)^2 + p (s - u) (S - u) > 0.
    const Number reach = pick(speeds.left, speeds.right) - normal;
    const Number change = contact - normal;
    Number heat = energy + density * (change * change) * 0.5;
    for (int d = 0; d < dim; ++d)
    {
      const Number velocity = pick(left.velocity[d], right.velocity[d]);
      heat = heat - density * (velocity * velocity) * 0.5;
    }
    const Number sound =
      std::min(Number((reach - change) * reach),
               Number((heat * reach + pressure * change) * reach));
    if (!all_greater(sound, zero))
    {
      const FaceFlux<dim, Number> hllc = flux;
      flux = hll_flux(left, right, speeds);
      replace_where_less(zero, sound, hllc, flux);
    }
    return flux;
  }
} // namespace internal

/**
 * Numerical flux through a face between two gases of any convex equation of
 * state, from the left to the right one.
 *
 * At rest (equal states without velocity) it is exactly (0, p, 0, 0); HLLC
 * gives the same at a contact at rest, whatever the densities. A vacuum on a
 * side (rho = p = c = 0) is allowed. HLLC falls back to HLL in the lanes
 * where its middle state is inadmissible.
 *
 * @param shear_factor used by hllc_shock_stable alone: theta in [0, 1] of
 * Minoshima and Miyoshi (2021), see shear_factor(), which multiplies the
 * pressure difference in the contact speed; 1 gives HLLC to the last bit.
 */
template <int dim, typename Number>
inline DEAL_II_ALWAYS_INLINE FaceFlux<dim, Number>
numerical_flux(const RiemannFlux kind,
               const FaceState<dim, Number> &left,
               const FaceState<dim, Number> &right,
               const Number &shear_factor)
{
  const WaveSpeeds<Number> speeds = wave_speeds(left, right);
  switch (kind)
  {
    case RiemannFlux::hll:
      return internal::hll_flux(left, right, speeds);
    case RiemannFlux::rusanov:
      return internal::rusanov_flux(left, right, speeds);
    case RiemannFlux::hllc:
      return internal::hllc_flux(left, right, speeds, Number(1.));
    case RiemannFlux::hllc_shock_stable:
    default:
      return internal::hllc_flux(left, right, speeds, shear_factor);
  }
}
} // namespace contrecoup
