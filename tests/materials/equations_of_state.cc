// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/materials/explosives.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace contrecoup;

namespace
{
constexpr double epsilon = std::numeric_limits<double>::epsilon();

const JwlParameters &tnt()
{
  return find_explosive("tnt").jwl;
}

/// Densities over the whole admissible range.
std::vector<double> densities(const double largest)
{
  std::vector<double> values;
  for (double density = 1e-6; density < largest; density *= 1.37)
    values.push_back(density);
  values.push_back(largest);
  return values;
}

/// Energies above the cold curve [J/kg].
const std::vector<double> heats{1e-3, 1., 1e3, 2e5, 4e6, 1e8, 1e11};

/// The size of the terms that sum up to the pressure, for round-off.
double pressure_scale(const JwlParameters &jwl,
                      const double density,
                      const double energy_density)
{
  const double volume = jwl.reference_density / density;
  return jwl.A * std::exp(-jwl.R1 * volume) +
         jwl.B * std::exp(-jwl.R2 * volume) + std::abs(energy_density);
}

/// dp/drho at fixed e and Y by central differences of fourth order.
template <typename Gas>
double pressure_slope(const Gas &gas,
                      const double density,
                      const double energy,
                      const double products,
                      const double step)
{
  const auto p = [&](const double rho) {
    return gas.pressure(rho, rho * energy, products);
  };
  return (8. * (p(density + step) - p(density - step)) -
          (p(density + 2. * step) - p(density - 2. * step))) /
         (12. * step);
}

/// The equation of state at one point of the admissible set: positivity,
/// inverse pairs, and c^2 = dp/drho|_e + p/rho^2 dp/de|_rho.
template <typename Gas>
void check_point(const Gas &gas,
                 const JwlParameters &jwl,
                 const double density,
                 const double heat,
                 const double products)
{
  double energy_density = density * heat;
  if constexpr (Gas::has_products)
    energy_density += gas.cold_energy_density(density, products);
  const double energy = energy_density / density;
  const double scale = pressure_scale(jwl, density, energy_density);
  SCOPED_TRACE("density " + std::to_string(density) + ", e - e_c " +
               std::to_string(heat) + ", products " + std::to_string(products));

  double p, c_squared;
  gas.pressure_and_sound_speed(density, energy_density, products, p, c_squared);
  EXPECT_GT(c_squared, 0.);
  EXPECT_EQ(p, gas.pressure(density, energy_density, products));
  EXPECT_EQ(c_squared, gas.sound_speed_squared(density, p, products));
  EXPECT_GT(gas.temperature(density, p, products), 0.);

  // The inverse amplifies the rounding of p by 1/omega, at most 5 here.
  double back, c_squared_back;
  gas.energy_and_sound_speed(density, p, products, back, c_squared_back);
  EXPECT_NEAR(back, energy_density, 40. * epsilon * scale);
  EXPECT_EQ(back, gas.internal_energy_density(density, p, products));
  EXPECT_EQ(c_squared_back, c_squared);

  // Rounding of p over the step; truncation h^4 p^(5) / 30, where each
  // derivative of the exponentials brings a factor of at most 5 / rho.
  const double step = 2e-4 * density;
  const double slope =
    pressure_slope(gas, density, energy, products, step) +
    p / (density * density) *
      (gas.pressure(density, 2. * energy_density, products) - p) / energy;
  const double rounding = 8. * epsilon * scale / step;
  const double truncation = 1e-9 * scale / density;
  EXPECT_NEAR(c_squared, slope, rounding + truncation);
}
} // namespace


TEST(IdealGas, AgreesWithItsDefinitionEverywhere)
{
  const IdealGas gas(1.4);
  for (const double density : densities(5000.))
    for (const double heat : heats)
    {
      check_point(gas, JwlParameters(), density, heat, 0.);
      EXPECT_DOUBLE_EQ(gas.pressure(density, density * heat, 0.),
                       0.4 * density * heat);
    }
  EXPECT_NEAR(gas.temperature(1.225, 101325., 0.), 288.15, 0.01);
  EXPECT_NEAR(
    std::sqrt(gas.sound_speed_squared(1.225, 101325., 0.)), 340.29, 0.01);
}


