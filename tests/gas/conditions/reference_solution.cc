// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/conditions/table_profile.h>
#include <contrecoup/numerics/exact/point_source.h>
#include <contrecoup/numerics/exact/sedov_solution.h>

#include "scene.h"
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <tuple>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
/// Writes a file for as long as the object lives.
class TemporaryFile
{
public:
  TemporaryFile(const std::string &name, const std::string &text)
    : name_(name)
  {
    std::ofstream(name) << text;
  }

  ~TemporaryFile()
  {
    std::remove(name_.c_str());
  }

private:
  std::string name_;
};
} // namespace

TEST(ReferenceSolution, NoneByDefault)
{
  const Scene<2> scene({});
  EXPECT_EQ(scene.reference.name(), "none");
  EXPECT_FALSE(scene.reference.exists());
  EXPECT_FALSE(scene.reference.has_arrivals());
}

TEST(ReferenceSolution, InitialStateStays)
{
  const Scene<1> scene({"Initial state/Kind=layers", "Reference/Kind=initial"});
  ASSERT_TRUE(scene.reference.exists());
  EXPECT_EQ(scene.reference.value(Point<1>(0.95), 7.).pressure, 100.);
}

TEST(ReferenceSolution, MayServeBoundariesAlone)
{
  const Scene<1> measured({"Reference/Kind=initial"});
  EXPECT_TRUE(measured.reference.is_measured());
  const Scene<1> boundary(
    {"Reference/Kind=initial", "Reference/Measure errors=false"});
  EXPECT_TRUE(boundary.reference.exists());
  EXPECT_FALSE(boundary.reference.is_measured());
  EXPECT_FALSE(Scene<1>({}).reference.is_measured());
}

// E. F. Toro (Riemann Solvers and Numerical Methods for Fluid Dynamics, 2009,
// table 4.2) and the shock speed of his test 1's relative, Sod's tube.
TEST(ReferenceSolution, RiemannOfSod)
{
  const Scene<1> scene(
    {"Initial state/Kind=riemann", "Reference/Kind=riemann"});
  const auto at = [&](const double x) {
    return scene.reference.value(Point<1>(x), 0.2);
  };
  for (const double x : {0.66, 0.72, 0.84})
  {
    EXPECT_NEAR(at(x).pressure, 0.30313, 5e-6);
    EXPECT_NEAR(at(x).velocity[0], 0.927453, 5e-7);
  }
  EXPECT_NEAR(at(0.66).density, 0.426319, 5e-7);
  EXPECT_NEAR(at(0.72).density, 0.265574, 5e-7);
  EXPECT_EQ(at(0.5 + 0.2 * 1.7522).density, 0.125);
  EXPECT_NEAR(at(0.5 + 0.2 * 1.7521).density, 0.265574, 5e-7);
  EXPECT_EQ(at(0.2).density, 1.);
  EXPECT_EQ(scene.reference.value(Point<1>(0.49), 0.).density, 1.);
}

TEST(ReferenceSolution, RiemannMayBeObliqueAndMove)
{
  const Scene<1> plain(
    {"Initial state/Kind=riemann", "Reference/Kind=riemann"});
  const Scene<2> moving({"Initial state/Kind=riemann",
                         "Reference/Kind=riemann",
                         "Initial state/Riemann/Direction=3,4",
                         "Initial state/Riemann/Frame velocity=10,-20"});
  for (const double distance : {0.3, 0.45, 0.6, 0.8, 0.9})
  {
    const double t = 0.2;
    const Point<2> point(0.6 * distance + 10. * t, 0.8 * distance - 20. * t);
    const auto expected = plain.reference.value(Point<1>(distance), t);
    const auto state = moving.reference.value(point, t);
    EXPECT_NEAR(state.density, expected.density, 1e-12);
    EXPECT_NEAR(state.pressure, expected.pressure, 1e-12);
    EXPECT_NEAR(state.velocity[0], 10. + 0.6 * expected.velocity[0], 1e-12);
    EXPECT_NEAR(state.velocity[1], -20. + 0.8 * expected.velocity[0], 1e-12);
  }
}

