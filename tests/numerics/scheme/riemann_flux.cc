// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/exact/exact_riemann.h>
#include <contrecoup/numerics/scheme/riemann_flux.h>
#include <contrecoup/numerics/scheme/shear_factor.h>

#include "face_states.h"
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace contrecoup;

namespace
{
template <int dim>
FaceState<dim, double> mirrored(FaceState<dim, double> state)
{
  state.velocity[0] = -state.velocity[0];
  return state;
}
} // namespace


TEST(RiemannFlux, OfEqualStatesIsThatOfTheEulerEquations)
{
  RandomStates random;
  for (const GasMaterial &gas : {air(), mixture(), water()})
    for (unsigned int i = 0; i < 1000; ++i)
    {
      const auto state = random.state<3>(gas);
      const auto expected = components(internal::euler_flux(state));
      const auto scale = scales(state, state);
      for (const RiemannFlux kind : all_fluxes)
      {
        const auto flux = components(numerical_flux(kind, state, state, 1.));
        for (unsigned int c = 0; c < flux.size(); ++c)
          ASSERT_NEAR(flux[c], expected[c], 1e-14 * scale[c]) << c;
      }
    }
}


TEST(RiemannFlux, IsExactAtRest)
{
  RandomStates random;
  for (const GasMaterial &gas : {air(), mixture(), water()})
    for (unsigned int i = 0; i < 1000; ++i)
    {
      auto state = random.state<3>(gas);
      state = make_state<3>(
        gas, state.density, {{0., 0., 0.}}, state.pressure, state.products);
      const std::vector<double> expected{0., state.pressure, 0., 0., 0., 0.};
      for (const RiemannFlux kind : all_fluxes)
        for (const double factor : {0., 0.3, 1.})
          ASSERT_EQ(components(numerical_flux(kind, state, state, factor)),
                    expected);
    }
}


TEST(RiemannFlux, IsExactAtAContactAtRest)
{
  RandomStates random;
  for (const GasMaterial &gas : {air(), mixture(), water()})
    for (unsigned int i = 0; i < 1000; ++i)
    {
      const double pressure = 1e3 * std::pow(1e6, random.unit());
      const auto left =
        make_state<2>(gas, 1630., {{0., 0.}}, pressure + 7e9, 1.);
      const double density = 1e-3 * std::pow(3e6, random.unit());
      const auto right = make_state<2>(gas,
                                       density,
                                       {{0., 0.}},
                                       left.pressure,
                                       gas.has_products() ? random.unit() : 0.);
      for (const auto &flux : riemann_fluxes)
      {
        const auto found =
          components(numerical_flux(flux.kind, left, right, 1.));
        const std::vector<double> expected{0., left.pressure, 0., 0., 0.};
        EXPECT_EQ(found == expected, flux.keeps_contacts) << flux.name;
      }
    }
}


// A moving contact is carried with the gas: upwind density, energy and
// products, one pressure, to the rounding of p and rho u^2.
TEST(RiemannFlux, CarriesAMovingContact)
{
  for (const double velocity : {-400., 1e-3, 900., 4000.})
  {
    const auto left =
      make_state<2>(mixture(), 300., {{velocity, 20.}}, 5e7, 1.);
    const auto right =
      make_state<2>(mixture(), 0.3, {{velocity, -70.}}, 5e7, 0.);
    const auto expected =
      components(internal::euler_flux(velocity > 0. ? left : right));
    const auto scale = scales(left, right);
    for (const auto &description : riemann_fluxes)
    {
      if (!description.keeps_contacts)
        continue;
      const auto flux =
        components(numerical_flux(description.kind, left, right, 1.));
      for (unsigned int c = 0; c < flux.size(); ++c)
        EXPECT_NEAR(flux[c], expected[c], 1e-14 * scale[c]) << description.name;
    }
  }
}


TEST(RiemannFlux, TakesTheUpwindFluxInSupersonicFlow)
{
  RandomStates random;
  for (unsigned int i = 0; i < 1000; ++i)
  {
    auto left = random.state<3>(mixture());
    auto right = random.state<3>(mixture());
    const double speed = 20. * std::max(left.sound_speed, right.sound_speed) *
                         std::sqrt(std::max(left.density, right.density) /
                                   std::min(left.density, right.density));
    left = make_state<3>(mixture(),
                         left.density,
                         {{speed, left.velocity[1], left.velocity[2]}},
                         left.pressure,
                         left.products);
    right = make_state<3>(mixture(),
                          right.density,
                          {{speed, right.velocity[1], right.velocity[2]}},
                          right.pressure,
                          right.products);
    const auto expected = components(internal::euler_flux(left));
    const auto scale = scales(left, right);
    for (const auto &description : riemann_fluxes)
    {
      if (!description.is_upwind)
        continue;
      const auto flux =
        components(numerical_flux(description.kind, left, right, 1.));
      for (unsigned int c = 0; c < flux.size(); ++c)
        ASSERT_NEAR(flux[c], expected[c], 1e-13 * scale[c])
          << description.name << " " << c;
    }
  }
}


