// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/numerics/exact/noh_solution.h>

namespace contrecoup::ale
{
namespace
{
  void declare_noh(ParameterHandler &prm)
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

  ExactFlow read_noh(const ParameterHandler &prm)
  {
    const unsigned int dimension = read_unsigned(prm, "Dimension");
    const NohSolution solution(dimension,
                               read_double(prm, "Gamma"),
                               read_double(prm, "Density"),
                               read_double(prm, "Speed"));
    return {[=](const dealii::Point<3> &place, const double time) {
      dealii::Tensor<1, 3> way;
      for (unsigned int d = 0; d < dimension; ++d)
        way[d] = place[d];
      return radial_state(solution.value(way.norm(), time), way);
    }};
  }
} // namespace


FlowKind noh_flow()
{
  return {"noh", "Noh", declare_noh, read_noh};
}
} // namespace contrecoup::ale
