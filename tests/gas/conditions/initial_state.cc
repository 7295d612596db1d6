// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/vortex_solution.h>

#include "scene.h"
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
template <int dim>
void expect_equal(const GasState<dim> &a, const GasState<dim> &b)
{
  EXPECT_DOUBLE_EQ(a.density, b.density);
  EXPECT_NEAR((a.velocity - b.velocity).norm(), 0., 1e-14);
  EXPECT_DOUBLE_EQ(a.pressure, b.pressure);
  EXPECT_DOUBLE_EQ(a.products, b.products);
}


/// Within distance_to_feature() of a point, the state is that at the point.
template <int dim>
void expect_constant_up_to_features(const InitialState<dim> &initial)
{
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> any(-1., 1.);
  unsigned int compared = 0;
  for (unsigned int i = 0; i < 2000; ++i)
  {
    Point<dim> point;
    dealii::Tensor<1, dim> step;
    for (unsigned int d = 0; d < dim; ++d)
    {
      point[d] = any(engine);
      step[d] = any(engine);
    }
    const double distance = std::min(initial.distance_to_feature(point), 10.);
    if (distance == 0.)
      continue;
    step *= 0.999 * distance / step.norm();
    expect_equal(initial.value(point + step), initial.value(point));
    ++compared;
  }
  EXPECT_GT(compared, 100u);
}


double spherical_shell(const double r, const double width)
{
  return 4. / 3. * M_PI *
         (std::pow(r + width / 2, 3) - std::pow(r - width / 2, 3));
}
} // namespace

TEST(InitialState, UniformIsAirAtSeaLevelByDefault)
{
  const Scene<3> scene({});
  expect_equal(scene.initial.value(Point<3>(1, 2, 3)),
               GasState<3>{1.225, {}, 101325., 0.});
  EXPECT_TRUE(std::isinf(scene.initial.smallest_feature()));
  EXPECT_TRUE(std::isinf(scene.initial.distance_to_feature(Point<3>())));
}

TEST(InitialState, RiemannIsSodByDefault)
{
  const Scene<1> scene({"Initial state/Kind=riemann"});
  expect_equal(scene.initial.value(Point<1>(0.499)),
               GasState<1>{1., {}, 1., 0.});
  expect_equal(scene.initial.value(Point<1>(0.501)),
               GasState<1>{0.125, {}, 0.1, 0.});
  EXPECT_NEAR(scene.initial.distance_to_feature(Point<1>(0.2)), 0.3, 1e-15);
}

TEST(InitialState, RiemannMayBeObliqueAndMove)
{
  const Scene<2> scene({"Initial state/Kind=riemann",
                        "Initial state/Riemann/Direction=3,4",
                        "Initial state/Riemann/Position=0.25",
                        "Initial state/Riemann/Frame velocity=10,-20",
                        "Initial state/Riemann/Left velocity=5",
                        "Initial state/Riemann/Right velocity=-5"});
  const auto left = scene.initial.value(Point<2>(0.14, 0.19));
  EXPECT_EQ(left.density, 1.);
  EXPECT_NEAR(left.velocity[0], 13., 1e-14);
  EXPECT_NEAR(left.velocity[1], -16., 1e-14);
  const auto right = scene.initial.value(Point<2>(0.16, 0.21));
  EXPECT_EQ(right.density, 0.125);
  EXPECT_NEAR(right.velocity[0], 7., 1e-14);
  EXPECT_NEAR(right.velocity[1], -24., 1e-14);
  expect_constant_up_to_features(scene.initial);
}

TEST(InitialState, LayersAreThoseOfWoodwardAndColellaByDefault)
{
  const Scene<1> scene({"Initial state/Kind=layers"});
  EXPECT_EQ(scene.initial.value(Point<1>(0.05)).pressure, 1000.);
  EXPECT_EQ(scene.initial.value(Point<1>(0.5)).pressure, 0.01);
  EXPECT_EQ(scene.initial.value(Point<1>(0.95)).pressure, 100.);
  EXPECT_NEAR(scene.initial.smallest_feature(), 0.8, 1e-15);
  expect_constant_up_to_features(scene.initial);
}

