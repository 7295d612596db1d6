// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/table_flow.h>
#include <contrecoup/base/parameters/parameters.h>

namespace contrecoup::ale
{
void TableFlow::declare_parameters(ParameterHandler &prm)
{
  declare_file(prm,
               "File",
               "",
               "Table of radius [m], density [kg/m^3], radial velocity "
               "[m/s] and pressure [Pa] at the end time.");
}


std::unique_ptr<ExactFlow> TableFlow::create(const ParameterHandler &prm)
{
  return std::unique_ptr<ExactFlow>(
    new TableFlow(gas::TableProfile(prm.get("File"))));
}


FlowState TableFlow::value(const dealii::Point<3> &place,
                           const double /*time*/) const
{
  const double radius = place.norm();
  const auto state = table_.value(radius);
  FlowState result;
  result.density = state.density;
  result.pressure = state.pressure;
  if (radius > 0.)
    result.velocity = state.velocity[0] / radius * place;
  return result;
}
} // namespace contrecoup::ale
