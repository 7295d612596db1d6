// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/materials/explosives.h>
#include <contrecoup/materials/gas_material.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace contrecoup;

namespace
{
GasMaterial parse(const std::string &entries)
{
  dealii::ParameterHandler prm;
  GasMaterial::declare_parameters(prm);
  prm.parse_input_from_string("subsection Material\n" + entries + "end\n");
  GasMaterial material;
  material.parse_parameters(prm);
  return material;
}
} // namespace

TEST(GasMaterial, IsAirByDefault)
{
  const GasMaterial material = parse("");
  ASSERT_TRUE(material.is_ideal());
  EXPECT_EQ(material.ideal().gamma(), 1.4);
  EXPECT_FALSE(material.has_products());
  EXPECT_EQ(material.reference_density(), 0.);
  EXPECT_EQ(material.reference_energy(), 0.);
  EXPECT_EQ(material.pressure(1., 2.5, 0.),
            GasMaterial().pressure(1., 2.5, 0.));
}

TEST(GasMaterial, ReadsEachEquationOfState)
{
  EXPECT_NEAR(
    parse("set Gamma = 1.6666666666666667\n").pressure(1., 1.5, 0.), 1., 1e-15);

  const GasMaterial water =
    parse("set Equation of state = stiffened gas\nset Gamma = 4.4\n"
          "set Stiffening pressure = 6e8\n");
  EXPECT_FALSE(water.is_ideal());
  EXPECT_FALSE(water.has_products());
  EXPECT_NEAR(
    water.sound_speed_squared(1000., 1e5, 0.), 4.4 * 6.001e8 / 1000., 1e-6);

  const GasMaterial tnt = parse("set Equation of state = jwl\n");
  EXPECT_FALSE(tnt.has_products());
  EXPECT_EQ(tnt.reference_density(), 1630.);
  EXPECT_NEAR(tnt.reference_energy(), 6e9 / 1630., 1e-6);

  const GasMaterial mixture =
    parse("set Equation of state = jwl in air\nset Explosive = c-4\n");
  EXPECT_TRUE(mixture.has_products());
  EXPECT_EQ(mixture.explosive().A, find_explosive("c-4").jwl.A);
  EXPECT_DOUBLE_EQ(mixture.pressure(1.2, 250000., 0.), 100000.);
}

TEST(GasMaterial, ReadsCustomConstantsInFullPrecision)
{
  const GasMaterial material =
    parse("set Equation of state = jwl\nset Explosive = custom\n"
          "subsection Custom explosive\n"
          "  set A = 373.8123456789e9\n  set B = 3.7471234567891e9\n"
          "  set R1 = 4.1512345678912\n  set R2 = 0.91234567891234\n"
          "  set Omega = 0.35123456789123\n  set Density = 1630.1234567891\n"
          "  set Energy density = 6.0123456789123e9\n"
          "  set Specific heat = 613.51234567891\nend\n");
  const JwlParameters &jwl = material.explosive();
  EXPECT_EQ(jwl.A, 373.8123456789e9);
  EXPECT_EQ(jwl.B, 3.7471234567891e9);
  EXPECT_EQ(jwl.R1, 4.1512345678912);
  EXPECT_EQ(jwl.R2, 0.91234567891234);
  EXPECT_EQ(jwl.omega, 0.35123456789123);
  EXPECT_EQ(jwl.reference_density, 1630.1234567891);
  EXPECT_EQ(jwl.energy_density, 6.0123456789123e9);
  EXPECT_EQ(jwl.specific_heat, 613.51234567891);
}

TEST(GasMaterial, ChangesTheEntriesThatAreGivenAlone)
{
  const GasMaterial material =
    parse("set Equation of state = jwl\nset Explosive = custom\n"
          "subsection Custom explosive\n"
          "  set Like = c-4\n  set Density = 1650\nend\n");
  JwlParameters expected = find_explosive("c-4").jwl;
  expected.reference_density = 1650.;
  const JwlParameters &jwl = material.explosive();
  EXPECT_EQ(jwl.reference_density, 1650.);
  for (const auto number : {&JwlParameters::A,
                            &JwlParameters::B,
                            &JwlParameters::R1,
                            &JwlParameters::R2,
                            &JwlParameters::omega,
                            &JwlParameters::energy_density,
                            &JwlParameters::specific_heat})
    EXPECT_EQ(jwl.*number, expected.*number);
}