TEST(InitialState, LaterRegionsLieOnEarlierOnes)
{
  const Scene<3> scene({"Initial state/Kind=regions",
                        "Initial state/Region ground/Shape=half space",
                        "Initial state/Region ground/Center=0,0,-0.5",
                        "Initial state/Region ground/Normal=0,0,2",
                        "Initial state/Region ground/Density=2",
                        "Initial state/Region box/Shape=box",
                        "Initial state/Region box/Lower corner=-0.6,-0.2,-0.7",
                        "Initial state/Region box/Upper corner=0.1,0.4,0",
                        "Initial state/Region box/Density=3",
                        "Initial state/Region box/Velocity=1,2,3",
                        "Initial state/Region ball/Center=0.1,0.1,0.1",
                        "Initial state/Region ball/Radius=0.3",
                        "Initial state/Region ball/Density=4"});
  const auto density = [&](const double x, const double y, const double z) {
    return scene.initial.value(Point<3>(x, y, z)).density;
  };
  EXPECT_EQ(density(0.9, 0.9, 0.9), 1.225);
  EXPECT_EQ(density(0.9, 0.9, -0.9), 2.);
  EXPECT_EQ(density(-0.5, 0., -0.6), 3.);
  EXPECT_EQ(density(0., 0., 0.), 4.);
  EXPECT_EQ(scene.initial.value(Point<3>(-0.5, 0., -0.6)).velocity[2], 3.);
  EXPECT_NEAR(scene.initial.smallest_feature(), 0.3, 1e-15);
  expect_constant_up_to_features(scene.initial);
}

TEST(InitialState, RegionEnergyGivesThePressure)
{
  const std::vector<std::string> lines{"Initial state/Kind=regions",
                                       "Initial state/Region c/Radius=0.3",
                                       "Initial state/Region c/Energy=7"};
  const double ball = 4. / 3. * M_PI * 0.027;
  EXPECT_NEAR(
    Scene<3>(lines).initial.value(Point<3>()).pressure, 0.4 * 7. / ball, 1e-12);
  EXPECT_NEAR(Scene<2>(lines).initial.value(Point<2>()).pressure,
              0.4 * 7. / (M_PI * 0.09),
              1e-12);
  EXPECT_NEAR(
    Scene<1>(lines).initial.value(Point<1>()).pressure, 0.4 * 7. / 0.6, 1e-12);

  auto without_pressure = lines;
  without_pressure.push_back("Initial state/Region c/Pressure=-1");
  EXPECT_NEAR(Scene<3>(without_pressure).initial.value(Point<3>()).pressure,
              0.4 * 7. / ball,
              1e-12);

  auto spherical = lines;
  spherical.push_back("Domain/Geometry=spherical");
  spherical.insert(spherical.begin(), "Domain/Dimension=1");
  EXPECT_NEAR(Scene<1>(spherical).initial.value(Point<1>()).pressure,
              0.4 * 7. / ball,
              1e-12);

  auto ring = lines;
  ring.push_back("Domain/Geometry=axisymmetric");
  ring.push_back("Initial state/Region c/Shape=box");
  ring.push_back("Initial state/Region c/Lower corner=1,0");
  ring.push_back("Initial state/Region c/Upper corner=2,3");
  EXPECT_NEAR(Scene<2>(ring).initial.value(Point<2>(1.5, 1.)).pressure,
              0.4 * 7. / (M_PI * 3. * 3.),
              1e-12);
}

TEST(InitialState, RegionMayBeABurnedExplosive)
{
  const std::vector<std::string> lines{
    "Initial state/Kind=regions",
    "Initial state/Region charge/Burned explosive=true",
    "Initial state/Region charge/Velocity=0,0,7"};
  EXPECT_NE(refusal<3>(lines).find("needs a Material"), std::string::npos);

  auto with_explosive = lines;
  with_explosive.push_back("Material/Equation of state=jwl in air");
  const Scene<3> scene(with_explosive);
  const auto state = scene.initial.value(Point<3>());
  const JwlParameters &jwl = scene.material.explosive();
  EXPECT_EQ(state.density, jwl.reference_density);
  EXPECT_EQ(state.products, 1.);
  EXPECT_EQ(state.velocity.norm(), 0.);
  EXPECT_NEAR(
    scene.material.internal_energy_density(state.density, state.pressure, 1.) /
      jwl.energy_density,
    1.,
    1e-13);
}

