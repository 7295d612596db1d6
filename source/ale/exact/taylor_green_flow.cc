// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/taylor_green_flow.h>
#include <contrecoup/base/parameters/parameters.h>

#include <cmath>

namespace contrecoup::ale
{
void TaylorGreenFlow::declare_parameters(ParameterHandler &prm)
{
  declare_double(
    prm, "Density", "1", 1e-6, 1e6, "kg/m^3", "Density of the fluid.");
  declare_double(
    prm, "Speed", "1", 1e-6, 1e6, "m/s", "Largest speed of the vortices.");
  declare_double(
    prm, "Pressure", "1", 1e-6, 1e12, "Pa", "Mean pressure over each square.");
  declare_double(
    prm, "Side", "1", 1e-6, 1e6, "m", "Side of the square of each vortex.");
}


std::unique_ptr<ExactFlow> TaylorGreenFlow::create(const ParameterHandler &prm)
{
  auto flow = std::make_unique<TaylorGreenFlow>();
  flow->density_ = read_double(prm, "Density");
  flow->speed_ = read_double(prm, "Speed");
  flow->pressure_ = read_double(prm, "Pressure");
  flow->side_ = read_double(prm, "Side");
  return flow;
}


FlowState TaylorGreenFlow::value(const dealii::Point<3> &place,
                                 const double /*time*/) const
{
  const double x = dealii::numbers::PI * place[0] / side_;
  const double y = dealii::numbers::PI * place[1] / side_;
  FlowState result;
  result.density = density_;
  result.velocity[0] = speed_ * std::sin(x) * std::cos(y);
  result.velocity[1] = -speed_ * std::cos(x) * std::sin(y);
  result.pressure = pressure_ + 0.25 * density_ * speed_ * speed_ *
                                  (std::cos(2. * x) + std::cos(2. * y));
  return result;
}
} // namespace contrecoup::ale
