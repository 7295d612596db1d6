// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/injury/kingery_bulmash.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using Q = BlastQuantity;

namespace
{
/// Figures in kPa, kPa ms, ms and m/s as the tables print them.
struct Row
{
  double mass, distance, overpressure, reflected, impulse, reflected_impulse,
    arrival, duration, speed;
};

double relative(const double a, const double b)
{
  return std::abs(a / b - 1.);
}
} // namespace

// Evaluated independently from the published polynomials; the figures have
// three or four digits.
TEST(KingeryBulmash, GivesThePublishedSphericalFigures)
{
  const Row rows[] = {
    {0.8535, 0.25, 10789, 103550, 157.6, 3698, 0.0538, 0.172, 3164},
    {0.8535, 0.5, 3522, 26921, 136.9, 1278, 0.1598, 0.338, 1865},
    {0.8535, 1., 830.9, 4294, 158.7, 495.1, 0.5568, 1.726, 960},
    {0.8535, 2., 173.1, 555.4, 83.3, 210.0, 2.031, 1.848, 534},
    {3.039, 2.337, 316, 1212, 162.7, 442.5, 1.892, 2.434, 651},
    {3.107, 2.337, 321, 1239, 165.1, 449.8, 1.880, 2.450, 655},
    {2.699, 2.337, 289, 1078, 150.7, 405.3, 1.958, 2.355, 631}};
  for (const Row &row : rows)
  {
    SCOPED_TRACE(row.distance);
    const KingeryBulmash blast("spherical", row.mass);
    const auto error = [&](const Q quantity, const double expected) {
      return relative(blast.value(quantity, row.distance), expected);
    };
    EXPECT_LT(error(Q::overpressure, 1e3 * row.overpressure), 3e-3);
    EXPECT_LT(error(Q::reflected_overpressure, 1e3 * row.reflected), 3e-3);
    EXPECT_LT(error(Q::impulse, row.impulse), 2e-3);
    EXPECT_LT(error(Q::reflected_impulse, row.reflected_impulse), 2e-3);
    EXPECT_LT(error(Q::arrival, 1e-3 * row.arrival), 2e-3);
    EXPECT_LT(error(Q::duration, 1e-3 * row.duration), 3e-3);
    EXPECT_LT(error(Q::shock_speed, row.speed), 2e-3);
  }
}

TEST(KingeryBulmash, GivesThePublishedHemisphericalFigures)
{
  const KingeryBulmash blast("hemispherical", 10.);
  EXPECT_LT(relative(blast.value(Q::overpressure, 5.), 202.4e3), 5e-4);
  EXPECT_LT(relative(blast.value(Q::impulse, 5.), 251.9), 5e-4);
  EXPECT_LT(relative(blast.value(Q::arrival, 5.), 4.81e-3), 2e-3);
  EXPECT_LT(relative(blast.value(Q::overpressure, 10.), 49.27e3), 5e-4);
  EXPECT_LT(relative(blast.value(Q::impulse, 10.), 136.4), 5e-4);
  EXPECT_LT(relative(blast.value(Q::arrival, 10.), 15.82e-3), 5e-4);
}

// Two fits of the same measurements by different authors.
TEST(KingeryBulmash, AgreesWithSwisdak)
{
  const KingeryBulmash blast("hemispherical", 2.), other("swisdak", 2.);
  for (const Q quantity : {Q::overpressure,
                           Q::reflected_overpressure,
                           Q::impulse,
                           Q::reflected_impulse,
                           Q::arrival,
                           Q::shock_speed})
    for (double z = 0.21; z < 33.; z *= 1.05)
    {
      const double distance = z * blast.scaling_length();
      EXPECT_LT(relative(other.value(quantity, distance),
                         blast.value(quantity, distance)),
                0.06)
        << "quantity " << static_cast<int>(quantity) << ", Z = " << z;
    }
}

// The reflected pressure of a shock in ideal air of gamma = 1.4 follows from
// the incident one; so does its speed. Near the charge air is not ideal.
TEST(KingeryBulmash, SatisfiesRankineAndHugoniot)
{
  const double ambient = 101325., sound_speed = 340.3;
  for (const std::string set : {"spherical", "hemispherical"})
  {
    const KingeryBulmash blast(set, 1.);
    for (double z = 1.; z <= 39.; z *= 1.1)
    {
      const double p = blast.value(Q::overpressure, z);
      EXPECT_LT(relative(blast.value(Q::reflected_overpressure, z),
                         2. * p * (7. * ambient + 4. * p) / (7. * ambient + p)),
                0.025)
        << set << ", Z = " << z;
      EXPECT_LT(relative(blast.value(Q::shock_speed, z),
                         sound_speed * std::sqrt(1. + 6. * p / 7. / ambient)),
                0.02)
        << set << ", Z = " << z;
    }
  }
}

// The front arrives when its speed has brought it there.
TEST(KingeryBulmash, ArrivalFollowsTheShockSpeed)
{
  const KingeryBulmash blast("spherical", 8.);
  for (double r = 1.; r < 70.; r *= 1.2)
  {
    const double h = 0.01 * r;
    const double speed =
      2. * h /
      (blast.value(Q::arrival, r + h) - blast.value(Q::arrival, r - h));
    EXPECT_LT(relative(speed, blast.value(Q::shock_speed, r)), 0.05) << r;
  }
}

TEST(KingeryBulmash, PiecesJoin)
{
  const double joints[][3] = {{0., 0.792, 0.03}, {1., 0.955, 0.03}};
  for (const auto &[hemispherical, z, tolerance] : joints)
  {
    const KingeryBulmash blast(
      hemispherical > 0. ? "hemispherical" : "spherical", 1.);
    EXPECT_LT(relative(blast.value(Q::impulse, z * (1. - 1e-9)),
                       blast.value(Q::impulse, z * (1. + 1e-9))),
              tolerance);
  }
}

TEST(KingeryBulmash, RefusesWhatItDoesNotKnow)
{
  const KingeryBulmash blast("spherical", 8.);
  EXPECT_TRUE(blast.covers(Q::overpressure, 0.0532 * 2.));
  EXPECT_FALSE(blast.covers(Q::overpressure, 0.0530 * 2.));
  EXPECT_FALSE(blast.covers(Q::overpressure, 80.1));
  EXPECT_FALSE(blast.covers(Q::duration, 0.146 * 2.));
  EXPECT_THROW(blast.value(Q::overpressure, 80.1), InputError);
  EXPECT_THROW(KingeryBulmash("spherical", 0.), InputError);
  EXPECT_THROW(KingeryBulmash("round", 1.), InputError);
}
