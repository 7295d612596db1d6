// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/materials/cold_curve.h>
#include <contrecoup/materials/explosives.h>
#include <contrecoup/materials/jwl_check.h>

#include <cmath>

namespace contrecoup
{
namespace
{
  constexpr double room_temperature = 298.; // [K]
  constexpr double smallest_volume = 0.4;   // V [-]
  constexpr unsigned int n_volumes = 4000;

  /// Pressure above the cold curve at the start of the isentrope, times V^(1 +
  /// omega) [Pa], and the largest V on the isentrope.
  struct Isentrope
  {
    double constant;
    double largest_volume;
  };

  Isentrope isentrope_of(const JwlParameters &jwl)
  {
    if (!(jwl.energy_density > 0.))
      return {jwl.omega * jwl.reference_density * jwl.specific_heat *
                room_temperature,
              1.};
    const ChapmanJouguetState state = chapman_jouguet(jwl);
    const double volume = jwl.reference_density / state.density;
    const double cold =
      jwl.A * std::exp(-jwl.R1 * volume) + jwl.B * std::exp(-jwl.R2 * volume);
    return {(state.pressure - cold) * std::pow(volume, 1. + jwl.omega),
            largest_cold_exponent / std::min(jwl.R1, jwl.R2)};
  }
} // namespace


void require_real_sound_speed(const JwlParameters &jwl,
                              const std::string &where)
{
  if (jwl.B >= 0.)
    return;
  const Isentrope isentrope = isentrope_of(jwl);
  const double ratio = isentrope.largest_volume / smallest_volume;
  for (unsigned int i = 0; i <= n_volumes; ++i)
  {
    const double volume =
      smallest_volume * std::pow(ratio, double(i) / n_volumes);
    // -dp/dV = rho_0 c^2 / V^2.
    const double slope =
      jwl.A * jwl.R1 * std::exp(-jwl.R1 * volume) +
      jwl.B * jwl.R2 * std::exp(-jwl.R2 * volume) +
      (1. + jwl.omega) * isentrope.constant * std::pow(volume, -2. - jwl.omega);
    if (!(slope > 0.))
      throw InputError(
        where + ": with B = " + brief(jwl.B) +
        " Pa the sound speed is not real at the relative volume " +
        brief(volume) + ", " + brief(jwl.reference_density / volume) +
        " kg/m^3, to which " +
        (jwl.energy_density > 0. ? "the products expand"
                                 : "the explosive is compressed"));
  }
}
} // namespace contrecoup
