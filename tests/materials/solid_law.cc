// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/materials/principal_difference.h>
#include <contrecoup/materials/solid_law.h>

#include <gtest/gtest.h>

#include <complex>

using namespace contrecoup;

namespace
{
SolidMaterial brain(const bool g1_is_long_term = false)
{
  return solid_material(find_tissue_properties("paper", Tissue::brain),
                        g1_is_long_term);
}

/// Shear stress after @p n steps of constant strain rate and then rest.
double relaxed_stress(const SolidMaterial &material,
                      const double step,
                      const unsigned int n)
{
  const double decay = std::exp(-0.5 * step / material.relaxation_time);
  Symmetric3<double> strain{}, relaxed{};
  strain[3] = 0.5e-3;
  double stress = 0.;
  for (unsigned int i = 0; i <= n; ++i)
  {
    const double before = i == 0 ? 1. : decay;
    const auto now = relax(relaxed, strain, before);
    stress = 2. * material.instantaneous_shear * strain[3] -
             2. * material.relaxing_shear * now[3];
    relaxed = relax(now, strain, decay);
  }
  return stress;
}
} // namespace


TEST(SolidMaterial, BothReadingsOfG1)
{
  // G(t) of 16 + 33 exp(-t / 6 ms) kPa, and of 33 + 16 exp(-t / 6 ms) kPa.
  EXPECT_NEAR(brain().relaxation_modulus(1e-3), 43.9339e3, 0.1);
  EXPECT_NEAR(brain().relaxation_modulus(6e-3), 28.1400e3, 0.1);
  EXPECT_NEAR(brain().relaxation_modulus(12e-3), 20.4661e3, 0.1);
  EXPECT_NEAR(brain(true).relaxation_modulus(1e3), 33e3, 1e-6);
  EXPECT_NEAR(brain(true).relaxation_modulus(0.), 49e3, 1e-9);
}


TEST(SolidMaterial, ShearWavesOfTheBrain)
{
  // k = omega sqrt(rho / G*): speed omega / Re k and attenuation - Im k.
  const double expected[3][3] = {
    {50., 6.7117, 7.463}, {100., 6.9207, 7.868}, {200., 6.9797, 7.979}};
  for (const auto &[frequency, speed, attenuation] : expected)
  {
    const double omega = 2. * 3.14159265358979 * frequency;
    const SolidMaterial tissue = brain();
    const std::complex<double> phase(0., omega * tissue.relaxation_time);
    const auto shear =
      tissue.instantaneous_shear - tissue.relaxing_shear / (1. + phase);
    const auto k = omega * std::sqrt(tissue.density / shear);
    EXPECT_NEAR(omega / k.real(), speed, 1e-4);
    EXPECT_NEAR(-k.imag(), attenuation, 1e-3);
  }
}


TEST(SolidMaterial, RefusesWhatIsNoSolid)
{
  SolidMaterial material = brain();
  material.check("brain");
  material.relaxing_shear = 50e3;
  EXPECT_THROW(material.check("brain"), InputError);
  EXPECT_THROW(
    find_choice(solid_kinematics, "small strains", "kinematics of solids"),
    InputError);
}


TEST(SolidLaw, SuddenStrainRelaxesExactly)
{
  const SolidMaterial material = brain();
  for (const unsigned int n : {10U, 1000U})
    EXPECT_NEAR(relaxed_stress(material, 6e-3 / n, n),
                1e-3 * material.relaxation_modulus(6e-3),
                1e-9);
}


TEST(SolidLaw, SmallStrainsAreTheLimitOfFiniteOnes)
{
  const Matrix3<double> h{
    {{{1e-8, 2e-8, 3e-8}}, {{-4e-8, 5e-8, 6e-8}}, {{7e-8, -8e-8, 9e-8}}}};
  const auto c = cofactor(h);
  const auto small = solid_strain<SolidKinematics::small_strain>(h, c);
  const auto green = solid_strain<SolidKinematics::finite_rotation>(h, c);
  const auto large = solid_strain<SolidKinematics::neo_hookean>(h, c);
  for (unsigned int k = 0; k < 6; ++k)
  {
    EXPECT_NEAR(green.shear_measure[k], small.shear_measure[k], 1e-13);
    EXPECT_NEAR(large.shear_measure[k], small.shear_measure[k], 1e-13);
  }
  EXPECT_NEAR(green.dilatation, small.dilatation, 1e-14);
}


