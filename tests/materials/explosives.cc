// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/materials/custom_explosive.h>
#include <contrecoup/materials/mie_grueneisen.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>
#include <string>

using namespace contrecoup;

// Recomputed by hand for each set, in m/s and GPa.
TEST(Explosives, ReproduceTheirChapmanJouguetState)
{
  struct Expected
  {
    double speed, pressure;
  };
  const std::map<std::string, Expected> expected{
    {"tnt", {6930., 21.00}},
    {"tnt dobratz", {6929., 21.00}},
    {"c-4", {8193., 28.00}},
    {"composition b", {7980., 29.50}},
    {"petn 1.77", {8301., 33.51}},
    {"petn 1.50", {7453., 22.00}},
    {"anfo", {4159., 5.15}},
    {"pentolite", {7530., 25.50}}};
  EXPECT_EQ(explosive_library().size(), expected.size());
  for (const Explosive &explosive : explosive_library())
  {
    SCOPED_TRACE(explosive.name);
    const ChapmanJouguetState cj = chapman_jouguet(explosive.jwl);
    const Expected &values = expected.at(explosive.name);
    EXPECT_NEAR(cj.detonation_speed, values.speed, 0.6);
    EXPECT_NEAR(cj.pressure, values.pressure * 1e9, 0.005e9);
    // The published figures, which have three or four digits.
    EXPECT_NEAR(cj.detonation_speed / explosive.detonation_speed, 1., 6e-4);
    EXPECT_NEAR(cj.pressure / explosive.cj_pressure, 1., 6e-4);
    EXPECT_FALSE(explosive.source.empty());
  }
}

TEST(Explosives, HaveTheirNamesInTexts)
{
  std::string titles;
  for (const Explosive &explosive : explosive_library())
    titles += explosive.title + "; ";
  EXPECT_EQ(titles,
            "TNT; TNT Dobratz; C-4; composition B; PETN 1.77; PETN 1.50; ANFO; "
            "pentolite; ");
}

// Mass, momentum and energy over the front, the sonic condition, and that no
// other state on the Hugoniot curve belongs to a slower detonation.
TEST(Explosives, ChapmanJouguetStateObeysItsDefinition)
{
  for (const Explosive &explosive : explosive_library())
  {
    SCOPED_TRACE(explosive.name);
    const JwlParameters &jwl = explosive.jwl;
    const MieGrueneisen gas = MieGrueneisen::jwl(jwl);
    const ChapmanJouguetState cj = chapman_jouguet(jwl);
    const double rho_0 = jwl.reference_density, D = cj.detonation_speed;
    EXPECT_NEAR(rho_0 * D / (cj.density * (D - cj.velocity)), 1., 1e-13);
    EXPECT_NEAR(cj.pressure / (rho_0 * D * cj.velocity), 1., 1e-13);
    const double energy =
      gas.internal_energy_density(cj.density, cj.pressure, 1.) / cj.density;
    EXPECT_NEAR(energy,
                jwl.energy_density / rho_0 +
                  0.5 * cj.pressure * (1. / rho_0 - 1. / cj.density),
                1e-12 * energy);
    EXPECT_NEAR(
      std::sqrt(gas.sound_speed_squared(cj.density, cj.pressure, 1.)) +
        cj.velocity,
      D,
      1e-9 * D);

    for (const double factor : {0.9, 0.97, 1.03, 1.1})
    {
      const double density = factor * cj.density;
      const double e_0 = jwl.energy_density * density / rho_0;
      const double strain = 1. - rho_0 / density;
      const double pressure = gas.pressure(density, e_0, 1.) /
                              (1. - 0.5 * jwl.omega * strain * density / rho_0);
      EXPECT_GT(std::sqrt(pressure / (rho_0 * strain)), D);
    }
  }
}

TEST(Explosives, AreFoundByName)
{
  std::set<std::string> names;
  for (const std::string &name : explosive_names())
  {
    EXPECT_TRUE(names.insert(name).second);
    EXPECT_EQ(find_explosive(name).name, name);
  }
  EXPECT_EQ(find_explosive("tnt").jwl.reference_density, 1630.);
  EXPECT_NEAR(
    find_explosive("tnt").jwl.energy_density / 1630., 3.68e6, 0.005e6);
}

TEST(Explosives, RefuseAnUnknownName)
{
  try
  {
    find_explosive("c4");
    FAIL() << "no exception";
  }
  catch (const InputError &error)
  {
    EXPECT_NE(std::string(error.what()).find("c-4"), std::string::npos);
  }
}

TEST(Explosives, RefuseConstantsWithoutDetonation)
{
  JwlParameters inert = find_explosive("tnt").jwl;
  inert.A = 0.;
  inert.B = 0.;
  inert.energy_density = 0.;
  EXPECT_THROW(chapman_jouguet(inert), InputError);
}

TEST(Explosives, AreComparedWithWhatIsPublished)
{
  Explosive explosive = find_explosive("c-4");
  const std::string good = describe_detonation(explosive);
  EXPECT_NE(good.find("8193"), std::string::npos);
  EXPECT_EQ(good.find("warning"), std::string::npos);

  explosive.jwl.energy_density *= 1.05;
  EXPECT_NE(describe_detonation(explosive).find("warning"), std::string::npos);

  explosive.detonation_speed = 0.;
  explosive.cj_pressure = 0.;
  EXPECT_EQ(describe_detonation(explosive).find("published"),
            std::string::npos);
}


