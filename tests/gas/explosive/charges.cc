// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "gas_run.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::gas;

namespace
{
const double pi = 3.14159265358979323846;
const double tnt_density = 1630.;

using Lines = std::vector<std::string>;

Lines charge(const Lines &entries, const std::string &name = "1")
{
  Lines lines;
  for (const std::string &entry : entries)
    lines.push_back("Charges/Charge " + name + "/" + entry);
  return lines;
}

Lines box(const std::string &lower,
          const std::string &upper,
          const std::string &leaves)
{
  return {"Domain/Lower corner=" + lower,
          "Domain/Upper corner=" + upper,
          "Domain/Coarse leaves=" + leaves};
}

Lines dimension(const int dim, const std::string &geometry = "plane")
{
  return {"Domain/Dimension=" + std::to_string(dim),
          "Domain/Geometry=" + geometry};
}

/// Relative error of the mass of products that the mesh holds.
template <int dim>
double mass_error(const Lines &lines, const double volume)
{
  GasRun<dim> run(products_in_air() + finite_volume(4) + lines);
  run.set_charges();
  return run.totals()["products_mass"] / (volume * tnt_density) - 1.;
}

template <int dim>
std::string refusal_of(const Lines &lines)
{
  try
  {
    GasRun<dim> run(products_in_air() + finite_volume(4) + lines);
    run.set_charges();
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}

const Lines cube = dimension(3) + box("-1, -1, -1", "1, 1, 1", "2, 2, 2");
} // namespace


// Whatever the cells are, the mesh holds the mass of the true shape.
TEST(ChargeMass, OneDimension)
{
  const Lines mesh = box("0", "1", "5");
  const double r = 0.3217;
  EXPECT_LT(std::abs(mass_error<1>(dimension(1, "spherical") + mesh +
                                     charge({"Radius=0.3217"}),
                                   4. / 3. * pi * r * r * r)),
            1e-12);
  EXPECT_LT(
    std::abs(mass_error<1>(dimension(1, "cylindrical") + mesh +
                             charge({"Shape=cylinder", "Radius=0.3217"}),
                           pi * r * r)),
    1e-12);
  EXPECT_LT(std::abs(mass_error<1>(
              dimension(1) + mesh +
                charge({"Shape=box", "Edges=0.123456", "Center=0.456789"}),
              0.123456)),
            1e-12);
}


TEST(ChargeMass, SpheresInThreeDimensions)
{
  const double r = 0.4567;
  const double volume = 4. / 3. * pi * r * r * r;
  EXPECT_LT(
    std::abs(mass_error<3>(
      cube + charge({"Radius=0.4567", "Center=0.1, -0.2, 0.05"}), volume)),
    1e-12);
  // An eighth, cut by three planes of symmetry.
  EXPECT_LT(
    std::abs(mass_error<3>(dimension(3) + box("0, 0, 0", "1, 1, 1", "2, 2, 2") +
                             charge({"Radius=0.4567"}),
                           volume / 8.)),
    1e-12);
  // Far smaller than a cell, by mass: 1 mg.
  EXPECT_LT(
    std::abs(mass_error<3>(cube + charge({"Mass=1e-6", "Center=0.1, 0.2, 0.3"}),
                           1e-6 / tnt_density)),
    1e-12);
}


TEST(ChargeMass, CylindersAndBoxes)
{
  const double volume = pi * 0.3 * 0.3 * 0.7;
  const Lines tilted = charge({"Shape=cylinder",
                               "Radius=0.3",
                               "Length=0.7",
                               "Axis=1, 2, 3",
                               "Center=0, 0.1, 0.1"});
  EXPECT_LT(std::abs(mass_error<3>(cube + tilted, volume)), 1e-12);
  // Any plane through the centre halves it.
  EXPECT_LT(std::abs(mass_error<3>(
              dimension(3) + box("-1, -1, 0.1", "1, 1, 1", "2, 2, 1") + tilted,
              volume / 2.)),
            1e-12);
  EXPECT_LT(std::abs(mass_error<3>(cube + charge({"Shape=box",
                                                  "Edges=0.31, 0.52, 0.73",
                                                  "Center=0.01, 0.02, 0.03"}),
                                   0.31 * 0.52 * 0.73)),
            1e-12);
  // By mass at equal proportions.
  EXPECT_LT(std::abs(mass_error<3>(
              cube + charge({"Shape=box", "Edges=1, 2, 3", "Mass=40"}),
              40. / tnt_density)),
            1e-12);
}


TEST(ChargeMass, TwoDimensions)
{
  const Lines mesh = box("0, -1", "1, 1", "2, 4");
  const Lines axisymmetric = dimension(2, "axisymmetric") + mesh;
  const double r = 0.4567;
  EXPECT_LT(std::abs(mass_error<2>(axisymmetric +
                                     charge({"Radius=0.4567", "Center=0, 0.1"}),
                                   4. / 3. * pi * r * r * r)),
            1e-12);
  EXPECT_LT(std::abs(mass_error<2>(axisymmetric + charge({"Shape=cylinder",
                                                          "Radius=0.4567",
                                                          "Length=0.7",
                                                          "Center=0, 0.1"}),
                                   pi * r * r * 0.7)),
            1e-12);
  EXPECT_LT(std::abs(mass_error<2>(
              dimension(2) + mesh +
                charge({"Shape=cylinder", "Radius=0.4567", "Center=0.5, 0"}),
              pi * r * r)),
            1e-12);
}


TEST(Charges, RefusesWhatCannotBe)
{
  EXPECT_NE(
    refusal_of<1>(dimension(1) + box("0", "1", "2") + charge({"Shape=sphere"}))
      .find("does not go with"),
    std::string::npos);
  EXPECT_NE(refusal_of<1>(dimension(1, "spherical") + box("0", "1", "2") +
                          charge({"Center=0.1"}))
              .find("radius 0"),
            std::string::npos);
  EXPECT_NE(refusal_of<3>(cube + charge({"Center=3, 0, 0"})).find("outside"),
            std::string::npos);
  EXPECT_NE(refusal_of<3>(cube + charge({"Radius=0.2"}) +
                          charge({"Radius=0.2", "Center=0.1, 0, 0"}, "2"))
              .find("overlap"),
            std::string::npos);
  EXPECT_NE(
    refusal_of<3>(cube + charge({"Ignition times=0, 1"})).find("as many"),
    std::string::npos);
  EXPECT_NE(refusal_of<3>(cube + charge({"Radius=0.2"}) +
                          Lines{"Initial state/Background/Velocity=1, 0, 0"})
              .find("at rest"),
            std::string::npos);
  EXPECT_NE(refusal_of<3>(cube + charge({"Radius=0.2"}) + galerkin(2))
              .find("finite volume only"),
            std::string::npos);
}


// Before it is lit, the charge rests in the air, to the last bit.
TEST(Charges, UnlitChargeRests)
{
  const Lines late = charge({"Radius=0.3", "Ignition times=1"});
  GasRun<3> solid(products_in_air() + finite_volume(4) + cube +
                  charge({"Ignition points=0, 0, 0"}) + late);
  solid.set_charges();
  EXPECT_NEAR(solid.totals()["largest_pressure"], 101325., 1e-9);
  EXPECT_NEAR(solid.totals()["smallest_pressure"], 101325., 1e-9);
  const auto before = solid.leaves();
  solid.steps(10);
  EXPECT_EQ(solid.leaves(), before);

  GasRun<1> radial(products_in_air() + finite_volume(4) +
                   dimension(1, "spherical") + box("0", "1", "10") +
                   charge({"Ignition points=0"}) + late);
  radial.set_charges();
  const auto radial_before = radial.leaves();
  radial.steps(10);
  EXPECT_EQ(radial.leaves(), radial_before);
}


TEST(Charges, BurnedFractionNeverFalls)
{
  GasRun<3> run(products_in_air() + finite_volume(4) + cube +
                charge({"Radius=0.5",
                        "Ignition points=0.5, 0, 0; 0, 0, 2",
                        "Ignition times=0, 1e-5"}));
  run.set_charges();
  const Burn &burn = run.detonation.burn();
  const double end = run.detonation.end();
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    for (unsigned int q = 0; q < run.layout.n_points; ++q)
    {
      double before = 0.;
      for (unsigned int i = 0; i <= 50; ++i)
      {
        const double now =
          burn.fraction(burn.progress(leaf, q, i * end / 50.), 1.);
        EXPECT_GE(now, before);
        before = now;
      }
      EXPECT_EQ(burn.progress(leaf, q, end * (1. + 1e-12)), 1.);
    }
}


// The burn adds and loses nothing, on hanging faces and across ranks.
template <int dim>
void expect_conservation(const Lines &lines)
{
  GasRun<dim> run(products_in_air() + finite_volume(4) + lines);
  run.refine([](const dealii::Point<dim> &p) { return p[0] < 0.5; });
  run.set_charges();
  auto before = run.totals();
  run.steps(60);
  auto after = run.totals();
  for (const std::string name : {"mass", "energy", "products_mass"})
    EXPECT_NEAR(after[name], before[name], 1e-12 * before[name]) << name;
  EXPECT_GT(after["kinetic_energy"], 0.01 * before["energy"]);
}


TEST(Charges, BurnConserves)
{
  expect_conservation<3>(dimension(3) + box("0, 0, 0", "1, 1, 1", "2, 2, 2") +
                         charge({"Radius=0.6"}));
  expect_conservation<2>(
    dimension(2, "axisymmetric") + box("0, 0", "1, 1", "2, 2") +
    charge({"Shape=cylinder", "Radius=0.6", "Length=0.8", "Center=0, 0.3"}));
}
