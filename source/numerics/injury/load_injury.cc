// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/chest_wall.h>
#include <contrecoup/numerics/injury/load_injury.h>

#include <algorithm>

namespace contrecoup
{
namespace
{
  /// Fraction of its peak at which a wave counts as arrived.
  constexpr double arrived = 0.05;

  double peak_of(const std::vector<double> &overpressures)
  {
    double peak = 0.;
    for (const double value : overpressures)
      peak = std::max(peak, value);
    return peak;
  }
} // namespace


AirInjury air_injury(const PressurePulse &pulse,
                     const double load,
                     const double ambient,
                     const double body_mass)
{
  if (!(pulse.peak > 0.) || !(pulse.duration > 0.))
    return {};
  const double exposure =
    load / lung_median_lethal_overpressure(pulse.duration, body_mass, ambient);
  return {exposure,
          lung_lethality_probability(exposure),
          eardrum_rupture_probability(pulse.peak)};
}


PressurePulse first_pulse(const std::vector<double> &times,
                          const std::vector<double> &overpressures)
{
  const double peak = peak_of(overpressures);
  if (!(peak > 0.))
    return {};
  const auto begin =
    std::find_if(overpressures.begin(), overpressures.end(), [&](double value) {
      return value >= arrived * peak;
    });
  const auto end = std::find_if(
    begin, overpressures.end() - 1, [](double value) { return value <= 0.; });
  return {peak,
          times[end - overpressures.begin()] -
            times[begin - overpressures.begin()],
          *end > 0.};
}


LoadInjury load_injury(const std::vector<double> &times,
                       const std::vector<double> &overpressures,
                       const PressurePulse &pulse,
                       const double body_mass)
{
  LoadInjury injury;
  injury.pulse = pulse;
  const ChestWallResponse wall =
    chest_wall_response(times, overpressures, sea_level_pressure);
  injury.chest_wall_velocity = wall.velocity;
  injury.is_velocity_cut = !(pulse.peak > 0.) || wall.is_cut;
  if (pulse.duration > 0.)
    injury.lung_exposure =
      pulse.peak / lung_median_lethal_overpressure(
                     pulse.duration, body_mass, sea_level_pressure);
  injury.eardrum_rupture = eardrum_rupture_probability(pulse.peak);
  return injury;
}


LoadInjury load_injury(const std::vector<double> &times,
                       const std::vector<double> &overpressures,
                       const double body_mass)
{
  return load_injury(
    times, overpressures, first_pulse(times, overpressures), body_mass);
}
} // namespace contrecoup
