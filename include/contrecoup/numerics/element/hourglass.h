// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/names.h>
#include <contrecoup/numerics/element/hex8_geometry.h>

#include <array>

/**
 * @file
 * Hourglass control for one-point integration. All moduli derive from the
 * instantaneous shear modulus; scaled with K + 4/3 G they would be thousands
 * of times the stiffness of nearly incompressible tissue.
 */

namespace contrecoup
{
/// Kinds of hourglass control.
enum class HourglassKind
{
  none,
  viscous,
  stiffness,
  assumed_strain
};

/// All hourglass controls, for entry and help text.
inline constexpr std::array<NamedChoice<HourglassKind>, 4> hourglass_controls{
  {{HourglassKind::none, "none", "lets the modes grow freely"},
   {HourglassKind::viscous, "viscous", "resists the rate of the modes"},
   {HourglassKind::stiffness,
    "stiffness",
    "has the same stiffness for all modes"},
   {HourglassKind::assumed_strain,
    "assumed strain",
    "has the stiffness of a brick in bending and torsion"}}};

/// Hourglass control of one material. Forces act on modal values, which are 8
/// times the amplitudes.
template <typename Number>
struct Hourglass
{
  HourglassKind kind = HourglassKind::stiffness;
  /// For `stiffness`, multiplies stiffness_length(); for `assumed_strain`,
  /// shear modulus times coefficient [Pa].
  Number stiffness{};
  /// Damping, multiplies damping_area() [Pa s/m].
  Number viscosity{};
  /// Whether damping acts in addition to `kind`.
  bool damped = false;

  bool has_damper() const
  {
    return damped || kind == HourglassKind::viscous;
  }
};

/// Stiffness that gives a cube the energy of its shear in a warping mode, for
/// coefficient 1: 8/3 G h for amplitudes, hence 1/64 of it for modal values.
inline constexpr double hourglass_spring = 8. / 3. / 64.;

/// Damping for coefficient 1: 0.1 rho c_s h^2 for amplitudes, which the stable
/// step of distorted elements tolerates.
inline constexpr double hourglass_damper = 0.1 / 64.;

/**
 * Least ratio of bulk to shear modulus for which matter counts as nearly
 * incompressible. There, hourglass modes that alternate between neighbours
 * with slowly varying amplitude change element volumes with alternating sign.
 * These modes are waves of speed c with long periods despite short wave
 * lengths, and with checkerboard pressures. Stiffness from the shear modulus
 * does not suppress them.
 */
inline constexpr double nearly_incompressible = 100.;

/// Hourglass forces of equal stiffness, and their energy [J].
template <typename Number>
inline DEAL_II_ALWAYS_INLINE std::array<Vector3<Number>, 4>
spring_forces(const Number &spring, const std::array<Vector3<Number>, 4> &q)
{
  std::array<Vector3<Number>, 4> force;
  for (unsigned int m = 0; m < 4; ++m)
    for (unsigned int i = 0; i < 3; ++i)
      force[m][i] = spring * q[m][i];
  return force;
}

/**
 * Adds damping forces to @p force.
 * @param rates of the modes [m/s]
 * @param half_step half of the last step [s]
 * @param damping forces after the last step; replaced by the present ones
 * @return energy dissipated in the step by the trapezoidal rule, which is
 * consistent with the energy of central differences [J]
 */
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number
add_damping(const Number &damper,
            const std::array<Vector3<Number>, 4> &rates,
            const Number &half_step,
            std::array<Number, 12> &damping,
            std::array<Vector3<Number>, 4> &force)
{
  Number power{};
  for (unsigned int m = 0; m < 4; ++m)
    for (unsigned int i = 0; i < 3; ++i)
    {
      Number &before = damping[3 * m + i];
      const Number now = damper * rates[m][i];
      power += (before + now) * rates[m][i];
      force[m][i] += now;
      before = now;
    }
  return half_step * power;
}

/// Half the work of hourglass forces that are linear in the modes [J].
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number
half_work(const std::array<Vector3<Number>, 4> &force,
          const std::array<Vector3<Number>, 4> &q)
{
  Number sum = dot(force[0], q[0]);
  for (unsigned int m = 1; m < 4; ++m)
    sum += dot(force[m], q[m]);
  return Number(0.5) * sum;
}
} // namespace contrecoup
