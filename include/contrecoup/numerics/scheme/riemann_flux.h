// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/names.h>
#include <contrecoup/numerics/scheme/hll_flux.h>

namespace contrecoup
{
/// Numerical fluxes; riemann_fluxes describes each.
enum class RiemannFlux
{
  hllc,
  hll,
  rusanov,
  hllc_shock_stable
};

/// A numerical flux and its properties, for kernels and tests.
struct RiemannFluxDescription : NamedChoice<RiemannFlux>
{
  /// Whether the flux depends on the shear_factor of numerical_flux().
  bool has_shear_factor;
  /// Whether a contact at rest stays as it is.
  bool keeps_contacts;
  /// Whether it is the flux of the upwind side in supersonic flow.
  bool is_upwind;
};

/// All fluxes. Entry, help text, kernels and tests take them from here.
inline constexpr std::array<RiemannFluxDescription, 4> riemann_fluxes{
  {{{RiemannFlux::hllc,
     "hllc",
     "keeps contacts and shear sharp, but lets disturbances of shocks along "
     "faces grow (carbuncle)"},
    false,
    true,
    true},
   {{RiemannFlux::hll, "hll", "is robust and smears contacts and shear"},
    false,
    false,
    true},
   {{RiemannFlux::rusanov, "rusanov", "is robust and smears most"},
    false,
    false,
    false},
   {{RiemannFlux::hllc_shock_stable,
     "hllc shock stable",
     "is hllc, blended with hll along shocks, where it suppresses the "
     "carbuncle"},
    true,
    true,
    true}}};

constexpr bool has_shear_factor(const RiemannFlux kind)
{
  for (const RiemannFluxDescription &flux : riemann_fluxes)
    if (flux.kind == kind)
      return flux.has_shear_factor;
  return false;
}

namespace internal
{
  /// Lane by lane, for each component: a < b ? chosen : flux.
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

  /// Lane by lane: speed < 0 ? right : left.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE FaceState<dim, Number>
  upwind_state(const Number &speed,
               const FaceState<dim, Number> &left,
               const FaceState<dim, Number> &right)
  {
    const Number zero(0.);
    FaceState<dim, Number> state;
    state.density = select_less(speed, zero, right.density, left.density);
    for (int d = 0; d < dim; ++d)
      state.velocity[d] =
        select_less(speed, zero, right.velocity[d], left.velocity[d]);
    state.pressure = select_less(speed, zero, right.pressure, left.pressure);
    state.energy_density =
      select_less(speed, zero, right.energy_density, left.energy_density);
    state.sound_speed =
      select_less(speed, zero, right.sound_speed, left.sound_speed);
    state.products = select_less(speed, zero, right.products, left.products);
    return state;
  }

  /// Positive if the state behind an outer wave of speed S = u + @p reach is
  /// admissible: S - s has the sign of S - u, and the internal energy (e + (s
  /// - u)^2 / 2 + p (s - u) / (rho (S - u))) is positive.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE Number
  middle_state_admissibility(const FaceState<dim, Number> &state,
                             const Number &contact,
                             const Number &reach)
  {
    const Number change = contact - state.velocity[0];
    Number square = change * change;
    for (int d = 0; d < dim; ++d)
      square = square - state.velocity[d] * state.velocity[d];
    const Number energy = state.energy_density + state.density * square * 0.5;
    return std::min(Number((reach - change) * reach),
                    Number((energy * reach + state.pressure * change) * reach));
  }