// Heats of combustion from enthalpies of formation, by hand, in MJ/kg: TNT
// (7 * 393.5 + 2.5 * 241.8 - 63) / 227.1, PETN (5 * 393.5 + 4 * 241.8 - 538) /
// 316.1.
TEST(Explosives, ReleaseNoMoreByAfterburnThanByCombustion)
{
  const double tnt = (7. * 393.5 + 2.5 * 241.8 - 63.) / 227.1;
  const double petn = (5. * 393.5 + 4. * 241.8 - 538.) / 316.1;
  EXPECT_NEAR(
    find_explosive("tnt").afterburn.largest, 1e6 * (tnt - 6000. / 1630.), 1e5);
  EXPECT_NEAR(find_explosive("petn 1.77").afterburn.largest,
              1e6 * (petn - 10100. / 1770.),
              1e5);
  for (const Explosive &explosive : explosive_library())
  {
    SCOPED_TRACE(explosive.name);
    EXPECT_GE(explosive.afterburn.energy, 0.);
    EXPECT_LE(explosive.afterburn.energy, explosive.afterburn.largest);
    EXPECT_FALSE(explosive.afterburn.source.empty());
    EXPECT_GT(explosive.tnt.pressure, 0.4);
    EXPECT_LT(explosive.tnt.pressure, 1.5);
  }
  EXPECT_EQ(find_explosive("tnt").afterburn.energy, 3.5e6);
  EXPECT_EQ(find_explosive("anfo").afterburn.energy, 0.);
  EXPECT_NEAR(
    find_explosive("anfo").tnt.impulse, 2.484 / 0.931 / (7. / 1.63), 1e-12);
}


namespace
{
CustomExplosive custom_with(const std::vector<std::string> &lines)
{
  dealii::ParameterHandler prm;
  CustomExplosive::declare_parameters(prm);
  set_entries(prm, lines);
  CustomExplosive custom;
  custom.parse_parameters(prm, "Charge/Custom explosive");
  return custom;
}
} // namespace

TEST(CustomExplosive, KeepsWhatDoesNotDependOnTheChange)
{
  const CustomExplosive same = custom_with({"Like=c-4"});
  EXPECT_TRUE(same.changes.empty());
  EXPECT_EQ(same.explosive.detonation_speed, 8193.);
  EXPECT_EQ(same.explosive.tnt.pressure, 1.37);
  EXPECT_TRUE(same.explosive.tnt.is_published);

  const CustomExplosive stiffer = custom_with({"Like=c-4", "A=650e9"});
  ASSERT_EQ(stiffer.changes.size(), 1U);
  EXPECT_EQ(stiffer.changes[0].entry, "A");
  EXPECT_EQ(stiffer.changes[0].before, find_explosive("c-4").jwl.A);
  // The published speed is that of the published constants.
  EXPECT_EQ(stiffer.explosive.detonation_speed, 0.);
  EXPECT_EQ(stiffer.explosive.tnt.pressure, 1.37);
}

// A density that differs by a millionth does not change the equivalence by
// more, whatever the explosive is like.
TEST(CustomExplosive, HasAnEquivalenceWithoutJumps)
{
  for (const Explosive &like : explosive_library())
  {
    std::ostringstream density;
    density << std::setprecision(12)
            << like.jwl.reference_density * (1. + 1e-6);
    const TntEquivalence tnt =
      custom_with({"Like=" + like.name, "Density=" + density.str()})
        .explosive.tnt;
    EXPECT_NEAR(tnt.pressure / like.tnt.pressure, 1. - 1e-6, 1e-10)
      << like.name;
    EXPECT_NEAR(tnt.impulse / like.tnt.impulse, 1. - 1e-6, 1e-10) << like.name;
  }
}

TEST(Explosives, AreCheckedForTheirAfterburn)
{
  const Explosive tnt = find_explosive("tnt"), anfo = find_explosive("anfo");
  for (const double energy : {0., 1e4, 3.5e6, tnt.afterburn.largest})
    EXPECT_NO_THROW(check_afterburn(tnt, energy, "Energy"));
  for (const double energy : {2., 9e3, 1.001 * tnt.afterburn.largest})
    EXPECT_THROW(check_afterburn(tnt, energy, "Energy"), InputError);
  EXPECT_NO_THROW(check_afterburn(anfo, 0., "Energy"));
  EXPECT_THROW(check_afterburn(anfo, 3.5e6, "Energy"), InputError);
  for (const Explosive &explosive : explosive_library())
    EXPECT_NO_THROW(
      check_afterburn(explosive, explosive.afterburn.energy, "Energy"));
}

TEST(CustomExplosive, TakesTheEquivalenceFromItsEnergy)
{
  const CustomExplosive weak =
    custom_with({"Like=c-4", "Energy density=6.7e9"});
  const double energy = 6.7e9 / 1601.;
  EXPECT_NEAR(weak.explosive.tnt.pressure, 1.37 * 6.7 / 9., 1e-12);
  EXPECT_NEAR(weak.explosive.tnt.impulse, 1.19 * 6.7 / 9., 1e-12);
  EXPECT_FALSE(weak.explosive.tnt.is_published);
  const Explosive c4 = find_explosive("c-4");
  EXPECT_NEAR(weak.explosive.afterburn.largest + energy,
              c4.afterburn.largest + 9e9 / 1601.,
              1.);
}