TEST(SolidLaw, NeoHookeanStressDerivesFromItsEnergy)
{
  SolidLaw<double> law{};
  law.bulk = 3e6;
  law.twice_shear = 2e6;
  const Matrix3<double> h{
    {{{0.3, 0.2, -0.1}}, {{0.1, -0.2, 0.2}}, {{-0.2, 0.1, 0.4}}}};
  const auto energy = [&](const Matrix3<double> &g) {
    return stored_energy<SolidKinematics::neo_hookean>(
      law, solid_strain<SolidKinematics::neo_hookean>(g, cofactor(g)), {});
  };
  const auto strain =
    solid_strain<SolidKinematics::neo_hookean>(h, cofactor(h));
  Symmetric3<double> shear;
  for (unsigned int k = 0; k < 6; ++k)
    shear[k] = law.twice_shear * strain.shear_measure[k];
  const auto p = piola_stress<SolidKinematics::neo_hookean>(
    h, cofactor(h), law.bulk * strain.dilatation, shear);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
    {
      Matrix3<double> up = h, down = h;
      up[i][j] += 1e-6;
      down[i][j] -= 1e-6;
      EXPECT_NEAR(p[i][j], (energy(up) - energy(down)) / 2e-6, 1e-2);
    }
}


// Stress and stiffness are derivatives of the energy, beyond the limit of
// stiffness as well.
TEST(SolidLaw, GasStressDerivesFromItsEnergy)
{
  for (const double exponent : {1., 1.4})
  {
    const GasFilling gas(0.75, exponent, 1e3);
    for (const double dilatation : {-0.9, -0.74, -0.7, -0.3, 0.2, 3.})
    {
      const double d = 1e-6;
      const double up = dilatation + d, down = dilatation - d;
      EXPECT_NEAR((gas.energy(up) - gas.energy(down)) / (2. * d),
                  gas.stress(dilatation),
                  1e-5 * std::abs(gas.stress(dilatation)));
      EXPECT_NEAR((gas.stress(up) - gas.stress(down)) / (2. * d),
                  gas.stiffness(dilatation),
                  1e-5 * gas.stiffness(dilatation));
    }
    EXPECT_NEAR(gas.stiffness(-0.9), 1e3, 1e-9);
    // Small strains have K.
    EXPECT_NEAR(gas.stress(1e-9), 1e-9, 1e-17);
    EXPECT_NEAR(gas.energy(1e-7), 0.5e-14, 1e-20);
    EXPECT_EQ(gas.stiffness(0.), 1.);
    // Half of the gas's volume: p + p_0 = 2^gamma p_0, p_0 = K phi / gamma.
    EXPECT_NEAR(gas.stress(-0.375),
                -0.75 / exponent * (std::pow(2., exponent) - 1.),
                1e-12);
    // Never below vacuum.
    EXPECT_LT(gas.stress(1e6), 0.75 / exponent);
  }
}


TEST(SolidLaw, GasInTheLungIsAtAmbientPressure)
{
  const SolidMaterial lung =
    solid_material(find_tissue_properties("physiological", Tissue::lung));
  ASSERT_TRUE(lung.gas.exists());
  EXPECT_NEAR(lung.bulk_modulus * lung.gas.stress(1e9), 101.3e3, 1e3);
  // 2.2 GPa when the air is gone, without which 10 MPa leave a quarter.
  EXPECT_NEAR(lung.bulk_modulus * lung.stiffening(-0.76), 2.2e9, 1e3);
  EXPECT_LT(lung.bulk_modulus * lung.gas.stress(-0.7219), -10e6);
  EXPECT_FALSE(
    solid_material(find_tissue_properties("paper", Tissue::lung)).gas.exists());
}


TEST(SolidLaw, GasInLanesIsThatInNumbers)
{
  SolidLaw<Lanes<double>> law{};
  law.bulk = 3e5;
  law.gas = GasFilling(0.75, 1.4, 1e4);
  Lanes<double> dilatation;
  for (unsigned int i = 0; i < n_lanes<double>; ++i)
    dilatation[i] = 0.1 * i - 0.7;
  const auto stress = volumetric_stress(law, dilatation);
  const auto energy = volumetric_energy(law, dilatation);
  for (unsigned int i = 0; i < n_lanes<double>; ++i)
  {
    EXPECT_NEAR(stress[i], 3e5 * law.gas.stress(dilatation[i]), 1e-8);
    EXPECT_NEAR(energy[i], 3e5 * law.gas.energy(dilatation[i]), 1e-8);
  }
}


