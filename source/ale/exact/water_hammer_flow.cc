// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/water_hammer_flow.h>
#include <contrecoup/base/parameters/parameters.h>

#include <cmath>

namespace contrecoup::ale
{
void WaterHammerFlow::declare_parameters(ParameterHandler &prm)
{
  declare_double(prm,
                 "Density",
                 "1000",
                 1e-6,
                 1e6,
                 "kg/m^3",
                 "Density of the liquid at zero pressure.");
  declare_double(
    prm, "Bulk modulus", "2.2e9", 1., 1e15, "Pa", "K_0 of the Tait equation.");
  declare_double(
    prm, "Exponent", "7.15", 1.0001, 100., "-", "n of the Tait equation.");
  declare_double(prm,
                 "Speed",
                 "3",
                 1e-6,
                 1e6,
                 "m/s",
                 "Speed of the liquid towards the wall.");
}


std::unique_ptr<ExactFlow> WaterHammerFlow::create(const ParameterHandler &prm)
{
  auto flow = std::make_unique<WaterHammerFlow>();
  flow->density_ = read_double(prm, "Density");
  flow->speed_ = read_double(prm, "Speed");
  const double modulus = read_double(prm, "Bulk modulus");
  const double n = read_double(prm, "Exponent");
  // Integral of c d(rho) / rho with c^2 = K_0 / rho_0 (rho / rho_0)^(n-1).
  const double sound_speed = std::sqrt(modulus / flow->density_);
  const double ratio =
    std::pow(1. + 0.5 * (n - 1.) * flow->speed_ / sound_speed, 2. / (n - 1.));
  flow->stopped_density_ = ratio * flow->density_;
  flow->pressure_ = modulus / n * (std::pow(ratio, n) - 1.);
  flow->front_speed_ = flow->speed_ / (ratio - 1.);
  return flow;
}


FlowState WaterHammerFlow::value(const dealii::Point<3> &place,
                                 const double time) const
{
  FlowState result;
  const bool is_stopped = place[0] < front_speed_ * time;
  result.density = is_stopped ? stopped_density_ : density_;
  result.velocity[0] = is_stopped ? 0. : -speed_;
  result.pressure = is_stopped ? pressure_ : 0.;
  return result;
}
} // namespace contrecoup::ale
