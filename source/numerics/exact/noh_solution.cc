// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/exact/noh_solution.h>

#include <cmath>

namespace contrecoup
{
NohSolution::NohSolution(const unsigned int dimension,
                         const double gamma,
                         const double density,
                         const double speed)
  : dimension_(dimension)
  , gamma_(gamma)
  , density_(density)
  , speed_(speed)
{
  if (dimension < 1 || dimension > 3 || !(gamma > 1.) || !(density > 0.) ||
      !(speed > 0.))
    throw InputError("Noh's problem needs a dimension of 1 to 3, gamma above "
                     "1 (an ideal gas), density and speed above 0");
}


double NohSolution::shock_speed() const
{
  return 0.5 * (gamma_ - 1.) * speed_;
}


RadialState NohSolution::value(const double radius, const double time) const
{
  const double compression = (gamma_ + 1.) / (gamma_ - 1.);

  if (radius < shock_speed() * time)
    return {density_ * std::pow(compression, dimension_),
            0.,
            0.5 * (gamma_ - 1.) * density_ * speed_ * speed_ *
              std::pow(compression, dimension_)};

  // Mass from radius + speed * time has converged to a thinner shell.
  const double convergence = (radius > 0.) ? 1. + speed_ * time / radius : 1.;
  return {density_ * std::pow(convergence, dimension_ - 1.), -speed_, 0.};
}
} // namespace contrecoup
