// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/sedov_flow.h>
#include <contrecoup/base/parameters/parameters.h>

namespace contrecoup::ale
{
void SedovFlow::declare_parameters(ParameterHandler &prm)
{
  declare_double(prm,
                 "Gamma",
                 "1.4",
                 1.0001,
                 6.9,
                 "-",
                 "Ratio of specific heats of the gas.");
  declare_double(
    prm, "Density", "1", 1e-6, 1e6, "kg/m^3", "Initial density of the gas.");
  declare_double(prm,
                 "Energy",
                 "0.851072",
                 1e-12,
                 1e18,
                 "J",
                 "Energy of the explosion in all directions.");
}


std::unique_ptr<ExactFlow> SedovFlow::create(const ParameterHandler &prm)
{
  constexpr unsigned int dimension = 3;
  return std::unique_ptr<ExactFlow>(
    new SedovFlow(SedovSolution(dimension,
                                read_double(prm, "Gamma"),
                                read_double(prm, "Density"),
                                read_double(prm, "Energy"))));
}


FlowState SedovFlow::value(const dealii::Point<3> &place,
                           const double time) const
{
  const double radius = place.norm();
  const RadialState state = solution_.value(radius, time);
  FlowState result;
  result.density = state.density;
  result.pressure = state.pressure;
  if (radius > 0.)
    result.velocity = state.velocity / radius * place;
  return result;
}
} // namespace contrecoup::ale