// Star states of K.-M. Shyue's JWL tube as LANL's ExactPack prints them. They
// are good to 1e-7 relative: the isentrope in closed form, with the velocity by
// Simpson's rule, gives p = 4.407101303913 and u = 1.695236472573.
TEST(ReferenceSolution, RiemannOfShyue)
{
  const Scene<1> scene({"Material/Equation of state=jwl",
                        "Material/Explosive=custom",
                        "Material/Custom explosive/A=8.545",
                        "Material/Custom explosive/B=0.205",
                        "Material/Custom explosive/R1=4.6",
                        "Material/Custom explosive/R2=1.35",
                        "Material/Custom explosive/Omega=0.25",
                        "Material/Custom explosive/Density=1.84",
                        "Initial state/Kind=riemann",
                        "Initial state/Riemann/Position=50",
                        "Initial state/Riemann/Left density=1.7",
                        "Initial state/Riemann/Left pressure=10",
                        "Initial state/Riemann/Right density=1",
                        "Initial state/Riemann/Right pressure=0.5",
                        "Reference/Kind=riemann"});
  const double t = 12., contact = 50. + 1.695236278947 * t;
  const auto left = scene.reference.value(Point<1>(contact - 0.1), t);
  const auto right = scene.reference.value(Point<1>(contact + 0.1), t);
  EXPECT_NEAR(left.pressure, 4.407101303913, 1e-9);
  EXPECT_NEAR(left.velocity[0], 1.695236472573, 1e-9);
  EXPECT_NEAR(left.density, 0.8880765637, 1e-6);
  EXPECT_NEAR(right.pressure, 4.407101303913, 1e-9);
  EXPECT_NEAR(right.density, 3.7812802438, 1e-6);
}

TEST(ReferenceSolution, SedovAroundAnyCentre)
{
  const Scene<3> scene({"Initial state/Kind=sedov",
                        "Initial state/Sedov/Center=0.1,0.2,0.3",
                        "Initial state/Sedov/Density=2",
                        "Initial state/Sedov/Energy=3",
                        "Reference/Kind=sedov"});
  const SedovSolution solution(3, 1.4, 2., 3.);
  const double r = 0.9 * solution.shock_radius(0.5);
  const auto expected = solution.value(r, 0.5);
  const auto state =
    scene.reference.value(Point<3>(0.1, 0.2 - 0.6 * r, 0.3 + 0.8 * r), 0.5);
  EXPECT_NEAR(state.density, expected.density, 1e-12);
  EXPECT_NEAR(state.pressure, expected.pressure, 1e-12);
  EXPECT_NEAR(state.velocity[1], -0.6 * expected.velocity, 1e-12);
  EXPECT_NEAR(state.velocity[2], 0.8 * expected.velocity, 1e-12);
  const auto ahead = scene.reference.value(Point<3>(9., 9., 9.), 0.5);
  EXPECT_EQ(ahead.density, 2.);
  EXPECT_EQ(ahead.pressure, 1e-6);
}

TEST(ReferenceSolution, NohKnowsTheGeometry)
{
  const std::vector<std::string> lines{"Material/Gamma=1.6666666666666667",
                                       "Initial state/Kind=noh",
                                       "Reference/Kind=noh"};
  auto spherical = lines, cylindrical = lines, axisymmetric = lines;
  spherical.push_back("Domain/Geometry=spherical");
  cylindrical.push_back("Domain/Geometry=cylindrical");
  axisymmetric.push_back("Domain/Geometry=axisymmetric");

  const Point<1> in(0.1), out(0.3);
  EXPECT_NEAR(Scene<1>(lines).reference.value(in, 0.6).density, 4., 1e-12);
  EXPECT_NEAR(
    Scene<1>(cylindrical).reference.value(in, 0.6).density, 16., 1e-12);
  EXPECT_NEAR(Scene<1>(spherical).reference.value(in, 0.6).density, 64., 1e-11);
  EXPECT_NEAR(Scene<1>(spherical).reference.value(out, 0.6).density, 9., 1e-12);
  EXPECT_NEAR(
    Scene<2>(axisymmetric).reference.value(Point<2>(0.1, 0.1), 0.6).density,
    64.,
    1e-11);
  EXPECT_NEAR(Scene<2>(lines).reference.value(Point<2>(0.1, 0.1), 0.6).density,
              16.,
              1e-12);
  EXPECT_NEAR(
    Scene<3>(lines).reference.value(Point<3>(0., 0., 0.3), 0.6).velocity[2],
    -1.,
    1e-14);
}

