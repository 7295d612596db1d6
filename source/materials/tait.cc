// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/materials/tait.h>

namespace contrecoup
{
namespace
{
  void require(const bool holds, const std::string &what)
  {
    if (!holds)
      throw InputError("Tait's liquid: " + what);
  }
} // namespace


Tait::Tait(const double density,
           const double bulk_modulus,
           const double exponent,
           const double least_pressure)
  : density_(density)
  , exponent_(exponent)
  , factor_(bulk_modulus / exponent)
  , least_pressure_(least_pressure)
{
  require(density > 0., "the density must be above 0");
  require(bulk_modulus > 0., "the bulk modulus must be above 0");
  require(exponent > 1., "the exponent must be above 1");
  require(least_pressure <= 0., "the least pressure must be at most 0");
  if (!std::isfinite(least_pressure))
    return;
  require(least_pressure > -factor_,
          "the least pressure must be above " + brief(-factor_) +
            " Pa, that of no density at all");
  cavitation_density_ = density_at(least_pressure_);
}


double Tait::void_fraction(const double density) const
{
  return density < cavitation_density_ ? 1. - density / cavitation_density_
                                       : 0.;
}
} // namespace contrecoup
