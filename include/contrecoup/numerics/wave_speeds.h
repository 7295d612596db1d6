// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lane_math.h>

#include <array>
#include <limits>

namespace contrecoup
{
/// Gas state on one side of a face, seen along the face normal.
template <int dim, typename Number>
struct FaceState
{
  Number density;                   ///< rho [kg/m^3]
  std::array<Number, dim> velocity; ///< [0] normal, rest tangential
  Number pressure;                  ///< p [Pa]
  Number energy_density;            ///< rho E [J/m^3]
  Number sound_speed;               ///< c [m/s]
  Number products;                  ///< mass fraction Y [-]
};

/// Speeds of the leftmost and rightmost wave of a Riemann problem [m/s].
template <typename Number>
struct WaveSpeeds
{
  Number left;
  Number right;
};

namespace internal
{
  /// G / rho with the fundamental derivative G = (gamma + 1) / 2 and
  /// gamma = rho c^2 / p, at most 8 (where p is small beside rho c^2, as in
  /// a stiffened gas, that ratio says nothing about G).
  template <typename Number>
  inline DEAL_II_ALWAYS_INLINE Number
  shock_steepness(const Number &density,
                  const Number &pressure,
                  const Number &sound_speed_squared)
  {
    const Number stiffness = density * sound_speed_squared;
    const Number bounded = std::max(pressure, Number(stiffness * 0.125));
    const Number tiny(std::numeric_limits<float>::min());
    return (stiffness + bounded) * 0.5 /
           std::max(Number(bounded * density), tiny);
  }

  /// Speeds relative to the gas of the two waves that a strong jump sends
  /// out: W^2 = c^2 + G max(p* - p, 0) / rho, exact for the ideal and the
  /// stiffened gas. The middle pressure p* is the two-shock solution (Toro
  /// 2009, eq. 9.42) with impedances at the linearised middle pressure.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE WaveSpeeds<Number>
  strong_wave_speeds(const FaceState<dim, Number> &left,
                     const FaceState<dim, Number> &right)
  {
    const Number zero(0.), tiny(std::numeric_limits<float>::min());
    const Number left_square = left.sound_speed * left.sound_speed;
    const Number right_square = right.sound_speed * right.sound_speed;
    const Number left_steepness =
      shock_steepness(left.density, left.pressure, left_square);
    const Number right_steepness =
      shock_steepness(right.density, right.pressure, right_square);

    const Number closing = left.velocity[0] - right.velocity[0];
    const Number linearised =
      (left.pressure + right.pressure) * 0.5 +
      closing * (left.density + right.density) *
        ((left.sound_speed + right.sound_speed) * 0.125);
    const Number guess = std::max(linearised, zero);
    const Number left_impedance =
      left.density *
      std::sqrt(std::max(
        Number(left_square + left_steepness * (guess - left.pressure)), zero));
    const Number right_impedance =
      right.density *
      std::sqrt(std::max(
        Number(right_square + right_steepness * (guess - right.pressure)),
        zero));
    const Number middle =
      (left_impedance * right.pressure + right_impedance * left.pressure +
       left_impedance * right_impedance * closing) /
      std::max(Number(left_impedance + right_impedance), tiny);

    const Number left_rise = std::max(Number(middle - left.pressure), zero);
    const Number right_rise = std::max(Number(middle - right.pressure), zero);
    return {std::sqrt(left_square + left_steepness * left_rise),
            std::sqrt(right_square + right_steepness * right_rise)};
  }
} // namespace internal

/**
 * Outer wave speeds of the Riemann problem between two gases with any convex
 * equation of state.
 *
 * They unite the bounds of Davis (1988), u -+ c of both sides, which contain
 * every single shock by Lax' condition and keep the contact speed of HLLC
 * between them whenever rho c^2 >= p, with the shock speeds of the two-shock
 * solution where the jump is strong: |dp| above 5 % of the smaller rho c^2,
 * or a closing velocity above 5 % of the smaller c. Lanes without a strong
 * jump do not depend on the others; a group without any skips that part.
 */
template <int dim, typename Number>
inline DEAL_II_ALWAYS_INLINE WaveSpeeds<Number>
wave_speeds(const FaceState<dim, Number> &left,
            const FaceState<dim, Number> &right)
{
  Number left_relative = left.sound_speed;
  Number right_relative = right.sound_speed;

  const Number left_stiffness =
    left.density * left.sound_speed * left.sound_speed;
  const Number right_stiffness =
    right.density * right.sound_speed * right.sound_speed;
  const Number softer = std::min(left_stiffness, right_stiffness);
  const Number slower = std::min(left.sound_speed, right.sound_speed);
  const Number pressure_excess =
    std::abs(left.pressure - right.pressure) - softer * 0.05;
  const Number velocity_excess =
    (left.velocity[0] - right.velocity[0]) - slower * 0.05;
  const Number excess = std::max(pressure_excess, velocity_excess);
  const Number zero(0.);
  if (any_less(zero, excess))
  {
    const WaveSpeeds<Number> strong = internal::strong_wave_speeds(left, right);
    left_relative = select_less(zero, excess, strong.left, left_relative);
    right_relative = select_less(zero, excess, strong.right, right_relative);
  }

  const Number left_own = left.velocity[0] - left_relative;
  const Number right_own = right.velocity[0] + right_relative;
  const Number left_other = right.velocity[0] - right.sound_speed;
  const Number right_other = left.velocity[0] + left.sound_speed;
  return {std::min(left_own, left_other), std::max(right_own, right_other)};
}
} // namespace contrecoup