// The flux out of one side enters the other, whichever way the face is seen: in
// HLLC to the last bit, so that symmetric flows stay so.
TEST(RiemannFlux, IsMirrored)
{
  RandomStates random;
  for (const GasMaterial &gas : {air(), mixture()})
    for (unsigned int i = 0; i < 3000; ++i)
    {
      const auto left = random.state<3>(gas), right = random.state<3>(gas);
      for (const RiemannFlux kind : all_fluxes)
      {
        const auto flux = components(numerical_flux(kind, left, right, 0.7));
        auto other = components(
          numerical_flux(kind, mirrored(right), mirrored(left), 0.7));
        const bool is_exact = kind == RiemannFlux::hllc;
        const auto scale = scales(left, right);
        for (unsigned int c = 0; c < flux.size(); ++c)
          ASSERT_NEAR(flux[c],
                      c == 1 ? other[c] : -other[c],
                      is_exact ? 0. : 1e-14 * scale[c])
            << c;
      }
    }
}


TEST(RiemannFlux, ShockStableHllcIsHllcWithoutShocks)
{
  RandomStates random;
  for (unsigned int i = 0; i < 3000; ++i)
  {
    const auto left = random.state<3>(air()), right = random.state<3>(air());
    EXPECT_EQ(components(numerical_flux(RiemannFlux::hllc, left, right, 1.)),
              components(numerical_flux(
                RiemannFlux::hllc_shock_stable, left, right, 1.)));
  }
  // Otherwise it lies between HLLC and HLL, by the factor.
  const auto left = make_state<3>(air(), 1., {{0., 3., 0.}}, 1e5);
  const auto right = make_state<3>(air(), 4., {{-20., 0., 1.}}, 2e5);
  const auto flux = [&](const RiemannFlux kind) {
    return components(numerical_flux(kind, left, right, 0.25));
  };
  const auto hllc = flux(RiemannFlux::hllc), hll = flux(RiemannFlux::hll),
             stable = flux(RiemannFlux::hllc_shock_stable);
  for (unsigned int c = 0; c < hllc.size(); ++c)
    EXPECT_NEAR(stable[c],
                0.25 * hllc[c] + 0.75 * hll[c],
                1e-14 * scales(left, right)[c]);
}


TEST(RiemannFlux, AcceptsAVacuum)
{
  const FaceState<2, double> vacuum{0., {{0., 0.}}, 0., 0., 0., 0.};
  const auto gas = make_state<2>(air(), 1., {{0., 10.}}, 1e5);
  const auto leaving = make_state<2>(air(), 1., {{-900., 10.}}, 1e5);
  const auto arriving = make_state<2>(air(), 1., {{3e4, 10.}}, 1e5);
  for (const RiemannFlux kind : all_fluxes)
    for (const auto &state : {gas, leaving, arriving})
    {
      for (const double value :
           components(numerical_flux(kind, state, vacuum, 1.)))
        EXPECT_TRUE(std::isfinite(value));
      for (const double value :
           components(numerical_flux(kind, vacuum, state, 1.)))
        EXPECT_TRUE(std::isfinite(value));
      EXPECT_EQ(components(numerical_flux(kind, vacuum, vacuum, 1.)),
                (std::vector<double>{0., 0., 0., 0., 0.}));
    }
  EXPECT_GT(numerical_flux(RiemannFlux::hllc, gas, vacuum, 1.).mass, 0.);
}


