// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/fluid_filled_shell.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace contrecoup
{
using dealii::numbers::PI;

double FluidFilledShell::mass() const
{
  const double inside = std::pow(fluid_radius, 3),
               outside = std::pow(fluid_radius + thickness, 3);
  return 4. / 3. * PI *
         (fluid_density * inside + shell_density * (outside - inside));
}


double FluidFilledShell::stiffness() const
{
  return 4. * young_modulus * thickness * thickness /
         (radius() * std::sqrt(3. * (1. - poisson_ratio * poisson_ratio)));
}


double FluidFilledShell::contact_time() const
{
  return PI * std::sqrt(mass() / stiffness());
}


double FluidFilledShell::peak_force() const
{
  return speed * std::sqrt(stiffness() * mass());
}


double FluidFilledShell::peak_acceleration() const
{
  return peak_force() / mass();
}


double FluidFilledShell::dent(const unsigned int l) const
{
  const double square =
    thickness /
    (radius() * std::sqrt(12. * (1. - poisson_ratio * poisson_ratio)));
  return 2. / PI * (2. * l + 1.) * square /
         (1. + std::pow((l + 0.5) * (l + 0.5) * square, 2));
}


double FluidFilledShell::pressure(const double distance,
                                  const double cosine) const
{
  // Even terms are equal on both sides and cancel. Terms decay like 1 / l^4.
  constexpr unsigned int largest = 199;
  const double part = distance / fluid_radius;
  double sum = part * cosine;
  for (unsigned int l = 3; l <= largest; l += 2)
    sum -= dent(l) / l * std::pow(part, l) * std::legendre(l, cosine);
  return fluid_density * peak_acceleration() * fluid_radius * sum;
}
} // namespace contrecoup
