// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/base/parameters/parameters.h>

#include <cmath>

namespace contrecoup::ale
{
namespace
{
  void declare_water_hammer(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Density",
                   "1000",
                   1e-6,
                   1e6,
                   "kg/m^3",
                   "Density of the liquid at zero pressure.");
    declare_double(prm,
                   "Bulk modulus",
                   "2.2e9",
                   1.,
                   1e15,
                   "Pa",
                   "K_0 of the Tait equation.");
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

  ExactFlow read_water_hammer(const ParameterHandler &prm)
  {
    const double density = read_double(prm, "Density");
    const double speed = read_double(prm, "Speed");
    const double modulus = read_double(prm, "Bulk modulus");
    const double n = read_double(prm, "Exponent");
    // Integral of c d(rho) / rho with c^2 = K_0 / rho_0 (rho / rho_0)^(n-1).
    const double sound_speed = std::sqrt(modulus / density);
    const double ratio =
      std::pow(1. + 0.5 * (n - 1.) * speed / sound_speed, 2. / (n - 1.));
    const double pressure = modulus / n * (std::pow(ratio, n) - 1.);
    const double front_speed = speed / (ratio - 1.);
    return {[=](const dealii::Point<3> &place, const double time) {
      const bool is_stopped = place[0] < front_speed * time;
      FlowState result;
      result.density = is_stopped ? ratio * density : density;
      result.velocity[0] = is_stopped ? 0. : -speed;
      result.pressure = is_stopped ? pressure : 0.;
      return result;
    }};
  }
} // namespace


FlowKind water_hammer_flow()
{
  return {
    "water hammer", "Water hammer", declare_water_hammer, read_water_hammer};
}
} // namespace contrecoup::ale