TEST(ReferenceSolution, VortexComesBack)
{
  const Scene<2> scene({"Initial state/Kind=vortex", "Reference/Kind=vortex"});
  const Point<2> point(1.2, -0.4);
  EXPECT_NEAR(scene.reference.value(point, 10.).density,
              scene.initial.value(point).density,
              1e-13);
  EXPECT_NEAR(scene.reference.value(point, 0.3).density,
              scene.initial.value(Point<2>(0.9, -0.7)).density,
              1e-13);
}

TEST(ReferenceSolution, PointSourceArrivals)
{
  const std::vector<std::string> lines{"Domain/Geometry=spherical",
                                       "Initial state/Kind=sedov",
                                       "Initial state/Sedov/Energy=4e6",
                                       "Initial state/Sedov/Density=1.225",
                                       "Initial state/Sedov/Pressure=101325",
                                       "Reference/Kind=point source"};
  const Scene<1> scene(lines);
  EXPECT_FALSE(scene.reference.exists());
  ASSERT_TRUE(scene.reference.has_arrivals());
  const auto arrival = scene.reference.arrival(Point<1>(2.5));
  const PointSourceSolution solution(4e6, 101325., 1.225);
  EXPECT_EQ(arrival.peak, solution.overpressure(2.5));
  EXPECT_EQ(arrival.arrival, solution.arrival_time(2.5));

  auto other_gamma = lines;
  other_gamma.push_back("Material/Gamma=1.3");
  EXPECT_NE(refusal<1>(other_gamma).find("gamma = 1.4"), std::string::npos);
  auto plane = lines;
  plane[0] = "Domain/Geometry=plane";
  EXPECT_NE(refusal<1>(plane).find("3 dimensions"), std::string::npos);
}

TEST(ReferenceSolution, KingeryBulmashGivesWhatItsTablesHold)
{
  const std::vector<std::string> charge = {
    "Reference/Kind=kingery bulmash",
    "Reference/Kingery Bulmash/Mass=0.8535",
    "Reference/Kingery Bulmash/Center=0, 0, 3"};
  const Scene<3> scene(charge);
  EXPECT_FALSE(scene.reference.exists());
  ASSERT_TRUE(scene.reference.has_arrivals());
  const auto seen = scene.reference.arrival(Point<3>(0., 0.6, 2.2));
  EXPECT_NEAR(seen.peak, 830.9e3, 500.);
  EXPECT_NEAR(seen.impulse, 158.7, 0.1);
  EXPECT_NEAR(seen.arrival, 0.5568e-3, 1e-7);
  EXPECT_NEAR(seen.duration, 1.726e-3, 1e-6);

  // No figures so near to the charge.
  EXPECT_EQ(scene.reference.arrival(Point<3>(0., 0.04, 3.)).peak, 0.);
  // Only the coordinates of the dimension count.
  EXPECT_NEAR(
    Scene<1>({charge[0], charge[1]}).reference.arrival(Point<1>(1.)).peak,
    830.9e3,
    500.);

  // Equivalent masses: peak and arrival by one, impulse by the other.
  const double mass = 0.8535 / 1.37, impulse_mass = 0.8535 / 1.19;
  for (const double m : {mass, impulse_mass})
  {
    auto lines = charge;
    lines.push_back("Reference/Kingery Bulmash/Mass=" + std::to_string(m));
    lines.push_back(
      "Reference/Kingery Bulmash/TNT equivalence of pressure=1.37");
    lines.push_back(
      "Reference/Kingery Bulmash/TNT equivalence of impulse=1.19");
    const Scene<3> other(lines);
    const auto value = other.reference.arrival(Point<3>(0., 0.6, 2.2));
    EXPECT_EQ(std::abs(value.peak - seen.peak) < 10., m == mass);
    EXPECT_EQ(std::abs(value.arrival - seen.arrival) < 1e-8, m == mass);
    EXPECT_EQ(std::abs(value.impulse - seen.impulse) < 1e-2, m == impulse_mass);
  }
}


