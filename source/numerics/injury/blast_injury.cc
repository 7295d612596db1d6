// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/blast_injury.h>

#include <cmath>

namespace contrecoup
{
namespace
{
  /// Part of the standard normal distribution below @p deviation.
  double normal_part_below(const double deviation)
  {
    return 0.5 * std::erfc(-deviation / std::sqrt(2.));
  }
} // namespace


double lung_median_lethal_overpressure(const double duration,
                                       const double mass,
                                       const double ambient_pressure)
{
  const double psi = 6894.757;
  const double sea_level = 101325.;
  // In milliseconds, scaled to a body of 70 kg at sea level.
  const double scaled = 1e3 * duration * std::cbrt(70. / mass) *
                        std::sqrt(ambient_pressure / sea_level);
  return 61.5 * psi * (1. + 6.76 * std::pow(scaled, -1.064)) *
         (ambient_pressure / sea_level);
}


double lung_threshold_overpressure(const double duration,
                                   const double mass,
                                   const double ambient_pressure)
{
  return lung_median_lethal_overpressure(duration, mass, ambient_pressure) / 5.;
}


double lung_lethality_probability(const double exposure)
{
  constexpr double deviation = 0.1788;
  return exposure > 0. ? normal_part_below(std::log(exposure) / deviation) : 0.;
}


double dynamic_pressure(const double overpressure, const double ambient)
{
  return 2.5 * overpressure * overpressure / (7. * ambient + overpressure);
}


double standing_load(const double overpressure, const double ambient)
{
  return overpressure + dynamic_pressure(overpressure, ambient);
}


double eardrum_rupture_probability(const double overpressure)
{
  if (!(overpressure > 0.))
    return 0.;
  const double probit = -12.6 + 1.524 * std::log(overpressure);
  // A probit of 5 is the median.
  return normal_part_below(probit - 5.);
}
} // namespace contrecoup
