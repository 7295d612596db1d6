// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/explosives.h>
#include <contrecoup/materials/gas_material.h>
#include <contrecoup/numerics/scheme/riemann_flux.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

/**
 * @file
 * Gases, random states on both sides of a face, and fluxes as lists of
 * numbers, for the tests of Riemann fluxes.
 */

namespace contrecoup
{
inline const std::vector<RiemannFlux> all_fluxes = [] {
  std::vector<RiemannFlux> kinds;
  for (const RiemannFluxDescription &flux : riemann_fluxes)
    kinds.push_back(flux.kind);
  return kinds;
}();

inline const GasMaterial &air()
{
  static const GasMaterial gas{IdealGas(1.4)};
  return gas;
}

inline const GasMaterial &mixture()
{
  static const GasMaterial gas{
    MieGrueneisen::jwl_in_air(find_explosive("tnt").jwl)};
  return gas;
}

inline const GasMaterial &products()
{
  static const GasMaterial gas{MieGrueneisen::jwl(find_explosive("tnt").jwl)};
  return gas;
}

inline const GasMaterial &water()
{
  static const GasMaterial gas{MieGrueneisen::stiffened_gas(4.4, 6e8)};
  return gas;
}

template <int dim>
FaceState<dim, double> make_state(const GasMaterial &gas,
                                  const double density,
                                  const std::array<double, dim> &velocity,
                                  const double pressure,
                                  const double products = 0.)
{
  double square = 0.;
  for (const double v : velocity)
    square += v * v;
  return {density,
          velocity,
          pressure,
          gas.internal_energy_density(density, pressure, products) +
            0.5 * density * square,
          std::sqrt(gas.sound_speed_squared(density, pressure, products)),
          products};
}

/// rho e of the cold curve [J/m^3].
inline double cold_energy_density(const GasMaterial &gas, const double density)
{
  const auto *const model = std::get_if<MieGrueneisen>(&gas.model());
  return model == nullptr ? 0. : model->cold_energy_density(density, 1.);
}

/// States over the whole range that blast problems reach.
class RandomStates
{
public:
  template <int dim>
  FaceState<dim, double> state(const GasMaterial &gas)
  {
    const double density = 1e-3 * std::pow(3e6, unit_(generator_));
    const double products = unit_(generator_);
    const double energy = cold_energy_density(gas, density) +
                          density * std::pow(10., 3. + 4. * unit_(generator_));
    std::array<double, dim> velocity;
    for (double &v : velocity)
      v = 8000. * (unit_(generator_) - 0.5);
    return make_state<dim>(gas,
                           density,
                           velocity,
                           gas.pressure(density, energy, products),
                           products);
  }

  double unit()
  {
    return unit_(generator_);
  }

private:
  std::mt19937 generator_{11};
  std::uniform_real_distribution<double> unit_{0., 1.};
};

/// Components in the order mass, momentum, energy, products.
template <int dim, typename Number>
std::vector<Number> components(const FaceFlux<dim, Number> &flux)
{
  std::vector<Number> result{flux.mass};
  result.insert(result.end(), flux.momentum.begin(), flux.momentum.end());
  result.push_back(flux.energy);
  result.push_back(flux.products);
  return result;
}

/// The size of the terms that sum up to each component of a flux.
template <int dim>
std::vector<double> scales(const FaceState<dim, double> &a,
                           const FaceState<dim, double> &b)
{
  const double speed = std::abs(a.velocity[0]) + std::abs(b.velocity[0]) +
                       a.sound_speed + b.sound_speed;
  const double density = a.density + b.density;
  const double pressure = std::abs(a.pressure) + std::abs(b.pressure);
  std::vector<double> result{density * speed};
  for (unsigned int d = 0; d < dim; ++d)
    result.push_back(
      pressure + density * speed *
                   (speed + std::abs(a.velocity[d]) + std::abs(b.velocity[d])));
  result.push_back(
    (a.energy_density + b.energy_density + pressure + density * speed * speed) *
    speed);
  result.push_back(density * speed);
  return result;
}
} // namespace contrecoup
