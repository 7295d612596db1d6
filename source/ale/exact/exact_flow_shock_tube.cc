// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/numerics/exact/exact_riemann.h>

namespace contrecoup::ale
{
namespace
{
  RiemannState read_state(const ParameterHandler &prm, const std::string &name)
  {
    const auto values = read_list(prm, name);
    return {values[0], values[1], values[2]};
  }

  void declare_shock_tube(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Interface",
                   "0.5",
                   -1e6,
                   1e6,
                   "m",
                   "Initial x of the interface between the gases.");
    for (const char *const name : {"Left", "Right"})
      declare_list(
        prm,
        name,
        "1, 0, 1",
        3,
        3,
        -1e12,
        1e12,
        "-",
        "Density [kg/m^3], velocity [m/s] and pressure [Pa] of this gas.");
    declare_double(prm,
                   "Gamma",
                   "1.4",
                   1.0001,
                   100.,
                   "-",
                   "Ratio of specific heats of the gases.");
  }

  ExactFlow read_shock_tube(const ParameterHandler &prm)
  {
    const GasMaterial gas(IdealGas(read_double(prm, "Gamma")));
    const ExactRiemann solution(
      read_state(prm, "Left"), read_state(prm, "Right"), gas);
    const double interface = read_double(prm, "Interface");
    return {[=](const dealii::Point<3> &place, const double time) {
              const auto state = solution.value((place[0] - interface) / time);
              FlowState result;
              result.density = state.density;
              result.velocity[0] = state.velocity;
              result.pressure = state.pressure;
              return result;
            },
            {{20, 2, 2}}};
  }
} // namespace


FlowKind shock_tube_flow()
{
  return {"shock tube", "Shock tube", declare_shock_tube, read_shock_tube};
}
} // namespace contrecoup::ale
