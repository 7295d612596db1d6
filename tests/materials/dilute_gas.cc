// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/materials/explosives.h>
#include <contrecoup/materials/mie_grueneisen.h>

#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
const JwlParameters &tnt_products()
{
  return find_explosive("tnt").jwl;
}

MieGrueneisen tnt_in_air()
{
  return MieGrueneisen::jwl_in_air(tnt_products());
}

// Where kernels take a mixture for a simpler gas, results must not depend on
// which other cells share the lanes.
template <typename Gas, typename Number>
void expect_mixture(const Gas &gas,
                    const Number &density,
                    const Number &pressure,
                    const Number &products)
{
  const auto expect_equal = [](const Number &a, const Number &b) {
    EXPECT_EQ(largest_lane(a - b), 0.);
    EXPECT_EQ(smallest_lane(a - b), 0.);
  };
  const MieGrueneisen mixture = tnt_in_air();
  Number energy, other_energy, square, other_square;
  mixture.energy_and_sound_speed(density, pressure, products, energy, square);
  gas.energy_and_sound_speed(
    density, pressure, products, other_energy, other_square);
  expect_equal(energy, other_energy);
  expect_equal(square, other_square);
  expect_equal(energy,
               gas.internal_energy_density(density, pressure, products));
  expect_equal(mixture.least_energy_density(density, products),
               gas.least_energy_density(density, products));
}

template <typename Number>
void expect_dilute_mixture(const Number &density, const Number &pressure)
{
  ASSERT_TRUE(tnt_in_air().is_dilute(density));
  for (const double products : {0., negligible_products<Number>, 1e-3, 0.4, 1.})
    expect_mixture(tnt_in_air().dilute(), density, pressure, Number(products));
}

template <typename Number>
void expect_traced_air(const Number &density, const Number &pressure)
{
  for (const double part : {0., 1e-3, 1.})
  {
    const Number products(part * negligible_products<Number>);
    ASSERT_TRUE(tnt_in_air().is_air(density, products));
    expect_mixture(tnt_in_air().air(), density, pressure, products);
  }
}

template <typename Number>
void expect_dilute_gases()
{
  for (const double density : {1e-3, 0.3, 1.2, 12.})
    for (const double pressure : {1., 1e5, 3.3e7})
    {
      expect_dilute_mixture<Number>(density, pressure);
      expect_traced_air<Number>(density, pressure);
    }
}
} // namespace


TEST(DiluteGases, AreTheMixtureToTheLastBit)
{
  expect_dilute_gases<double>();
  expect_dilute_gases<Lanes<double>>();
  expect_dilute_gases<float>();
  expect_dilute_gases<Lanes<float>>();
}


TEST(DiluteMixture, IsNotTakenForOtherGases)
{
  const MieGrueneisen mixture = tnt_in_air();
  EXPECT_TRUE(mixture.is_dilute(1.2));
  EXPECT_FALSE(mixture.is_dilute(100.));
  EXPECT_FALSE(MieGrueneisen::jwl(tnt_products()).is_dilute(1.2));
  EXPECT_FALSE(MieGrueneisen::stiffened_gas(1.4, 0.).is_dilute(1.2));
  Lanes<float> density(1.2f);
  EXPECT_TRUE(mixture.is_dilute(density));
  density[n_lanes<float> - 1] = 100.f;
  EXPECT_FALSE(mixture.is_dilute(density));
}


// omega is gas constant over specific heat, each weighted by mass.
TEST(DiluteMixture, MixesGasConstantsAndSpecificHeats)
{
  const double air_constant = 287.05287, air_heat = air_constant / 0.4;
  const JwlParameters jwl = tnt_products();
  const DiluteMixture dilute =
    MieGrueneisen::jwl_in_air(jwl, 1.4, air_constant).dilute();
  for (const double products : {0., 1e-9, 0.1, 0.5, 0.9, 1.})
  {
    const double omega =
      (products * jwl.omega * jwl.specific_heat +
       (1. - products) * air_constant) /
      (products * jwl.specific_heat + (1. - products) * air_heat);
    double energy, square;
    dilute.energy_and_sound_speed(2., 3e5, products, energy, square);
    EXPECT_NEAR(energy * omega, 3e5, 1e-13 * 3e5);
    EXPECT_NEAR(square, (1. + omega) * 1.5e5, 1e-13 * 1.5e5);
  }
}


TEST(TracedAir, IsNotTakenForOtherGases)
{
  const MieGrueneisen mixture = tnt_in_air();
  EXPECT_TRUE(mixture.is_air(1.2, 0.));
  EXPECT_FALSE(mixture.is_air(1.2, 1e-12));
  EXPECT_FALSE(mixture.is_air(100., 0.));
  EXPECT_FALSE(MieGrueneisen::jwl(tnt_products()).is_air(1.2, 0.));
  EXPECT_FALSE(MieGrueneisen::stiffened_gas(1.4, 0.).is_air(1.2, 0.));
  Lanes<float> products(0.f);
  EXPECT_TRUE(mixture.is_air(Lanes<float>(1.2f), products));
  products[n_lanes<float> - 1] = 1e-6f;
  EXPECT_FALSE(mixture.is_air(Lanes<float>(1.2f), products));
}