  /// HLLC flux (Toro, Spruce and Speares 1994), evaluated on the upwind side
  /// of the contact. With the contact speed s and the outer wave speed S of
  /// that side, the flux is w F_S + (1 - w) (0, p*, 0, p* s), where w = s / (s
  /// - S) and F_S is the flux relative to the outer wave.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE FaceFlux<dim, Number>
  hllc_flux(const FaceState<dim, Number> &left,
            const FaceState<dim, Number> &right,
            const WaveSpeeds<Number> &speeds)
  {
    const Number zero(0.), one(1.), tiny(std::numeric_limits<float>::min());

    const Number left_rate = left.density * (speeds.left - left.velocity[0]);
    const Number right_rate =
      right.density * (speeds.right - right.velocity[0]);
    const Number inverse =
      one / std::min(Number(left_rate - right_rate), Number(-tiny));
    // Relative to the mean velocity, so that equal pressures and velocities
    // reproduce that velocity exactly.
    const Number contact = (left.velocity[0] + right.velocity[0]) * 0.5 +
                           ((right.pressure - left.pressure) -
                            (right.velocity[0] - left.velocity[0]) *
                              ((left_rate + right_rate) * 0.5)) *
                             inverse;

    const FaceState<dim, Number> side = upwind_state(contact, left, right);
    const Number normal = side.velocity[0];
    const Number rate = select_less(contact, zero, right_rate, left_rate);
    const Number bow = select_less(contact, zero, speeds.right, speeds.left);
    const Number outer = select_less(
      contact, zero, std::max(bow, tiny), std::min(bow, Number(-tiny)));

    const Number middle = side.pressure + rate * (contact - normal);
    const Number weight = contact / (contact - outer);
    const Number rest = one - weight;
    const Number relative = normal - outer;

    FaceFlux<dim, Number> flux;
    flux.mass = weight * (side.density * relative);
    for (int d = 0; d < dim; ++d)
      flux.momentum[d] = flux.mass * side.velocity[d];
    flux.momentum[0] =
      flux.momentum[0] + (weight * side.pressure + rest * middle);
    flux.energy =
      weight * (side.energy_density * relative + side.pressure * normal) +
      rest * (middle * contact);
    flux.products = flux.mass * side.products;

    const Number soundness =
      middle_state_admissibility(side, contact, Number(bow - normal));
    if (!all_greater(soundness, zero))
    {
      const FaceFlux<dim, Number> hllc = flux;
      flux = hll_flux(left, right, speeds);
      replace_where_less(zero, soundness, hllc, flux);
    }
    return flux;
  }

  /// flux + (1 - hllc_weight) (other - flux); exact if both fluxes are equal
  /// or the weight is 1.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE void blend(const Number &hllc_weight,
                                          const FaceFlux<dim, Number> &other,
                                          FaceFlux<dim, Number> &flux)
  {
    const Number rest = Number(1.) - hllc_weight;
    flux.mass = flux.mass + rest * (other.mass - flux.mass);
    for (int d = 0; d < dim; ++d)
      flux.momentum[d] =
        flux.momentum[d] + rest * (other.momentum[d] - flux.momentum[d]);
    flux.energy = flux.energy + rest * (other.energy - flux.energy);
    flux.products = flux.products + rest * (other.products - flux.products);
  }
} // namespace internal

/**
 * Numerical flux through a face between two gases with any convex equation of
 * state, from left to right.
 *
 * For equal states at rest the flux is exactly (0, p, 0, 0); HLLC gives the
 * same at a stationary contact, for any densities. A vacuum on a side (rho = p
 * = c = 0) is allowed. HLLC falls back to HLL in lanes with an inadmissible
 * middle state.
 *
 * @param shear_factor for fluxes that have one: weight of HLLC in [0, 1]
 * from shear_factor(); the rest is HLL. 1 is bitwise HLLC.
 */
template <int dim, typename Number>
inline DEAL_II_ALWAYS_INLINE FaceFlux<dim, Number>
numerical_flux(const RiemannFlux kind,
               const FaceState<dim, Number> &left,
               const FaceState<dim, Number> &right,
               const Number &shear_factor)
{
  const WaveSpeeds<Number> speeds = wave_speeds(left, right);
  if (kind == RiemannFlux::hll)
    return internal::hll_flux(left, right, speeds);
  if (kind == RiemannFlux::rusanov)
    return internal::rusanov_flux(left, right, speeds);

  FaceFlux<dim, Number> flux = internal::hllc_flux(left, right, speeds);
  if (kind == RiemannFlux::hllc_shock_stable &&
      any_less(shear_factor, Number(1.)))
    internal::blend(
      shear_factor, internal::hll_flux(left, right, speeds), flux);
  return flux;
}
} // namespace contrecoup
