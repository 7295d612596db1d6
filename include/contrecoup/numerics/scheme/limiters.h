// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/base/system/names.h>

#include <array>

namespace contrecoup
{
/// Slope limiters; slope_limiters describes each.
enum class SlopeLimiter
{
  none,
  minmod,     ///< Roe 1986
  van_albada, ///< van Albada et al. 1982
  van_leer,   ///< van Leer 1974
  mc,         ///< van Leer 1977
  superbee    ///< Roe 1986
};

struct SlopeLimiterDescription : NamedChoice<SlopeLimiter>
{
  /// Whether slopes lie between zero and twice the smaller difference.
  bool is_tvd;
};

/// All slope limiters. Entry, help text and tests take them from here.
inline constexpr std::array<SlopeLimiterDescription, 6> slope_limiters{
  {{{SlopeLimiter::none,
     "none",
     "takes the central difference, for smooth flow only"},
    false},
   {{SlopeLimiter::minmod,
     "minmod",
     "takes the smaller of both differences and smears most"},
    true},
   {{SlopeLimiter::van_albada, "van albada", "is smooth"}, true},
   {{SlopeLimiter::van_leer,
     "van leer",
     "takes the harmonic mean, smooth as well"},
    true},
   {{SlopeLimiter::mc,
     "mc",
     "takes the central difference, at most twice either, and is sharper"},
    true},
   {{SlopeLimiter::superbee,
     "superbee",
     "takes the largest TVD slope and steepens contacts"},
    true}}};

/// The argument of smaller magnitude if both have the same sign, else zero.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number minmod(const Number &a, const Number &b)
{
  const Number zero(0.);
  return std::max(zero, std::min(a, b)) + std::min(zero, std::max(a, b));
}

namespace internal
{
  /// numerator / denominator if @p product > 0, else zero.
  template <typename Number>
  inline DEAL_II_ALWAYS_INLINE Number
  quotient_of_one_sign(const Number &product,
                       const Number &numerator,
                       const Number &denominator)
  {
    const Number zero(0.), one(1.);
    return select_less(zero, product, numerator, zero) /
           select_less(zero, product, denominator, one);
  }
} // namespace internal

/**
 * Limited difference per cell of a uniform grid, from the differences to the
 * cells before and after. Lies between zero and twice the smaller difference,
 * except for SlopeLimiter::none. Differences may be zero.
 */
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number limited_slope(const SlopeLimiter limiter,
                                                  const Number &backward,
                                                  const Number &forward)
{
  const Number sum = backward + forward;
  const Number product = backward * forward;
  switch (limiter)
  {
    case SlopeLimiter::minmod:
      return minmod(backward, forward);
    case SlopeLimiter::van_albada:
      return internal::quotient_of_one_sign(
        product,
        Number(product * sum),
        Number(backward * backward + forward * forward));
    case SlopeLimiter::van_leer:
      return internal::quotient_of_one_sign(
        product, Number(product + product), sum);
    case SlopeLimiter::mc:
    {
      const Number bound = minmod(backward, forward);
      return minmod(Number(bound + bound), Number(sum * 0.5));
    }
    case SlopeLimiter::superbee:
    {
      const Number a = minmod(Number(backward + backward), forward);
      const Number b = minmod(backward, Number(forward + forward));
      return std::max(a, b) + std::min(a, b) - minmod(a, b);
    }
    case SlopeLimiter::none:
      break;
  }
  return sum * 0.5;
}

/// Weights of limited_slope() at a point of a non-uniform grid, computed once
/// from the distances.
class SlopeWeights
{
public:
  /// @param to_backward,to_forward distances to neighbouring points
  /// @param backward_edge,forward_edge distances to the faces of the cell
  SlopeWeights(const double to_backward,
               const double to_forward,
               const double backward_edge,
               const double forward_edge)
    : backward_weight(to_forward / (to_backward + to_forward))
    , forward_weight(to_backward / (to_backward + to_forward))
    , backward_bound(to_backward / backward_edge)
    , forward_bound(to_forward / forward_edge)
  {}

  double backward_weight; ///< of the backward slope in the central one [-]
  double forward_weight;  ///< of the forward slope in the central one [-]
  double backward_bound;  ///< largest slope over the backward one [-]
  double forward_bound;   ///< largest slope over the forward one [-]
};

/**
 * Limited slope (derivative) at a point of a non-uniform grid, from the slopes
 * towards its neighbours: as on a uniform grid, but bounded such that face
 * values do not exceed the neighbours' values (SlopeLimiter::none: unbounded).
 * A limiter that takes the central slope needs a case here, as `mc` has.
 */
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number limited_slope(const SlopeLimiter limiter,
                                                  const Number &backward,
                                                  const Number &forward,
                                                  const SlopeWeights &weights)
{
  const Number central = backward * Number(weights.backward_weight) +
                         forward * Number(weights.forward_weight);
  if (limiter == SlopeLimiter::none)
    return central;
  const Number bound = minmod(Number(backward * Number(weights.backward_bound)),
                              Number(forward * Number(weights.forward_bound)));
  return minmod(bound,
                limiter == SlopeLimiter::mc
                  ? central
                  : limited_slope(limiter, backward, forward));
}
} // namespace contrecoup
