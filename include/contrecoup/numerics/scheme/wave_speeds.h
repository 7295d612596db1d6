// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

#include <array>
#include <limits>

namespace contrecoup
{
/// State on one side of a face, in face coordinates.
template <int dim, typename Number>
struct FaceState
{
  Number density;                   ///< rho [kg/m^3]
  std::array<Number, dim> velocity; ///< [0] normal, others tangential
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
  /// Speed of a strong wave into the gas on one side.
  template <typename Number>
  class StrongWave
  {
  public:
    /// Uses the fundamental derivative G = (gamma + 1) / 2 with gamma = rho
    /// c^2 / p, at most 8. If p is small compared to rho c^2, as in a
    /// stiffened gas, that ratio is no measure of G.
    DEAL_II_ALWAYS_INLINE
    StrongWave(const Number &density,
               const Number &pressure,
               const Number &sound_speed)
      : density_(density)
      , pressure_(pressure)
      , sound_speed_(sound_speed)
      , square_(sound_speed * sound_speed)
    {
      const Number tiny(std::numeric_limits<float>::min());
      const Number stiffness = density * square_;
      const Number bounded = std::max(pressure, Number(stiffness * 0.125));
      const Number inverse =
        Number(1.) / std::max(Number(bounded * density), tiny);
      shock_coefficient_ = (stiffness + bounded) * inverse * 0.5;
      inverse_ = density * inverse;
    }

    /// Mass flux through the wave, per change of velocity, for the pressure @p
    /// behind: that of a shock, W^2 = c^2 + G (p - p_0) / rho (exact for ideal
    /// and stiffened gas), or approximately that of a rarefaction.
    DEAL_II_ALWAYS_INLINE Number impedance(const Number &behind) const
    {
      const Number zero(0.);
      const Number rise = behind - pressure_;
      const Number argument =
        select_less(rise,
                    zero,
                    Number(rise * inverse_ + 1.),
                    Number(square_ + shock_coefficient_ * rise));
      const Number root = std::sqrt(std::max(argument, zero));
      return density_ *
             select_less(
               rise, zero, Number(sound_speed_ * (root * 0.85 + 0.15)), root);
    }

    /// Speed of the wave front relative to the gas.
    DEAL_II_ALWAYS_INLINE Number front_speed(const Number &behind) const
    {
      const Number rise = std::max(Number(behind - pressure_), Number(0.));
      return std::sqrt(square_ + shock_coefficient_ * rise);
    }

  private:
    Number density_, pressure_, sound_speed_, square_;
    Number shock_coefficient_; ///< G / rho
    Number inverse_;           ///< 1 / p, bounded
  };

  /// Front speeds, relative to each gas, of the waves from a strong jump. The
  /// pressure between the waves is iterated twice with the impedances of both
  /// waves, starting from the mean plus the contribution of the collision.
  template <int dim, typename Number>
  inline DEAL_II_ALWAYS_INLINE WaveSpeeds<Number>
  strong_wave_speeds(const FaceState<dim, Number> &left,
                     const FaceState<dim, Number> &right)
  {
    const Number zero(0.), tiny(std::numeric_limits<float>::min());
    const StrongWave<Number> left_wave(
      left.density, left.pressure, left.sound_speed);
    const StrongWave<Number> right_wave(
      right.density, right.pressure, right.sound_speed);

    const Number closing = left.velocity[0] - right.velocity[0];
    const Number collision = std::max(closing, zero);
    const Number lighter = std::min(left.density, right.density);
    const Number softer = std::min(Number(left.density * left.sound_speed),
                                   Number(right.density * right.sound_speed));
    const Number mean = (left.pressure + right.pressure) * 0.5;
    const Number half_jump = (right.pressure - left.pressure) * 0.5;

    Number middle = mean + collision * (softer + collision * lighter * 1.2);
    for (unsigned int i = 0; i < 2; ++i)
    {
      const Number a = left_wave.impedance(middle);
      const Number b = right_wave.impedance(middle);
      const Number next = mean + ((a - b) * half_jump + a * b * closing) /
                                   std::max(Number(a + b), tiny);
      middle = std::max(next, Number(middle * 0.01));
    }
    return {left_wave.front_speed(middle), right_wave.front_speed(middle)};
  }
} // namespace internal

/**
 * Outer wave speeds of the Riemann problem between two gases with any convex
 * equation of state.
 *
 * The speeds are the bounds of Davis (1988), u -+ c of both sides, combined
 * with estimated shock speeds at strong jumps: |dp| above 5 % of the smaller
 * rho c^2, or a closing velocity above 5 % of the smaller c. Davis' bounds
 * contain every single shock by the Lax condition, and enclose the contact
 * speed of HLLC whenever rho c^2 >= p. Lanes without a strong jump do not
 * depend on other lanes; a group of lanes without any skips the estimate.
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
