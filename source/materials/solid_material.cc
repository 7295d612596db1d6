// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/names.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/materials/relaxation.h>
#include <contrecoup/materials/solid_material.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
double SolidMaterial::relaxation_modulus(const double time) const
{
  return instantaneous_shear +
         relaxing_shear *
           std::expm1(relaxation_exponent(std::max(time, 0.), relaxation_time));
}


double SolidMaterial::stiffening(const double dilatation) const
{
  return gas.exists() ? gas.stiffness(dilatation) : 1.;
}


double SolidMaterial::vapour_dilatation() const
{
  if (!cavitates())
    return no_cavitation;
  const double stress = largest_tension / bulk_modulus;
  return gas.exists() ? std::min(no_cavitation, gas.dilatation_at(stress))
                      : stress;
}


double SolidMaterial::dilatational_speed() const
{
  return std::sqrt((bulk_modulus + 4. / 3. * instantaneous_shear) / density);
}


double SolidMaterial::shear_speed() const
{
  return std::sqrt(instantaneous_shear / density);
}


void SolidMaterial::check(const std::string &name) const
{
  const auto refuse = [&](const std::string &what) {
    throw InputError(name + ": " + what);
  };
  if (!(density > 0.))
    refuse("density = " + brief(density) + " kg/m^3 must be above 0");
  if (!(bulk_modulus > 0.))
    refuse("bulk modulus = " + brief(bulk_modulus) + " Pa must be above 0");
  if (!(largest_tension > 0.))
    refuse("largest tension = " + brief(largest_tension) +
           " Pa must be above 0");
  if (!(instantaneous_shear >= 0.))
    refuse("shear modulus = " + brief(instantaneous_shear) +
           " Pa must not be below 0");
  if (!(relaxing_shear >= 0. && relaxing_shear <= instantaneous_shear))
    refuse("relaxing shear modulus = " + brief(relaxing_shear) +
           " Pa must be from 0 to the instantaneous one, " +
           brief(instantaneous_shear) + " Pa");
  if (is_viscoelastic() && !(relaxation_time >= 0.))
    refuse("relaxation time = " + brief(relaxation_time) +
           " s must not be below 0");
}


SolidMaterial solid_material(const TissueProperties &tissue,
                             const bool g1_is_long_term)
{
  SolidMaterial material;
  material.density = tissue.density;
  material.bulk_modulus = tissue.bulk_modulus;
  material.instantaneous_shear = tissue.instantaneous_shear;
  material.gas = tissue.gas;
  const double branch = tissue.instantaneous_shear - tissue.long_term_shear;
  if (branch > 0.)
  {
    material.relaxing_shear = g1_is_long_term ? tissue.long_term_shear : branch;
    material.relaxation_time = tissue.relaxation_time;
  }
  return material;
}
} // namespace contrecoup
