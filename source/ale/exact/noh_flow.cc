// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/noh_flow.h>
#include <contrecoup/base/parameters/parameters.h>

namespace contrecoup::ale
{
void NohFlow::declare_parameters(ParameterHandler &prm)
{
  declare_integer(prm,
                  "Dimension",
                  "1",
                  1,
                  3,
                  "1: onto the plane x = 0, 2: onto the axis x = y = 0, 3: "
                  "onto the origin.");
  declare_double(prm,
                 "Gamma",
                 "1.6666666666666667",
                 1.0001,
                 100.,
                 "-",
                 "Ratio of specific heats of the gas.");
  declare_double(
    prm, "Density", "1", 1e-6, 1e6, "kg/m^3", "Initial density of the gas.");
  declare_double(
    prm, "Speed", "1", 1e-6, 1e6, "m/s", "Initial inward speed of the gas.");
}


std::unique_ptr<ExactFlow> NohFlow::create(const ParameterHandler &prm)
{
  const unsigned int dimension = read_unsigned(prm, "Dimension");
  return std::unique_ptr<ExactFlow>(
    new NohFlow(NohSolution(dimension,
                            read_double(prm, "Gamma"),
                            read_double(prm, "Density"),
                            read_double(prm, "Speed")),
                dimension));
}


FlowState NohFlow::value(const dealii::Point<3> &place, const double time) const
{
  dealii::Tensor<1, 3> way;
  for (unsigned int d = 0; d < dimension_; ++d)
    way[d] = place[d];
  const double radius = way.norm();
  const RadialState state = solution_.value(radius, time);
  FlowState result;
  result.density = state.density;
  result.pressure = state.pressure;
  if (radius > 0.)
    result.velocity = state.velocity / radius * way;
  return result;
}
} // namespace contrecoup::ale
