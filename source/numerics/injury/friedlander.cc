// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/friedlander.h>

#include <cmath>

namespace contrecoup
{
namespace
{
  /// Impulse over peak times duration: 1 / b - (1 - exp(-b)) / b^2.
  double relative_impulse(const double decay)
  {
    if (decay < 1e-3)
      return 0.5 - decay / 6.;
    return 1. / decay - (1. - std::exp(-decay)) / (decay * decay);
  }
} // namespace


double Friedlander::value(const double time,
                          const bool with_negative_phase) const
{
  const double s = (time - arrival) / duration;
  if (s < 0. || (s > 1. && !with_negative_phase))
    return 0.;
  return peak * (1. - s) * std::exp(-decay * s);
}


double Friedlander::impulse() const
{
  return peak * duration * relative_impulse(decay);
}


Friedlander friedlander_pulse(const double arrival,
                              const double peak,
                              const double duration,
                              const double impulse)
{
  if (!(peak > 0. && duration > 0. && impulse > 0.))
    throw InputError("a blast wave needs a peak, a duration and an impulse "
                     "above 0, not " +
                     brief(peak) + " Pa, " + brief(duration) + " s, " +
                     brief(impulse) + " Pa s");
  const double wanted = impulse / (peak * duration);
  if (wanted >= 0.5)
    return {arrival, peak, 2. * impulse / peak, 0.};
  // The relative impulse decreases with decay, and is below 1 / decay.
  double low = 0., high = 1. / wanted;
  for (unsigned int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (relative_impulse(middle) > wanted ? low : high) = middle;
  }
  return {arrival, peak, duration, 0.5 * (low + high)};
}


double reflected_overpressure(const double overpressure, const double ambient)
{
  return 2. * overpressure * (7. * ambient + 4. * overpressure) /
         (7. * ambient + overpressure);
}


double pressure_at_angle(const double incident,
                         const double reflected,
                         const double cosine)
{
  if (!(cosine > 0.))
    return incident;
  return reflected * cosine * cosine +
         incident * (1. + cosine - 2. * cosine * cosine);
}
} // namespace contrecoup
