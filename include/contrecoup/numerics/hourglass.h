// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/hex8_geometry.h>

#include <string>
#include <vector>

/**
 * @file
 * Forces against the hourglass modes, which one integration point does not
 * see. All moduli are made of the instantaneous shear modulus: scaled with
 * K + 4/3 G they would be thousands of times the stiffness of nearly
 * incompressible tissue.
 */

namespace contrecoup
{
/// What resists hourglass modes.
enum class HourglassKind
{
  none,
  viscous,       ///< forces along the rate of the modes
  stiffness,     ///< the same spring for all modes
  assumed_strain ///< what bending and torsion of a brick cost
};

/// Their words in parameter files, in the order of the enumeration.
const std::vector<std::string> &hourglass_names();

/// @throws InputError with the nearest word
HourglassKind find_hourglass(const std::string &name);

/// Hourglass control of one material. Forces are on modes, which are 8 times
/// the amplitudes.
template <typename Number>
struct Hourglass
{
  HourglassKind kind = HourglassKind::stiffness;
  /// Spring: times stiffness_length() [Pa]. Assumed strain: the shear modulus
  /// times the coefficient [Pa].
  Number stiffness{};
  /// Damper: times damping_area() [Pa s/m].
  Number viscosity{};
  /// Whether there is a damper besides what `kind` says.
  bool damped = false;

  bool has_damper() const
  {
    return damped || kind == HourglassKind::viscous;
  }
};

/**
 * The spring that gives a cube the energy of its shear in a warping mode when
 * the coefficient is 1: 8/3 G h in amplitudes, hence 1/64 of it in modes.
 */
inline constexpr double hourglass_spring = 8. / 3. / 64.;

/// The damper for coefficient 1: 0.1 rho c_s h^2 in amplitudes, which the steps
/// of distorted elements bear as well.
inline constexpr double hourglass_damper = 0.1 / 64.;

/**
 * Least bulk over shear modulus of matter that is taken as nearly
 * incompressible. There the hourglass modes that neighbours have in turn, with
 * an amplitude that changes slowly, change volumes a little, from element to
 * element the other way: they are waves of speed c, of long period however
 * short, with pressures that alternate. Springs made of the shear modulus do
 * not hold them.
 */
inline constexpr double nearly_incompressible = 100.;

/// Hourglass forces of equal springs, and their energy [J].
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
 * Adds the forces of a damper to @p force.
 * @param rates of the modes [m/s]
 * @param half_step of the step to the present [s]
 * @param damping the same forces after the last step, are brought to the
 *   present
 * @return the heat of the step by the rule of the trapezoid, which closes the
 *   energy of central differences [J]
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