// One first-order step at a Courant number of 1/2 keeps the density and the
// energy above the cold curve positive: random states with density ratios up
// to 3e6, colliding or receding.
TEST(RiemannFlux, KeepsStatesAdmissible)
{
  RandomStates random;
  for (const GasMaterial &gas : {air(), mixture(), products()})
    for (unsigned int i = 0; i < 20000; ++i)
    {
      const auto left = random.state<1>(gas), middle = random.state<1>(gas),
                 right = random.state<1>(gas);
      for (const RiemannFlux kind : all_fluxes)
      {
        const WaveSpeeds<double> a = wave_speeds(left, middle);
        const WaveSpeeds<double> b = wave_speeds(middle, right);
        const double fastest = std::max(std::max(std::abs(a.left), a.right),
                                        std::max(std::abs(b.left), b.right));
        const double ratio = 0.5 / std::max(fastest, middle.sound_speed);
        const auto in = numerical_flux(kind, left, middle, 1.);
        const auto out = numerical_flux(kind, middle, right, 1.);
        const double density = middle.density + ratio * (in.mass - out.mass);
        const double momentum = middle.density * middle.velocity[0] +
                                ratio * (in.momentum[0] - out.momentum[0]);
        const double energy =
          middle.energy_density + ratio * (in.energy - out.energy);
        const double products = middle.density * middle.products +
                                ratio * (in.products - out.products);
        ASSERT_GT(density, 0.);
        const double pressure =
          gas.pressure(density,
                       energy - 0.5 * momentum * momentum / density,
                       products / density);
        ASSERT_GT(gas.temperature(density, pressure, products / density), 0.);
        ASSERT_GT(
          gas.sound_speed_squared(density, pressure, products / density), 0.);
      }
    }
}


// The exact fronts lie within the speeds that are used, up to a tenth, and are
// not overestimated by much: gases with a density ratio of up to 1330 and a
// pressure ratio of up to 1e6, at rest and moving.
TEST(WaveSpeeds, ContainTheExactWaves)
{
  RandomStates random;
  for (const GasMaterial &gas : {air(), mixture()})
    for (unsigned int i = 0; i < 1000; ++i)
    {
      const double scale = i % 2 == 0 ? 0. : 1.;
      const auto state = [&]() {
        const double products = random.unit();
        const double density = std::pow(1330., random.unit());
        const double heat = 2e5 * std::pow(750., random.unit());
        const double p =
          gas.pressure(density,
                       cold_energy_density(gas, density) + density * heat,
                       products);
        const double c =
          std::sqrt(gas.sound_speed_squared(density, p, products));
        return make_state<1>(
          gas, density, {{scale * c * (2. * random.unit() - 1.)}}, p, products);
      };
      const auto left = state(), right = state();
      const auto plain = [](const FaceState<1, double> &s) {
        return RiemannState{s.density, s.velocity[0], s.pressure, s.products};
      };
      const ExactRiemann exact(plain(left), plain(right), gas);
      const WaveSpeeds<double> speeds = wave_speeds(left, right);
      const double left_front = left.velocity[0] - exact.left_head_speed();
      const double right_front = exact.right_head_speed() - right.velocity[0];
      const double left_used = left.velocity[0] - speeds.left;
      const double right_used = speeds.right - right.velocity[0];
      ASSERT_GE(left_used, 0.9 * left_front);
      ASSERT_GE(right_used, 0.9 * right_front);

      const double closing = left.velocity[0] - right.velocity[0];
      ASSERT_LE(left_used,
                2. * std::max(left_front, closing + right.sound_speed));
      ASSERT_LE(right_used,
                2. * std::max(right_front, closing + left.sound_speed));
    }
}


TEST(ShearFactor, ActsAlongShocksAlone)
{
  EXPECT_EQ(shear_factor(300., 0., 0.), 1.);
  EXPECT_EQ(shear_factor(300., -500., -100.), 1.);
  EXPECT_EQ(shear_factor(300., 200., 100.), 1.);
  EXPECT_DOUBLE_EQ(shear_factor(300., 0., -300.), 1. / 16.);
  EXPECT_EQ(shear_factor(0., 0., 0.), 0.);
  EXPECT_EQ(shear_factor(0., 300., 0., -300.), 1.);
  EXPECT_DOUBLE_EQ(shear_factor(0.5, 300., 0., -300.), 1. / 16.);
  EXPECT_NEAR(shear_factor(Lanes<double>(300.),
                           Lanes<double>(0.),
                           Lanes<double>(-300.))[0],
              1. / 16.,
              1e-15);
}


TEST(RiemannFlux, IsFoundByName)
{
  for (const auto &flux : riemann_fluxes)
    EXPECT_EQ(find_choice(riemann_fluxes, flux.name, "flux"), flux.kind);
  try
  {
    find_choice(riemann_fluxes, "hlcc", "flux");
    FAIL() << "no exception";
  }
  catch (const InputError &error)
  {
    EXPECT_NE(std::string(error.what()).find("hllc"), std::string::npos);
  }
}
