// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/materials/tissue_library.h>

#include <gtest/gtest.h>

using namespace contrecoup;

// Computed from table 1 of the paper by hand.
TEST(TissueLibrary, WaveSpeedsOfThePaper)
{
  const auto expect_speeds = [](const Tissue tissue,
                                const double dilatational,
                                const double shear) {
    const TissueProperties found = find_tissue_properties("paper", tissue);
    EXPECT_NEAR(found.dilatational_speed(), dilatational, 1e-5 * dilatational);
    EXPECT_NEAR(found.shear_speed(), shear, 1e-5 * shear);
  };
  expect_speeds(Tissue::skeleton, 2473.64, 1322.21);
  expect_speeds(Tissue::brain, 1479.89, 7.000);
  expect_speeds(Tissue::soft_tissue, 414.039, 169.031);
  expect_speeds(Tissue::lung, 25.9437, 13.8675);
}


TEST(TissueLibrary, EverySetHasEveryTissueAndItsSource)
{
  for (const std::string &set : tissue_set_names())
    for (std::size_t i = 1; i <= std::size_t(Tissue::polycarbonate); ++i)
    {
      const TissueProperties &found =
        find_tissue_properties(set, static_cast<Tissue>(i));
      EXPECT_EQ(found.tissue, static_cast<Tissue>(i));
      EXPECT_GT(found.density, 50.);
      EXPECT_LT(found.density, 2000.);
      EXPECT_GT(found.bulk_modulus, 0.);
      EXPECT_GE(found.instantaneous_shear, found.long_term_shear);
      EXPECT_EQ(found.relaxation_time > 0.,
                found.instantaneous_shear > found.long_term_shear)
        << set << ": " << name_of(found.tissue);
      EXPECT_FALSE(found.source.empty());
    }
}


TEST(TissueLibrary, AeratedLungIsAllThatDiffersFromThePaper)
{
  for (std::size_t i = 1; i <= std::size_t(Tissue::polycarbonate); ++i)
  {
    const Tissue tissue = static_cast<Tissue>(i);
    const bool is_lung = tissue == Tissue::lung;
    const TissueProperties one =
      find_tissue_properties("paper with aerated lung", tissue);
    const TissueProperties other =
      find_tissue_properties(is_lung ? "physiological" : "paper", tissue);
    EXPECT_EQ(one.gas.exists(), is_lung);
    EXPECT_EQ(one.density, other.density);
    EXPECT_EQ(one.bulk_modulus, other.bulk_modulus);
    EXPECT_EQ(one.instantaneous_shear, other.instantaneous_shear);
    EXPECT_EQ(one.source, other.source);
  }
}


// Sound is 1480 to 1620 m/s fast in tissue that is mostly water.
TEST(TissueLibrary, PhysiologicalSoundSpeeds)
{
  for (const Tissue tissue : {Tissue::soft_tissue,
                              Tissue::skin,
                              Tissue::brain,
                              Tissue::cerebrospinal_fluid,
                              Tissue::heart,
                              Tissue::liver,
                              Tissue::water,
                              Tissue::gelatin})
  {
    const double speed =
      find_tissue_properties("physiological", tissue).dilatational_speed();
    EXPECT_GT(speed, 1465.) << name_of(tissue);
    EXPECT_LT(speed, 1625.) << name_of(tissue);
  }
}


TEST(TissueLibrary, NamesAreFoundAndWrongOnesRefused)
{
  for (const std::string &name : tissue_names())
    EXPECT_EQ(name_of(find_tissue(name)), name);
  EXPECT_THROW(find_tissue("bone marrow"), InputError);
  EXPECT_THROW(find_tissue_properties("papr", Tissue::lung), InputError);
  EXPECT_THROW(find_tissue_properties("paper", Tissue::none), InputError);
}