TEST(StiffenedGas, AgreesWithItsDefinitionEverywhere)
{
  const double gamma = 4.4, p_infinity = 6e8;
  const MieGrueneisen gas = MieGrueneisen::stiffened_gas(gamma, p_infinity);
  EXPECT_FALSE(gas.uses_products());
  for (const double density : densities(3000.))
    for (const double heat : heats)
    {
      const double energy_density = p_infinity + density * heat;
      const double p = gas.pressure(density, energy_density, 0.5);
      EXPECT_NEAR(p,
                  (gamma - 1.) * energy_density - gamma * p_infinity,
                  8. * epsilon * gamma * energy_density);
      EXPECT_NEAR(gas.sound_speed_squared(density, p, 0.5),
                  gamma * (p + p_infinity) / density,
                  8. * epsilon * gamma * energy_density / density);
      EXPECT_NEAR(gas.internal_energy_density(density, p, 0.5),
                  energy_density,
                  8. * epsilon * energy_density);
      EXPECT_EQ(gas.cold_energy_density(density, 0.5), p_infinity);
    }
}


TEST(StiffenedGas, IsTheIdealGasWithoutStiffening)
{
  const MieGrueneisen stiffened = MieGrueneisen::stiffened_gas(1.4, 0.);
  const IdealGas ideal(1.4);
  for (const double density : densities(100.))
    for (const double heat : heats)
    {
      double p, c_squared, p_ideal, c_squared_ideal;
      stiffened.pressure_and_sound_speed(
        density, density * heat, 0., p, c_squared);
      ideal.pressure_and_sound_speed(
        density, density * heat, 0., p_ideal, c_squared_ideal);
      EXPECT_DOUBLE_EQ(p, p_ideal);
      EXPECT_DOUBLE_EQ(c_squared, c_squared_ideal);
      EXPECT_NEAR(stiffened.temperature(density, p, 0.) /
                    ideal.temperature(density, p_ideal, 0.),
                  1.,
                  1e-14);
    }
}


TEST(Jwl, IsConsistentOverTheAdmissibleSet)
{
  for (const Explosive &explosive : explosive_library())
  {
    SCOPED_TRACE(explosive.name);
    const MieGrueneisen gas = MieGrueneisen::jwl(explosive.jwl);
    for (const double density : densities(3. * explosive.jwl.reference_density))
      for (const double heat : heats)
        check_point(gas, explosive.jwl, density, heat, 0.);
  }
}


TEST(Jwl, AgreesWithTheTextbookForm)
{
  const JwlParameters &jwl = tnt();
  const MieGrueneisen gas = MieGrueneisen::jwl(jwl);
  for (const double density : densities(3. * jwl.reference_density))
    for (const double heat : heats)
    {
      const double energy_density =
        gas.cold_energy_density(density, 1.) + density * heat;
      const double v = jwl.reference_density / density;
      const double textbook =
        jwl.A * (1. - jwl.omega / (jwl.R1 * v)) * std::exp(-jwl.R1 * v) +
        jwl.B * (1. - jwl.omega / (jwl.R2 * v)) * std::exp(-jwl.R2 * v) +
        jwl.omega * energy_density;
      EXPECT_NEAR(gas.pressure(density, energy_density, 1.),
                  textbook,
                  20. * epsilon * pressure_scale(jwl, density, energy_density));
    }
}


// Unreacted LX-17 (LANL's ExactPack, riemann_jwl): with B < 0 the least energy
// is where c^2 = 0, on either side of the cold curve.
TEST(Jwl, AdmitsTheStatesWithARealSoundSpeedWhereBIsNegative)
{
  JwlParameters jwl;
  jwl.A = 6.321e13;
  jwl.B = -4.472e9;
  jwl.R1 = 11.3;
  jwl.R2 = 1.13;
  jwl.omega = 0.8938;
  jwl.reference_density = 1905.;
  const MieGrueneisen gas = MieGrueneisen::jwl(jwl);
  for (const double density : densities(3. * jwl.reference_density))
  {
    const double least = gas.least_energy_density(density, 0.);
    const double margin = 1e-9 * pressure_scale(jwl, density, 1e6 * density);
    for (const double side : {-1., 1.})
      EXPECT_GT(
        side * gas.sound_speed_squared(
                 density, gas.pressure(density, least + side * margin, 0.), 0.),
        0.)
        << "density " << density;
  }
  EXPECT_GT(gas.least_energy_density(952.5, 0.),
            gas.cold_energy_density(952.5, 0.));
  EXPECT_LT(gas.least_energy_density(3810., 0.),
            gas.cold_energy_density(3810., 0.));
  for (const MieGrueneisen &convex :
       {MieGrueneisen::jwl(tnt()), MieGrueneisen::jwl_in_air(jwl)})
    EXPECT_EQ(convex.least_energy_density(1630., 0.5),
              convex.cold_energy_density(1630., 0.5));
}