// The deposit holds the energy named, to round-off of a fine sampling.
TEST(InitialState, SedovDepositHoldsItsEnergy)
{
  const std::vector<std::string> lines{"Initial state/Kind=sedov",
                                       "Initial state/Sedov/Energy=3",
                                       "Initial state/Sedov/Radius=0.1",
                                       "Initial state/Sedov/Pressure=1e-9"};
  const double h = 0.02;
  const int n = 50;

  auto spherical = lines;
  spherical.push_back("Domain/Geometry=spherical");
  const Scene<1> ball(spherical), wall(lines);
  const Scene<2> disk(lines);
  const Scene<3> full(lines);

  double in_ball = 0., beside_wall = 0., in_disk = 0., in_full = 0.;
  for (int i = 0; i < 20 * n; ++i)
  {
    const double r = (i + 0.5) * h / 20.;
    in_ball += ball.initial.value(Point<1>(r)).pressure / 0.4 *
               spherical_shell(r, h / 20.);
    beside_wall += wall.initial.value(Point<1>(r)).pressure / 0.4 * h / 20.;
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      const Point<2> xy((i + 0.5) * h, (j + 0.5) * h);
      in_disk += 4. * disk.initial.value(xy).pressure / 0.4 * h * h;
      for (int k = 0; k < n; ++k)
        in_full +=
          8. *
          full.initial.value(Point<3>(xy[0], xy[1], (k + 0.5) * h)).pressure /
          0.4 * h * h * h;
    }
  EXPECT_NEAR(in_ball, 3., 1e-4);
  EXPECT_NEAR(beside_wall, 3., 1e-7);
  EXPECT_NEAR(in_disk, 3., 1e-7);
  EXPECT_NEAR(in_full, 3., 1e-7);
}

TEST(InitialState, SedovDepositIsSmall)
{
  const Scene<3> scene({"Initial state/Kind=sedov",
                        "Initial state/Sedov/Energy=1e-3",
                        "Initial state/Sedov/Radius=0.1",
                        "Initial state/Sedov/Pressure=1"});
  EXPECT_EQ(scene.initial.smallest_feature(), 0.1);
  expect_constant_up_to_features(scene.initial);
}

TEST(InitialState, NohRunsToTheCentre)
{
  const Scene<3> scene({"Initial state/Kind=noh",
                        "Initial state/Noh/Speed=5",
                        "Initial state/Noh/Center=1,1,1"});
  const auto state = scene.initial.value(Point<3>(1., 1.3, 1.4));
  EXPECT_NEAR(state.velocity[0], 0., 1e-14);
  EXPECT_NEAR(state.velocity[1], -3., 1e-14);
  EXPECT_NEAR(state.velocity[2], -4., 1e-14);
  EXPECT_EQ(scene.initial.value(Point<3>(1., 1., 1.)).velocity.norm(), 0.);
}

TEST(InitialState, VortexIsShus)
{
  const Scene<3> scene({"Initial state/Kind=vortex",
                        "Initial state/Vortex/Velocity=1,2,3",
                        "Initial state/Vortex/Center=0.5,0,9"});
  VortexSolution vortex;
  vortex.velocity = {{1., 2.}};
  vortex.center = {{0.5, 0.}};
  const auto expected = vortex.value(1., 2., 0.);
  const auto state = scene.initial.value(Point<3>(1., 2., -5.));
  EXPECT_EQ(state.density, expected.density);
  EXPECT_EQ(state.velocity[0], expected.velocity[0]);
  EXPECT_EQ(state.velocity[1], expected.velocity[1]);
  EXPECT_EQ(state.velocity[2], 3.);
  EXPECT_EQ(state.pressure, expected.pressure);
}

