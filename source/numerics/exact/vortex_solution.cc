// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/vortex_solution.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace contrecoup
{
using boost::math::double_constants::pi;

VortexSolution::State
VortexSolution::value(const double x, const double y, const double time) const
{
  // In core radii, mapped to the periodic box around the core.
  const auto offset = [&](const double position, const unsigned int i) {
    return std::remainder(position - center[i] - velocity[i] * time, period) /
           radius;
  };
  const double dx = offset(x, 0), dy = offset(y, 1);
  const double square = dx * dx + dy * dy;

  const double sound_speed_scale = std::sqrt(pressure / density);
  const double swirl =
    strength / (2. * pi) * std::exp(0.5 * (1. - square)) * sound_speed_scale;
  const double temperature = 1. - temperature_drop(square);

  return {density * std::pow(temperature, 1. / (gamma - 1.)),
          {{velocity[0] - swirl * dy, velocity[1] + swirl * dx}},
          pressure * std::pow(temperature, gamma / (gamma - 1.))};
}


bool VortexSolution::is_admissible() const
{
  return temperature_drop(0.) < 1.;
}


double VortexSolution::temperature_drop(const double distance_square) const
{
  return (gamma - 1.) * strength * strength / (8. * gamma * pi * pi) *
         std::exp(1. - distance_square);
}
} // namespace contrecoup
