// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/materials/johnson_cook.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace
{
  /// Thermal softening 1 - T*^m, clipped to [0, 1].
  double softening(const JohnsonCook &law, const double plastic_work)
  {
    const double warmed =
      (law.temperature(plastic_work) - law.reference_temperature) /
      (law.melting_temperature - law.reference_temperature);
    return warmed > 0.
             ? std::max(0., 1. - std::pow(warmed, law.softening_exponent))
             : 1.;
  }

  double rate_factor(const JohnsonCook &law, const double rate)
  {
    return 1. + law.rate_coefficient *
                  std::log(std::max(1., rate / law.reference_rate));
  }
} // namespace


double JohnsonCook::temperature(const double plastic_work) const
{
  return reference_temperature +
         heating_fraction * plastic_work / heat_capacity;
}


double JohnsonCook::strength(const double plastic_strain,
                             const double rate,
                             const double plastic_work) const
{
  return (yield_stress +
          hardening * std::pow(plastic_strain, hardening_exponent)) *
         rate_factor(*this, rate) * softening(*this, plastic_work);
}


double JohnsonCook::plastic_increment(const double stress,
                                      const double stiffness,
                                      const double plastic_strain,
                                      const double plastic_work,
                                      const double step) const
{
  constexpr double tolerance = 1e-13;
  constexpr unsigned int most = 100;
  const double soft = softening(*this, plastic_work);
  if (!(stress > soft * yield_stress) ||
      !(stress >
        soft * (yield_stress +
                hardening * std::pow(plastic_strain, hardening_exponent))))
    return 0.;
  // Stress minus strength decreases from a positive to a negative value.
  double lower = 0., upper = stress / stiffness;
  // Strength is concave in plastic strain: its value at the upper end gives a
  // lower bound of the root.
  double added = std::max(
    0.,
    upper -
      strength(plastic_strain + upper, upper / step, plastic_work) / stiffness);
  for (unsigned int i = 0; i < most; ++i)
  {
    const double strain = plastic_strain + added, rate = added / step;
    const double hardened = hardening * std::pow(strain, hardening_exponent);
    const double factor = rate_factor(*this, rate);
    const double excess =
      stress - stiffness * added - (yield_stress + hardened) * factor * soft;
    if (std::abs(excess) <= tolerance * stress)
      break;
    (excess > 0. ? lower : upper) = added;
    const double slope =
      stiffness + soft * (hardening_exponent * hardened / strain * factor +
                          (rate > reference_rate ? (yield_stress + hardened) *
                                                     rate_coefficient / added
                                                 : 0.));
    const double next = added + excess / slope;
    added = next > lower && next < upper ? next : 0.5 * (lower + upper);
  }
  return added;
}


void JohnsonCook::check(const std::string &name) const
{
  if (!(melting_temperature > reference_temperature))
    throw InputError(name +
                     ": Melting temperature = " + brief(melting_temperature) +
                     " K must be above Reference temperature = " +
                     brief(reference_temperature) + " K");
}
} // namespace contrecoup