TEST(InitialState, ExpressionsKnowTheCoordinates)
{
  const Scene<2> scene(
    {"Initial state/Kind=expression",
     "Initial state/Expression/Density=if(x<-4, 3.857143, 1+0.2*sin(5*x))",
     "Initial state/Expression/Velocity y=x*y",
     "Initial state/Expression/Pressure=2+cos(pi*y)"});
  const auto state = scene.initial.value(Point<2>(1.5, 1.));
  EXPECT_DOUBLE_EQ(state.density, 1. + 0.2 * std::sin(7.5));
  EXPECT_EQ(state.velocity[0], 0.);
  EXPECT_DOUBLE_EQ(state.velocity[1], 1.5);
  EXPECT_DOUBLE_EQ(state.pressure, 1.);
  EXPECT_EQ(scene.initial.value(Point<2>(-4.5, 1.)).density, 3.857143);
  EXPECT_EQ(scene.initial.distance_to_feature(Point<2>(9., 9.)), 0.);
}

TEST(InitialState, ExpressionsAreCheckedWhereTheyAreUsed)
{
  const Scene<1> scene(
    {"Initial state/Kind=expression", "Initial state/Expression/Density=x"});
  EXPECT_NO_THROW(scene.initial.value(Point<1>(0.5)));
  EXPECT_THROW(scene.initial.value(Point<1>(-0.5)), InputError);
  EXPECT_THROW(scene.initial.value(Point<1>(0.)), InputError);
}

TEST(InitialState, BadInputIsNamed)
{
  const std::vector<std::vector<std::string>> cases{
    // lines, then what the message must hold
    {"Initial state/Background/Density=-1", "Density"},
    {"Initial state/Background/Pressure=-1", "Background"},
    {"Initial state/Background/Pressure=0", "above 0 Pa"},
    {"Initial state/Background/Products=1.5", "Products"},
    {"Initial state/Background/Velocity=0,1", "Velocity"},
    {"Initial state/Kind=riemann",
     "Initial state/Riemann/Left pressure=-3",
     "Left state: pressure -3"},
    {"Initial state/Kind=riemann",
     "Initial state/Riemann/Right density=0",
     "Right density"},
    {"Initial state/Kind=riemann",
     "Initial state/Riemann/Direction=0",
     "Direction"},
    {"Initial state/Kind=layers",
     "Initial state/Layers/Positions=0.9,0.1",
     "must increase"},
    {"Initial state/Kind=layers",
     "Initial state/Layers/Densities=1,1",
     "must have 3 values"},
    {"Initial state/Kind=layers",
     "Initial state/Layers/Pressures=1,-1,1",
     "layer 2"},
    {"Initial state/Kind=regions", "at least one"},
    {"Initial state/Kind=regions",
     "Initial state/Region a/Shape=box",
     "Lower corner"},
    {"Initial state/Kind=regions",
     "Initial state/Region a/Shape=half space",
     "Initial state/Region a/Energy=1",
     "half space"},
    {"Initial state/Kind=regions",
     "Initial state/Region a/Pressure=-1",
     "Region a: pressure -1"},
    {"Initial state/Kind=regions",
     "Initial state/Region a/Shape=spere",
     "sphere"},
    {"Initial state/Kind=sedov", "Initial state/Sedov/Energy=0", "Energy"},
    {"Initial state/Kind=noh", "Initial state/Noh/Pressure=-1", "Noh"},
    {"Initial state/Kind=vortex", "Dimension"},
    {"Initial state/Kind=expression",
     "Initial state/Expression/Pressure=1+",
     "Pressure = \"1+\""},
    {"Initial state/Kind=expression",
     "Initial state/Expression/Velocity x=z",
     "Velocity x"}};
  for (std::vector<std::string> lines : cases)
  {
    const std::string expected = lines.back();
    lines.pop_back();
    const std::string message = refusal<1>(lines);
    EXPECT_NE(message.find(expected), std::string::npos) << lines.back() << "\n"
                                                         << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(InitialState, VortexCoreMustBeWarm)
{
  EXPECT_NE(refusal<2>(
              {"Initial state/Kind=vortex", "Initial state/Vortex/Strength=11"})
              .find("absolute zero"),
            std::string::npos);
}
