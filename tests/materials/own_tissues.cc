// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/new_tissues.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/materials/own_tissues.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
/// Tissues of "Tissue NAME/ENTRY=VALUE".
OwnTissues read(const std::vector<std::string> &entries)
{
  ParameterHandler prm;
  {
    const Section section(prm, "Materials");
    OwnTissues::declare_parameters(prm);
  }
  set_entries(prm, entries, "Materials/Tissue ");
  // Entries that a run writes are read again as they were.
  ParameterHandler again;
  {
    const Section section(again, "Materials");
    OwnTissues::declare_parameters(again);
  }
  apply_assignments(assignments_of(prm), again);
  EXPECT_EQ(parameter_text(prm, false), parameter_text(again, false));
  OwnTissues own;
  own.parse_parameters(again, "Materials");
  return own;
}


SolidMaterial physiological(const Tissue tissue, const OwnTissues &own)
{
  return find_solid_material("physiological", tissue, own);
}


std::string refusal(const std::vector<std::string> &entries)
{
  try
  {
    const OwnTissues own = read(entries);
    for (const Tissue tissue : own.tissues())
      physiological(tissue, own);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace


TEST(OwnTissues, AnEntryChangesItselfAlone)
{
  const SolidMaterial library = physiological(Tissue::brain, {});
  const OwnTissues own = read({"Brain/Shear modulus=40e3"});
  const SolidMaterial changed = physiological(Tissue::brain, own);
  EXPECT_EQ(changed.instantaneous_shear, 40e3);
  EXPECT_EQ(changed.density, library.density);
  EXPECT_EQ(changed.bulk_modulus, library.bulk_modulus);
  EXPECT_EQ(changed.relaxing_shear, library.relaxing_shear);
  EXPECT_EQ(changed.relaxation_time, library.relaxation_time);
  EXPECT_EQ(own.changes_in_words(Tissue::brain, library),
            "Shear modulus = 4e+04 Pa instead of 4.1e+04");
  EXPECT_EQ(own.changes_in_words(Tissue::skin, library), "");
}


TEST(OwnTissues, YoungsModulusKeepsPoissonsRatio)
{
  const SolidMaterial bone =
    physiological(Tissue::skeleton, read({"skeleton/Young's modulus=16e9"}));
  const SolidMaterial library = physiological(Tissue::skeleton, {});
  EXPECT_NEAR(bone.bulk_modulus, 2. * library.bulk_modulus, 1.);
  EXPECT_NEAR(bone.instantaneous_shear, 2. * library.instantaneous_shear, 1.);
}


TEST(OwnTissues, GasOfTheLungStays)
{
  const SolidMaterial library = physiological(Tissue::lung, {});
  const SolidMaterial lung =
    physiological(Tissue::lung, read({"lung/Bulk modulus=0.38e6"}));
  EXPECT_EQ(lung.gas.gas_fraction(), library.gas.gas_fraction());
  EXPECT_EQ(lung.gas.exponent(), library.gas.exponent());
  EXPECT_NEAR(lung.gas.max_stiffness() * lung.bulk_modulus, 2.2e9, 1.);
  EXPECT_FALSE(
    physiological(Tissue::lung, read({"lung/Gas part=0"})).gas.exists());
}


TEST(OwnTissues, ANewNameNeedsDensityAndModuli)
{
  const OwnTissues own = read(
    {"foam/Density=100", "foam/Bulk modulus=1e6", "foam/Shear modulus=1e5"});
  ASSERT_EQ(own.tissues().size(), 1U);
  const Tissue foam = own.tissues()[0];
  EXPECT_TRUE(is_new(foam));
  EXPECT_EQ(find_tissue("foam"), foam);
  EXPECT_EQ(name_of(foam), "foam");
  const SolidMaterial material = physiological(foam, own);
  EXPECT_EQ(material.density, 100.);
  EXPECT_FALSE(material.is_viscoelastic());
  EXPECT_FALSE(material.gas.exists());
  // A tissue of one run of a process has no properties in the next one.
  EXPECT_THROW(physiological(foam, {}), InputError);
  EXPECT_NE(refusal({"cork/Density=100"}).find("Bulk modulus, Shear modulus"),
            std::string::npos);
}


TEST(OwnTissues, RefusesContradictionsAndWhatHasNoEffect)
{
  EXPECT_NE(refusal({"brain/Shear modulus=2000"})
              .find("3.32e+04 Pa of the library exceeds"),
            std::string::npos)
    << refusal({"brain/Shear modulus=2000"});
  EXPECT_NE(refusal({"skin/Relaxation time=1e-3"}).find("has no effect"),
            std::string::npos);
  EXPECT_NE(refusal({"skin/Gas exponent=1"}).find("no effect without gas"),
            std::string::npos);
  EXPECT_NE(refusal({"lung/Modulus without gas=1e5"})
              .find("must be at least the bulk modulus"),
            std::string::npos);
  EXPECT_NE(refusal({"gelatin/Poisson's ratio=0.5"}).find("0.499999"),
            std::string::npos)
    << refusal({"gelatin/Poisson's ratio=0.5"});
  EXPECT_EQ(refusal({"gelatin/Poisson's ratio=0.499999"}), "");
  EXPECT_NE(refusal({"brain/Density=1", "Brain/Bulk modulus=1"})
              .find("a second section of this tissue"),
            std::string::npos);
}
