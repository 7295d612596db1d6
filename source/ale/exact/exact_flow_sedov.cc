// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/numerics/exact/sedov_solution.h>

namespace contrecoup::ale
{
namespace
{
  void declare_sedov(ParameterHandler &prm)
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

  ExactFlow read_sedov(const ParameterHandler &prm)
  {
    constexpr unsigned int dimension = 3;
    const SedovSolution solution(dimension,
                                 read_double(prm, "Gamma"),
                                 read_double(prm, "Density"),
                                 read_double(prm, "Energy"));
    return {[=](const dealii::Point<3> &place, const double time) {
      return radial_state(solution.value(place.norm(), time), place);
    }};
  }
} // namespace


FlowKind sedov_flow()
{
  return {"sedov", "Sedov", declare_sedov, read_sedov};
}
} // namespace contrecoup::ale
