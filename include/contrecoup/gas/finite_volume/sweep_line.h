// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/finite_volume/face_flux.h>
#include <contrecoup/gas/finite_volume/line_faces.h>

/**
 * @file
 * The finite-volume scheme along one line of subcells: limited linear
 * reconstruction (van Leer 1979), a Riemann flux at each face, and what the
 * fluxes change in the subcells.
 */

namespace contrecoup::gas
{
/// Any scheme; slopes are zero where it is of first order.
struct AnyScheme
{
  explicit AnyScheme(const Scheme &scheme)
    : limiter(scheme.limiter)
    , linear_reconstruction(scheme.linear_reconstruction)
    , has_hllc(scheme.flux == RiemannFlux::hllc ||
               scheme.flux == RiemannFlux::hllc_shock_stable)
  {}

  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number half_slope(const Number &backward,
                                          const Number &forward) const
  {
    return linear_reconstruction
             ? limited_slope(limiter, backward, forward) * 0.5
             : Number(0.);
  }

  SlopeLimiter limiter;
  bool linear_reconstruction;
  /// Whether the flux is computed as hllc_shock_stable with a shear factor,
  /// which is one for plain HLLC; other fluxes come from other_flux().
  bool has_hllc;
};

/// The scheme of scenes, known when the kernel is compiled: slopes of the
/// monotonised central difference, HLLC.
struct FixedScheme
{
  static constexpr bool has_hllc = true;

  static bool is(const Scheme &scheme)
  {
    return scheme.linear_reconstruction && scheme.limiter == SlopeLimiter::mc &&
           AnyScheme(scheme).has_hllc;
  }

  explicit FixedScheme(const Scheme &)
  {}

  /// Half of limited_slope(SlopeLimiter::mc, ...), to the last bit, in nine
  /// operations in place of fourteen.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number half_slope(const Number &backward,
                                          const Number &forward) const
  {
    const Number zero(0.);
    const Number central = (backward + forward) * 0.25;
    const Number least = std::min(std::min(backward, forward), central);
    const Number largest = std::max(std::max(backward, forward), central);
    return std::max(zero, least) + std::min(zero, largest);
  }
};


/// Bounds the velocity in the half slopes of a line.
template <int dim, typename Gas, typename Number>
__attribute__((noinline)) void
bound_velocities(const Gas &gas,
                 const Line<Number, n_conserved<dim, Gas>> &line)
{
  for (int i = -1; i <= int(line.n); ++i)
    limit_velocity_slope<dim>(gas, line.subcells[i], line.half_slopes[i]);
}


/// Finds the differences of the primitive values between the centres of the
/// subcells -1 to @p n and their high faces, and the mass fractions of products
/// at both faces of each.
template <int dim,
          typename Gas,
          typename SomeScheme,
          typename Number,
          typename Faces>
DEAL_II_ALWAYS_INLINE inline void
reconstruct(const Gas &gas,
            const Line<Number, n_conserved<dim, Gas>> &line,
            const Faces &faces,
            const int n)
{
  constexpr unsigned int nc = n_conserved<dim, Gas>;
  using Values = std::array<Number, nc>;
  const SomeScheme scheme(*line.scheme);
  const Values *cells = line.subcells;
  Values *half = line.half_slopes;

  Values backward;
  for (unsigned int c = 0; c < nc; ++c)
    backward[c] = cells[-1][c] - cells[-2][c];
  if constexpr (Faces::closes_slopes)
    for (unsigned int c = 0; c < nc; ++c)
      backward[c] *= faces.is_open(-1, n);
  for (int i = -1; i <= n; ++i)
  {
    Number open(1.);
    if constexpr (Faces::closes_slopes)
      open = faces.is_open(i + 1, n);
    for (unsigned int c = 0; c < nc; ++c)
    {
      Number forward = cells[i + 1][c] - cells[i][c];
      if constexpr (Faces::closes_slopes)
        forward *= open;
      half[i][c] = scheme.half_slope(backward[c], forward);
      backward[c] = forward;
    }
  }
  if (line.bounds_velocity)
    bound_velocities<dim>(gas, line);
  if constexpr (Gas::has_products)
    for (int i = -1; i <= n; ++i)
      line.end_products[i] = bounded_products<dim, Gas>(cells[i], half[i]);
}