// Figures worked out by hand for the TNT of Tan et al. (2017).
TEST(Jwl, GivesTheColdCurveOfTnt)
{
  const MieGrueneisen gas = MieGrueneisen::jwl(tnt());
  const auto cold = [&](const double density) {
    return gas.cold_energy_density(density, 1.) / density;
  };
  EXPECT_NEAR(cold(1630.), 1.91e6, 0.005e6);
  EXPECT_NEAR(cold(500.), 0.136e6, 0.0005e6);
  EXPECT_NEAR(cold(100.), 1.1, 0.05);
  EXPECT_LT(cold(50.), 1e-6);
  EXPECT_EQ(cold(16.), 0.);
  EXPECT_NEAR(gas.pressure(1630., 0., 1.), 6.33e9, 0.005e9);
}


TEST(JwlInAir, IsConsistentOverTheAdmissibleSet)
{
  const MieGrueneisen gas = MieGrueneisen::jwl_in_air(tnt());
  EXPECT_TRUE(gas.uses_products());
  for (const double products : {0., 1e-9, 0.01, 0.3, 0.8, 0.999, 1.})
    for (const double density : densities(3. * 1630.))
      for (const double heat : heats)
        check_point(gas, tnt(), density, heat, products);
}


TEST(JwlInAir, ContainsBothPureGases)
{
  const MieGrueneisen mixture = MieGrueneisen::jwl_in_air(tnt());
  const MieGrueneisen products = MieGrueneisen::jwl(tnt());
  const IdealGas air(1.4);
  for (const double density : densities(3. * 1630.))
    for (const double heat : heats)
    {
      const double energy_density =
        products.cold_energy_density(density, 1.) + density * heat;
      const double p_air = mixture.pressure(density, energy_density, 0.);
      EXPECT_DOUBLE_EQ(p_air, air.pressure(density, energy_density, 0.));
      EXPECT_NEAR(mixture.temperature(density, p_air, 0.) /
                    air.temperature(density, p_air, 0.),
                  1.,
                  1e-14);
      EXPECT_NEAR(mixture.pressure(density, energy_density, 1.),
                  products.pressure(density, energy_density, 1.),
                  20. * epsilon *
                    pressure_scale(tnt(), density, energy_density));
    }
}


TEST(JwlInAir, TakesMassFractionsBeyondTheirRangeAsTheNearestOne)
{
  const MieGrueneisen gas = MieGrueneisen::jwl_in_air(tnt());
  for (const double density : {0.01, 1.2, 50., 1630.})
  {
    const double energy_density = density * 4e6;
    EXPECT_EQ(gas.pressure(density, energy_density, -1e-6),
              gas.pressure(density, energy_density, 0.));
    EXPECT_EQ(gas.pressure(density, energy_density, 1. + 1e-6),
              gas.pressure(density, energy_density, 1.));
  }
}


// rho (e - bound) must be concave in (rho, rho u, rho E, rho Y), so that
// averages of admissible states are admissible: positivity limiting and
// projections rest on this.
TEST(JwlInAir, HasAConvexAdmissibleSet)
{
  const MieGrueneisen gas = MieGrueneisen::jwl_in_air(tnt());
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> unit(0., 1.);
  struct State
  {
    double density, momentum, energy, products;
  };
  const auto excess = [&](const State &s) {
    return s.energy - 0.5 * s.momentum * s.momentum / s.density -
           gas.cold_energy_density(s.density, s.products / s.density);
  };
  const auto sample = [&]() {
    const double density = 1e-3 * std::pow(5e6, unit(generator));
    const double velocity = 1e4 * (unit(generator) - 0.5);
    const double heat = 1e-3 * std::pow(1e12, unit(generator));
    const double bound = gas.cold_energy_density(density, 0.);
    return State{density,
                 density * velocity,
                 bound + density * (heat + 0.5 * velocity * velocity),
                 density * unit(generator)};
  };
  for (unsigned int i = 0; i < 100000; ++i)
  {
    const State a = sample(), b = sample();
    const double t = unit(generator);
    const State mean{t * a.density + (1. - t) * b.density,
                     t * a.momentum + (1. - t) * b.momentum,
                     t * a.energy + (1. - t) * b.energy,
                     t * a.products + (1. - t) * b.products};
    const double bound = t * excess(a) + (1. - t) * excess(b);
    ASSERT_GE(excess(mean), bound - 1e-13 * std::abs(mean.energy));
    const double energy_density =
      mean.energy - 0.5 * mean.momentum * mean.momentum / mean.density;
    double p, c_squared;
    gas.pressure_and_sound_speed(
      mean.density, energy_density, mean.products / mean.density, p, c_squared);
    ASSERT_GT(p, 0.);
    ASSERT_GT(c_squared, 0.);
  }
}


