// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/base/parameters/parameters.h>

#include <cmath>

namespace contrecoup::ale
{
namespace
{
  void declare_taylor_green(ParameterHandler &prm)
  {
    declare_double(
      prm, "Density", "1", 1e-6, 1e6, "kg/m^3", "Density of the fluid.");
    declare_double(
      prm, "Speed", "1", 1e-6, 1e6, "m/s", "Largest speed of the vortices.");
    declare_double(prm,
                   "Pressure",
                   "1",
                   1e-6,
                   1e12,
                   "Pa",
                   "Mean pressure over each square.");
    declare_double(
      prm, "Side", "1", 1e-6, 1e6, "m", "Side of the square of each vortex.");
  }

  ExactFlow read_taylor_green(const ParameterHandler &prm)
  {
    const double density = read_double(prm, "Density");
    const double speed = read_double(prm, "Speed");
    const double pressure = read_double(prm, "Pressure");
    const double side = read_double(prm, "Side");
    return {[=](const dealii::Point<3> &place, const double /*time*/) {
      const double x = dealii::numbers::PI * place[0] / side;
      const double y = dealii::numbers::PI * place[1] / side;
      FlowState result;
      result.density = density;
      result.velocity[0] = speed * std::sin(x) * std::cos(y);
      result.velocity[1] = -speed * std::cos(x) * std::sin(y);
      result.pressure = pressure + 0.25 * density * speed * speed *
                                     (std::cos(2. * x) + std::cos(2. * y));
      return result;
    }};
  }
} // namespace


FlowKind taylor_green_flow()
{
  return {
    "taylor green", "Taylor Green", declare_taylor_green, read_taylor_green};
}
} // namespace contrecoup::ale