/// Adds what the fluxes through the low and high face of subcell @p i change in
/// it to its rates.
/// @param rates of each component of the line's frame in that subcell
template <int dim, typename Gas, typename Number, typename Faces>
DEAL_II_ALWAYS_INLINE inline void
add_rates(const Line<Number, n_conserved<dim, Gas>> &line,
          const Faces &faces,
          const unsigned int i,
          const std::array<Number, n_conserved<dim, Gas>> &low,
          const std::array<Number, n_conserved<dim, Gas>> &high,
          const std::array<Number *, n_conserved<dim, Gas>> &rates,
          const unsigned int stride,
          const bool is_first)
{
  using C = Component<dim>;
  Number own(0.);
  if constexpr (Faces::takes_own_pressure)
  {
    const auto &inside = line.subcells[i];
    own = inside[C::pressure];
    if (line.burn != nullptr)
      own = line.burn->pressure(
        own, line.burn->fraction(line.progress[i], inside[C::density]));
    own = faces.subtracted(own);
  }
  std::array<Number, n_conserved<dim, Gas>> change;
  for (unsigned int c = 0; c < n_conserved<dim, Gas>; ++c)
  {
    const Number base = c == C::momentum ? own : Number(0.);
    change[c] = Faces::takes_own_pressure
                  ? faces.rate(i, Number(low[c] - base), Number(high[c] - base))
                  : faces.rate(i, low[c], high[c]);
  }
  if (!is_first)
    for (unsigned int c = 0; c < n_conserved<dim, Gas>; ++c)
      change[c] = rates[c][i * stride] + change[c];
  for (unsigned int c = 0; c < n_conserved<dim, Gas>; ++c)
    rates[c][i * stride] = change[c];
}


/**
 * Adds the rates of change of the subcells of a line, or sets them with
 * @p is_first. First come the slopes of all subcells, then the fluxes through
 * all faces: in one loop both need twice as many registers as AVX2 has, and a
 * line of four subcells takes 1.5 times as long.
 *
 * @param given_faces geometry of the line, see line_faces.h
 * @param given_rates of each component of the line's frame in the first
 * subcell, those of the next subcells @p stride further
 */
template <unsigned int fixed_n,
          typename SomeScheme,
          int dim,
          typename Gas,
          typename Number,
          typename Faces>
__attribute__((noinline)) void
sweep_line(const Gas &given_gas,
           const Line<Number, n_conserved<dim, Gas>> &line,
           const Faces &given_faces,
           const std::array<Number *, n_conserved<dim, Gas>> &given_rates,
           const unsigned int stride,
           const bool is_first)
{
  // The compiler must assume that each store of lanes changes what it has no
  // copy of.
  const Gas gas = given_gas;
  const Faces faces = given_faces;
  const auto rates = given_rates;
  const int n = fixed_n > 0 ? fixed_n : line.n;
  reconstruct<dim, Gas, SomeScheme>(gas, line, faces, n);

  std::array<Number, n_conserved<dim, Gas>> flux, next;
  // One body of the loop fills half of the instruction cache.
#pragma GCC unroll 1
  for (int f = 0; f <= n; ++f)
  {
    face_flux<dim, Gas, SomeScheme>(given_gas, gas, line, f, n, next);
    if (f > 0)
      add_rates<dim, Gas>(
        line, faces, f - 1, flux, next, rates, stride, is_first);
    for (unsigned int c = 0; c < n_conserved<dim, Gas>; ++c)
      flux[c] = next[c];
  }
}
} // namespace contrecoup::gas
