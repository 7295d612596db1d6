// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/kernel/face_flux.h>
#include <contrecoup/gas/kernel/line_faces.h>

/**
 * @file
 * The finite-volume scheme along one line of subcells: limited linear
 * reconstruction (van Leer 1979), a Riemann flux at each face, and what the
 * fluxes change in the subcells, in one pass without memory in between.
 */

namespace contrecoup::gas
{
/// Limiter that is known when the kernel is compiled.
template <SlopeLimiter limiter>
struct FixedLimiter
{
  explicit FixedLimiter(const Scheme &)
  {}
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number operator()(const Number &backward,
                                          const Number &forward) const
  {
    return limited_slope(limiter, backward, forward);
  }
};

/// The limiter of the scheme; slopes are zero where that is of first order.
struct AnyLimiter
{
  explicit AnyLimiter(const Scheme &scheme)
    : limiter(scheme.limiter)
    , linear_reconstruction(scheme.linear_reconstruction)
  {}
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number operator()(const Number &backward,
                                          const Number &forward) const
  {
    return linear_reconstruction ? limited_slope(limiter, backward, forward)
                                 : Number(0.);
  }

  SlopeLimiter limiter;
  bool linear_reconstruction;
};


/// Differences of primitive values from the centre of subcell @p i to its high
/// face.
/// @param backward differences to the subcell before; then to the next one
template <int dim,
          typename Gas,
          typename Limiter,
          typename Number,
          typename Faces>
DEAL_II_ALWAYS_INLINE inline std::array<Number, n_conserved<dim, Gas>>
half_slopes(const Gas &gas,
            const Limiter &limiter,
            const Line<Number, n_conserved<dim, Gas>> &line,
            const Faces &faces,
            const int i,
            const int n,
            std::array<Number, n_conserved<dim, Gas>> &backward)
{
  const auto &cell = line.subcells[i];
  std::array<Number, n_conserved<dim, Gas>> half;
  Number open(1.);
  if constexpr (Faces::closes_slopes)
    open = faces.is_open(i + 1, n);
  for (unsigned int c = 0; c < n_conserved<dim, Gas>; ++c)
  {
    Number forward = line.subcells[i + 1][c] - cell[c];
    if constexpr (Faces::closes_slopes)
      forward *= open;
    half[c] = limiter(backward[c], forward) * 0.5;
    backward[c] = forward;
  }
  if (line.bounds_velocity)
  {
    auto bounded = half;
    internal::bound_velocity<dim>(gas, cell, bounded);
    half = bounded;
  }
  return half;
}


/// Adds what the fluxes through the low and high face of subcell @p i change in
/// it to its rates.
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
    own = inside[C::energy];
    if (line.burn != nullptr)
      own = line.burn->pressure(
        own, line.burn->fraction(line.progress[i], inside[C::density]));
  }
  for (unsigned int c = 0; c < n_conserved<dim, Gas>; ++c)
  {
    const Number base = c == C::momentum ? own : Number(0.);
    const Number rate =
      Faces::takes_own_pressure
        ? faces.rate(i, Number(low[c] - base), Number(high[c] - base))
        : faces.rate(i, low[c], high[c]);
    Number &sum = rates[c][i * stride];
    sum = is_first ? rate : sum + rate;
  }
}


/**
 * Adds the rates of change of the subcells of a line, or sets them with
 * @p is_first.
 *
 * @param faces geometry of the line, see line_faces.h
 * @param rates of each component of the line's frame in the first subcell,
 * those of the next subcells @p stride further
 */
template <unsigned int fixed_n,
          typename Limiter,
          int dim,
          typename Gas,
          typename Number,
          typename Faces>
__attribute__((noinline)) void
sweep_line(const Gas &gas,
           const Line<Number, n_conserved<dim, Gas>> &line,
           const Faces &faces,
           const std::array<Number *, n_conserved<dim, Gas>> &rates,
           const unsigned int stride,
           const bool is_first)
{
  constexpr unsigned int nc = n_conserved<dim, Gas>;
  using Values = std::array<Number, nc>;
  const int n = fixed_n > 0 ? fixed_n : line.n;
  const Limiter limiter(*line.scheme);

  Values backward;
  for (unsigned int c = 0; c < nc; ++c)
    backward[c] = line.subcells[-1][c] - line.subcells[-2][c];
  if constexpr (Faces::closes_slopes)
    for (unsigned int c = 0; c < nc; ++c)
      backward[c] *= faces.is_open(-1, n);

  FaceState<dim, Number> left;
  Values flux;
  // One body of the loop fills half of the instruction cache.
#pragma GCC unroll 1
  for (int i = -1; i <= n; ++i)
  {
    const Values &cell = line.subcells[i];
    const Values half =
      half_slopes<dim>(gas, limiter, line, faces, i, n, backward);
    Values low, high;
    find_traces<dim, Gas>(cell, half, low, high);
    if (i >= 0)
    {
      const Values next = face_flux<dim, Gas>(
        gas, line, i, n, left, trace_state<dim>(gas, cell, low));
      if (i > 0)
        add_rates<dim, Gas>(
          line, faces, i - 1, flux, next, rates, stride, is_first);
      flux = next;
    }
    if (i < n)
      left = trace_state<dim>(gas, cell, high);
  }
}
} // namespace contrecoup::gas
