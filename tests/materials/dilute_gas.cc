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

// Where kernels take products in air for dilute, results must not depend on
// which other cells share the lanes.
template <typename Number>
void expect_dilute_mixture(const Number &density, const Number &pressure)
{
  const MieGrueneisen mixture = MieGrueneisen::jwl_in_air(tnt_products());
  const DiluteMixture dilute = mixture.dilute();
  ASSERT_TRUE(mixture.is_dilute(density));
  for (const double part : {0., negligible_products<Number>, 1e-3, 0.4, 1.})
  {
    const Number products(part);
    Number energy, other_energy, square, other_square;
    mixture.energy_and_sound_speed(density, pressure, products, energy, square);
    dilute.energy_and_sound_speed(
      density, pressure, products, other_energy, other_square);
    EXPECT_EQ(largest_lane(energy - other_energy), 0.);
    EXPECT_EQ(smallest_lane(energy - other_energy), 0.);
    EXPECT_EQ(largest_lane(square - other_square), 0.);
    EXPECT_EQ(smallest_lane(square - other_square), 0.);
    other_energy = dilute.internal_energy_density(density, pressure, products);
    EXPECT_EQ(largest_lane(energy - other_energy), 0.);
    EXPECT_EQ(smallest_lane(energy - other_energy), 0.);
    EXPECT_EQ(largest_lane(mixture.cold_energy_density(density, products) -
                           dilute.cold_energy_density(density, products)),
              0.);
  }
}

} // namespace

TEST(DiluteMixture, IsTheMixtureToTheLastBit)
{
  for (const double density : {1e-3, 0.3, 1.2, 12.})
    for (const double pressure : {1., 1e5, 3.3e7})
    {
      expect_dilute_mixture<double>(density, pressure);
      expect_dilute_mixture<Lanes<double>>(density, pressure);
      expect_dilute_mixture<float>(density, pressure);
      expect_dilute_mixture<Lanes<float>>(density, pressure);
    }
}

TEST(DiluteMixture, IsNotTakenForOtherGases)
{
  const MieGrueneisen mixture = MieGrueneisen::jwl_in_air(tnt_products());
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

namespace
{
// Where kernels take air that carries hardly any products for air, results
// must not depend on which other cells share the lanes.
template <typename Number>
void expect_traced_air(const Number &density, const Number &pressure)
{
  const MieGrueneisen mixture = MieGrueneisen::jwl_in_air(tnt_products());
  const TracedAir air = mixture.air();
  for (const double part : {0., 1e-3, 1.})
  {
    const Number products(part * negligible_products<Number>);
    ASSERT_TRUE(mixture.is_air(density, products));
    Number energy, other_energy, square, other_square;
    mixture.energy_and_sound_speed(density, pressure, products, energy, square);
    air.energy_and_sound_speed(
      density, pressure, products, other_energy, other_square);
    EXPECT_EQ(largest_lane(energy - other_energy), 0.);
    EXPECT_EQ(smallest_lane(energy - other_energy), 0.);
    EXPECT_EQ(largest_lane(square - other_square), 0.);
    EXPECT_EQ(smallest_lane(square - other_square), 0.);
    EXPECT_EQ(largest_lane(mixture.cold_energy_density(density, products) -
                           air.cold_energy_density(density, products)),
              0.);
  }
}

} // namespace

TEST(TracedAir, IsTheMixtureToTheLastBit)
{
  for (const double density : {1e-3, 0.3, 1.2, 12.})
    for (const double pressure : {1., 1e5, 3.3e7})
    {
      expect_traced_air<double>(density, pressure);
      expect_traced_air<Lanes<double>>(density, pressure);
      expect_traced_air<float>(density, pressure);
      expect_traced_air<Lanes<float>>(density, pressure);
    }
}

TEST(TracedAir, IsNotTakenForOtherGases)
{
  const MieGrueneisen mixture = MieGrueneisen::jwl_in_air(tnt_products());
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
