// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/injury_criteria.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
double lung_median_lethal_overpressure(const double duration,
                                       const double mass,
                                       const double ambient_pressure)
{
  const double psi = 6894.757;
  // In milliseconds, scaled to a body of 70 kg at sea level.
  const double scaled = 1e3 * duration * std::cbrt(70. / mass) *
                        std::sqrt(ambient_pressure / sea_level_pressure);
  const auto constant = [](const char *const name) {
    return injury_curve_constant("lung_median_lethal_load", name);
  };
  return constant("asymptote_psi") * psi *
         (1. + constant("factor") * std::pow(scaled, constant("exponent"))) *
         (ambient_pressure / sea_level_pressure);
}


double lung_lethality_probability(const double exposure)
{
  return injury_curve("lung_lethality").probability(exposure);
}


double dynamic_pressure(const double overpressure, const double ambient)
{
  return 2.5 * overpressure * overpressure / (7. * ambient + overpressure);
}


double standing_load(const double overpressure, const double ambient)
{
  return overpressure + dynamic_pressure(overpressure, ambient);
}


double load_in_flow(const double overpressure,
                    const double dynamic,
                    const double ambient)
{
  if (!(overpressure > 0.))
    return 0.;
  return overpressure +
         std::min(dynamic, dynamic_pressure(overpressure, ambient));
}


bool is_habitable(const double ambient)
{
  return ambient > 45e3 && ambient < 115e3;
}


double eardrum_rupture_probability(const double overpressure)
{
  return injury_curve("eardrum_rupture").probability(overpressure);
}
} // namespace contrecoup
