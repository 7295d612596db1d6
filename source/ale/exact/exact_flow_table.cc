// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/gas/conditions/table_profile.h>

namespace contrecoup::ale
{
namespace
{
  void declare_table(ParameterHandler &prm)
  {
    declare_file(prm,
                 "File",
                 "",
                 "Table of radius [m], density [kg/m^3], radial velocity "
                 "[m/s] and pressure [Pa] at the end time.");
  }

  ExactFlow read_table(const ParameterHandler &prm)
  {
    const gas::TableProfile table(prm.get("File"));
    return {[=](const dealii::Point<3> &place, const double /*time*/) {
      const auto state = table.value(place.norm());
      return radial_state({state.density, state.velocity[0], state.pressure},
                          place);
    }};
  }
} // namespace


FlowKind table_flow()
{
  return {"table", "Table", declare_table, read_table};
}
} // namespace contrecoup::ale