TEST(GasMaterial, AnswersAsItsModelDoes)
{
  const GasMaterial material = parse("set Equation of state = jwl in air\n");
  const auto &gas = std::get<MieGrueneisen>(material.model());
  const double density = 800., energy = 3e9, products = 0.7;
  const double p = gas.pressure(density, energy, products);
  EXPECT_EQ(material.pressure(density, energy, products), p);
  EXPECT_EQ(material.internal_energy_density(density, p, products),
            gas.internal_energy_density(density, p, products));
  EXPECT_EQ(material.sound_speed_squared(density, p, products),
            gas.sound_speed_squared(density, p, products));
  EXPECT_EQ(material.least_energy_density(density, products),
            gas.least_energy_density(density, products));
  EXPECT_EQ(material.temperature(density, p, products),
            gas.temperature(density, p, products));
}

TEST(GasMaterial, RefusesWhatIsOutOfRange)
{
  EXPECT_ANY_THROW(parse("set Equation of state = van der waals\n"));
  EXPECT_ANY_THROW(parse("set Gamma = 1\n"));
  EXPECT_ANY_THROW(parse("set Stiffening pressure = -1\n"));
  EXPECT_ANY_THROW(parse("set Explosive = rdx\n"));
  EXPECT_ANY_THROW(parse("subsection Custom explosive\n set A = -1e9\nend\n"));
}

namespace
{
/// TNT of the library with another B [Pa].
std::string tnt_with(const std::string &B)
{
  return "set Equation of state = jwl\nset Explosive = custom\n"
         "subsection Custom explosive\nset A = 371.2e9\nset R1 = 4.15\n"
         "set R2 = 0.95\nset Omega = 0.3\nset Energy density = 7e9\nset B = " +
         B + "\nend\n";
}

/**
 * Unreacted PBX 9404 with a B [Pa] of its own. Published (Tarver, Hallquist and
 * Erickson 1985, Eighth Symposium (International) on Detonation, p. 951): A =
 * 9522, B = -0.05944 Mbar, c_v = 2.7806e-5 Mbar/K.
 */
std::string unreacted_pbx_9404(const std::string &B)
{
  return "set Equation of state = jwl\nset Explosive = custom\n"
         "subsection Custom explosive\nset A = 9.522e14\n"
         "set R1 = 14.1\nset R2 = 1.41\nset Omega = 0.8867\n"
         "set Density = 1842\nset Specific heat = 1509.6\n"
         "set Energy density = 0\nset B = " +
         B + "\nend\n";
}

std::string refusal(const std::string &entries)
{
  try
  {
    parse(entries);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "accepted";
}
} // namespace

TEST(GasMaterial, TakesNegativeBOfAnUnreactedExplosive)
{
  const GasMaterial material = parse(unreacted_pbx_9404("-5.944e9"));
  // The published constants make it free of pressure at 298 K and V = 1; the
  // terms of the sum are 1e9 Pa.
  const double energy =
    std::get<MieGrueneisen>(material.model()).cold_energy_density(1842., 0.) +
    1842. * material.explosive().specific_heat * 298.;
  EXPECT_NEAR(material.pressure(1842., energy, 0.), 0., 2e6);
  const double pressure = material.pressure(1842., energy, 0.);
  EXPECT_NEAR(
    std::sqrt(material.sound_speed_squared(1842., pressure, 0.)), 2264., 5.);
}

TEST(GasMaterial, RefusesNegativeBWhereTheSoundSpeedIsNotReal)
{
  EXPECT_EQ(refusal(tnt_with("3.231e9")), "accepted");
  EXPECT_EQ(refusal(tnt_with("-3e9")), "accepted");
  const std::string message = refusal(tnt_with("-5e9"));
  EXPECT_EQ(message.find("Material/Custom explosive: with B = -5e+09 Pa the "
                         "sound speed is not real at the relative volume 2.26"),
            0u)
    << message;
  EXPECT_NE(message.find("kg/m^3, to which the products expand"),
            std::string::npos);
  EXPECT_NE(refusal(unreacted_pbx_9404("-5.944e10"))
              .find("to which the explosive is compressed"),
            std::string::npos);
}