// Empty entries take what the library has for the explosive, as scenes do.
TEST(ReferenceSolution, KingeryBulmashKnowsTheExplosive)
{
  const std::string tables = "Reference/Kingery Bulmash/";
  const auto arrival_of = [&](const std::vector<std::string> &more) {
    std::vector<std::string> lines = {"Reference/Kind=kingery bulmash",
                                      tables + "Mass=0.8535"};
    lines.insert(lines.end(), more.begin(), more.end());
    const Scene<1> scene(lines);
    const BlastMeasures found = scene.reference.arrival(Point<1>(1.));
    return std::tuple(found.peak,
                      found.impulse,
                      scene.reference.description() == "kingery bulmash");
  };
  const std::string mixture = "Material/Equation of state=jwl in air",
                    c4 = "Material/Explosive=c-4";
  const auto [peak, impulse, is_plain] = arrival_of({mixture, c4});
  EXPECT_FALSE(is_plain);
  EXPECT_EQ(arrival_of({tables + "TNT equivalence of pressure=1.37",
                        tables + "TNT equivalence of impulse=1.19"}),
            std::tuple(peak, impulse, false));
  // Without an explosive, of TNT, and where the entries are given.
  const auto of_tnt = arrival_of({});
  EXPECT_NEAR(std::get<0>(of_tnt), 830.9e3, 500.);
  EXPECT_TRUE(std::get<2>(of_tnt));
  EXPECT_EQ(arrival_of({c4}), of_tnt);
  EXPECT_EQ(arrival_of({mixture, "Material/Explosive=tnt"}), of_tnt);
  EXPECT_EQ(arrival_of({mixture,
                        c4,
                        tables + "TNT equivalence of pressure=1",
                        tables + "TNT equivalence of impulse=1"}),
            of_tnt);
  // Equal factors are told once.
  EXPECT_EQ(Scene<1>({"Reference/Kind=kingery bulmash",
                      mixture,
                      "Material/Explosive=composition b"})
              .reference.description(),
            "kingery bulmash, as 1.15 times its mass of TNT");
  // A user's own explosive goes by the ratio of energies.
  EXPECT_GT(std::get<0>(
              arrival_of({mixture,
                          "Material/Explosive=custom",
                          "Material/Custom explosive/Like=c-4",
                          "Material/Custom explosive/Energy density=1.2e10"})),
            peak);
}


TEST(ReferenceSolution, TableIsInterpolated)
{
  const TemporaryFile file("reference_table.csv",
                           "# made by hand\n"
                           "position [m], density, velocity, pressure\n"
                           "0, 1, 2, 3\n"
                           "2, 2, 4, 9\n");
  const Scene<2> scene(
    {"Reference/Kind=table", "Reference/Table=reference_table.csv"});
  const auto state = scene.reference.value(Point<2>(0.5, 7.), 1.);
  EXPECT_DOUBLE_EQ(state.density, 1.25);
  EXPECT_DOUBLE_EQ(state.velocity[0], 2.5);
  EXPECT_DOUBLE_EQ(state.velocity[1], 0.);
  EXPECT_DOUBLE_EQ(state.pressure, 4.5);
  EXPECT_EQ(scene.reference.value(Point<2>(-5., 0.), 1.).density, 1.);
  EXPECT_EQ(scene.reference.value(Point<2>(5., 0.), 1.).density, 2.);
}

TEST(ReferenceSolution, BadTablesAreNamed)
{
  const std::vector<std::string> lines{"Reference/Kind=table",
                                       "Reference/Table=bad_table.csv"};
  EXPECT_NE(refusal<1>(lines).find("there is no such file"), std::string::npos);
  const std::vector<std::pair<std::string, std::string>> cases{
    {"", "at least 2 lines"},
    {"0,1,2,3\n", "at least 2 lines"},
    {"0,1,2,3\n1,1,2\n", "line 2"},
    {"0,1,2,3\n0,1,2,3\n", "line 2"},
    {"x,rho,u,p\n0,1,2,3\n1,-1,2,3\n", "line 3"},
    {"x,rho,u,p\nx,rho,u,p\n", "line 2"},
    {"0,1,2,3\n1,nan,2,3\n", "line 2"}};
  for (const auto &[text, expected] : cases)
  {
    const TemporaryFile file("bad_table.csv", text);
    EXPECT_NE(refusal<1>(lines).find(expected), std::string::npos) << text;
  }
}

TEST(ReferenceSolution, MustFitTheInitialState)
{
  for (const std::string kind :
       {"riemann", "vortex", "noh", "sedov", "point source"})
    EXPECT_NE(
      refusal<2>({"Reference/Kind=" + kind}).find("needs Initial state/Kind"),
      std::string::npos)
      << kind;
  for (const std::string kind : {"noh", "sedov"})
    EXPECT_NE(refusal<2>({"Material/Equation of state=stiffened gas",
                          "Initial state/Kind=" + kind,
                          "Reference/Kind=" + kind})
                .find("ideal gas"),
              std::string::npos)
      << kind;
}