TEST(SolidLaw, InverseCubeRoot)
{
  for (const double x : {0.05, 0.3, 1., 1.001, 3., 20.})
    EXPECT_NEAR(inverse_cube_root(x) * std::cbrt(x), 1., 3e-4);
  for (const double x : {0.5, 0.9, 1., 1.1, 2.})
    EXPECT_NEAR(inverse_cube_root(x) * std::cbrt(x), 1., 1e-12);
}


// Tension is cut off, and the energy is the integral of the stress on both
// branches, of linear and of gas-filled matter.
TEST(SolidLaw, CavitatesAtTheLargestTension)
{
  SolidMaterial water;
  water.bulk_modulus = 2.25e9;
  water.largest_tension = 98.99e3;
  SolidMaterial bubbles = water;
  bubbles.gas = GasFilling(1e-3, 1.4, 100.);
  bubbles.largest_tension = 0.5 * 2.25e9 * 1e-3 / 1.4;
  for (const SolidMaterial &material : {water, bubbles})
  {
    material.check("matter");
    ASSERT_TRUE(material.cavitates());
    SolidLaw<double> law{};
    law.bulk = material.bulk_modulus;
    law.gas = material.gas;
    law.largest_tension = material.largest_tension;
    law.vapour_dilatation = material.vapour_dilatation();
    const double opens = law.vapour_dilatation;
    EXPECT_GT(opens, 0.);
    EXPECT_NEAR(volumetric_stress(law, 0.9999999 * opens) / law.largest_tension,
                1.,
                1e-6);
    EXPECT_LT(volumetric_stress(law, 0.9 * opens), law.largest_tension);
    for (const double x : {1.1, 2., 1e3})
      EXPECT_EQ(volumetric_stress(law, x * opens), law.largest_tension);
    EXPECT_EQ(volumetric_energy(law, 0.), 0.);
    for (const double x : {-3., -1., 0.5, 0.999, 1.001, 4., 900.})
    {
      const double d = 1e-4 * opens, at = x * opens;
      const double slope =
        (volumetric_energy(law, at + d) - volumetric_energy(law, at - d)) /
        (2. * d);
      EXPECT_NEAR(slope, volumetric_stress(law, at), 1e-4 * std::abs(slope));
    }
    EXPECT_NEAR(volumetric_energy(law, opens * (1. + 1e-9)),
                volumetric_energy(law, opens * (1. - 1e-9)),
                1e-6 * volumetric_energy(law, opens));
  }
  EXPECT_FALSE(SolidMaterial().cavitates());
  SolidLaw<double> plain{};
  plain.bulk = 2.25e9;
  EXPECT_EQ(volumetric_stress(plain, 0.5), 0.5 * 2.25e9);
  EXPECT_EQ(volumetric_energy(plain, 0.5), 0.125 * 2.25e9);
  water.largest_tension = 0.;
  EXPECT_THROW(water.check("water"), InputError);
}

TEST(SolidLaw, PrincipalDifference)
{
  // Eigenvalues a, b, c in the frame of two rotations, also with two alike.
  const double values[][3] = {
    {3., 1., -2.}, {1., 0., -1.}, {1., 1., -2.}, {2., -1., -1.}, {5., 5., 5.}};
  for (const auto &[a, b, c] : values)
    for (const double scale : {1e-9, 1., 1e3})
    {
      const double s = 0.6, k = 0.8, cosine = 5. / 13., sine = 12. / 13.;
      const double x[3][3] = {{k * cosine, s * cosine, sine},
                              {-s, k, 0.},
                              {-k * sine, -s * sine, cosine}};
      Symmetric3<Lanes<double>> e{};
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int n = 0; n < 3; ++n)
          e[i] += scale *
                  (n == 0   ? a
                   : n == 1 ? b
                            : c) *
                  x[n][i % 3] * x[n][i < 3 ? i : (i + 1) % 3];
      const double exact = scale * std::max({a - b, b - c, a - c});
      const double found = principal_difference(e)[0],
                   bound = square_difference_bound(e)[0];
      EXPECT_NEAR(found, exact, 1e-7 * scale);
      EXPECT_GE(bound, (1. - 1e-12) * exact * exact);
      EXPECT_LE(bound,
                (4. / 3. + 1e-12) * exact * exact + 1e-20 * scale * scale);
    }
}