// A lane's value may not depend on its companions: not on whether another
// lane needs the exponentials or holds products.
TEST(JwlInAir, LanesAgreeWithPlainNumbers)
{
  using Number = Lanes<double>;
  const MieGrueneisen gas = MieGrueneisen::jwl_in_air(tnt());
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> unit(0., 1.);
  for (unsigned int i = 0; i < 2000; ++i)
  {
    Number density, energy_density, products, p, c_squared;
    for (unsigned int lane = 0; lane < Number::size(); ++lane)
    {
      density[lane] = 1e-3 * std::pow(5e6, unit(generator));
      products[lane] = unit(generator) < 0.5 ? 0. : unit(generator);
      energy_density[lane] = gas.cold_energy_density(density[lane], 1.) +
                             density[lane] * 1e7 * unit(generator);
    }
    gas.pressure_and_sound_speed(
      density, energy_density, products, p, c_squared);
    for (unsigned int lane = 0; lane < Number::size(); ++lane)
    {
      double plain_p, plain_c_squared;
      gas.pressure_and_sound_speed(double(density[lane]),
                                   double(energy_density[lane]),
                                   double(products[lane]),
                                   plain_p,
                                   plain_c_squared);
      const double scale =
        pressure_scale(tnt(), density[lane], energy_density[lane]);
      ASSERT_NEAR(p[lane], plain_p, 20. * epsilon * scale);
      ASSERT_NEAR(c_squared[lane],
                  plain_c_squared,
                  200. * epsilon * scale / density[lane]);
      if (products[lane] == 0.)
      {
        ASSERT_EQ(p[lane], plain_p);
      }
    }
  }
}


TEST(EquationsOfState, WorkInSinglePrecision)
{
  const MieGrueneisen gas = MieGrueneisen::jwl_in_air(tnt());
  for (const double density : {1e-3, 1.2, 60., 400., 1630., 3000.})
    for (const double products : {0., 0.4, 1.})
    {
      const double energy_density = density * 5e6;
      double p, c_squared;
      gas.pressure_and_sound_speed(
        density, energy_density, products, p, c_squared);
      Lanes<float> p_lanes, c_squared_lanes;
      gas.pressure_and_sound_speed(Lanes<float>(density),
                                   Lanes<float>(energy_density),
                                   Lanes<float>(products),
                                   p_lanes,
                                   c_squared_lanes);
      float p_float, c_squared_float;
      gas.pressure_and_sound_speed(float(density),
                                   float(energy_density),
                                   float(products),
                                   p_float,
                                   c_squared_float);
      const double scale = pressure_scale(tnt(), density, energy_density);
      EXPECT_NEAR(p_lanes[1], p, 1e-5 * scale);
      EXPECT_NEAR(p_float, p, 1e-5 * scale);
      EXPECT_NEAR(c_squared_lanes[2], c_squared, 1e-4 * scale / density);
      EXPECT_NEAR(c_squared_float, c_squared, 1e-4 * scale / density);
    }
}


// However slowly the exponentials decay, they are left out only where they do
// not count any more.
TEST(Jwl, KeepsSlowlyDecayingExponentials)
{
  JwlParameters jwl = tnt();
  jwl.R2 = 0.01;
  const MieGrueneisen gas = MieGrueneisen::jwl(jwl);
  for (const double volume : {10., 200., 1000., 5000., 8000.})
  {
    const double expected =
      jwl.B / jwl.R2 / volume * std::exp(-jwl.R2 * volume);
    EXPECT_NEAR(
      gas.cold_energy_density(1630. / volume, 1.) / expected, 1., 1e-6);
  }
}
