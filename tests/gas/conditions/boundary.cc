// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "gas_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;
using dealii::Tensor;

namespace
{
const std::vector<std::string> riemann_problem = {"Initial state/Kind=riemann",
                                                  "Reference/Kind=riemann"};


GasState<3> inside()
{
  GasState<3> state;
  state.density = 2.;
  state.velocity[0] = 10.;
  state.velocity[1] = -20.;
  state.velocity[2] = 30.;
  state.pressure = 3e5;
  state.products = 0.25;
  return state;
}


template <int dim>
void expect_equal(const GasState<dim> &a, const GasState<dim> &b)
{
  EXPECT_DOUBLE_EQ(a.density, b.density);
  EXPECT_DOUBLE_EQ(a.pressure, b.pressure);
  EXPECT_DOUBLE_EQ(a.products, b.products);
  for (unsigned int d = 0; d < dim; ++d)
    EXPECT_DOUBLE_EQ(a.velocity[d], b.velocity[d]);
}


/// The message with which a scene is refused; empty when it is not.
template <int dim>
std::string refusal(const std::vector<std::string> &lines)
{
  try
  {
    GasRun<dim> run(lines);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace


TEST(Boundary, WallsMirrorTheNormalVelocity)
{
  const GasRun<3> run({"Boundaries/y low=symmetry"});
  EXPECT_EQ(run.boundary.kind(0), Boundary<3>::Kind::wall);
  EXPECT_EQ(run.boundary.kind(2), Boundary<3>::Kind::wall);
  for (unsigned int side = 0; side < 6; ++side)
  {
    Tensor<1, 3> normal;
    normal[side / 2] = side % 2 ? 1. : -1.;
    GasState<3> mirrored = inside();
    mirrored.velocity[side / 2] *= -1.;
    expect_equal(run.boundary.outside(side, inside(), normal, {}, 0.),
                 mirrored);
  }
  // An oblique wall turns around only what runs into it.
  const Tensor<1, 3> oblique({0.6, 0., 0.8});
  const auto state = run.boundary.outside(0, inside(), oblique, {}, 0.);
  EXPECT_NEAR(state.velocity * oblique, -(inside().velocity * oblique), 1e-13);
  EXPECT_NEAR(state.velocity.norm(), inside().velocity.norm(), 1e-13);
  EXPECT_NEAR(state.velocity[1], inside().velocity[1], 1e-13);
}


TEST(Boundary, EachSideHasItsOwnKind)
{
  const GasRun<3> run({"Boundaries/x high=open",
                       "Boundaries/y low=inflow",
                       "Boundaries/z low=initial",
                       "Boundaries/Inflow/Density=7",
                       "Boundaries/Inflow/Velocity=1, 2, 3",
                       "Boundaries/Inflow/Pressure=5e6",
                       "Initial state/Kind=expression",
                       "Initial state/Expression/Density=1 + x",
                       "Initial state/Expression/Pressure=1e5 * (1 + y)"});
  using Kind = Boundary<3>::Kind;
  const Kind expected[] = {Kind::wall,
                           Kind::open,
                           Kind::inflow,
                           Kind::wall,
                           Kind::initial,
                           Kind::wall};
  for (unsigned int side = 0; side < 6; ++side)
    EXPECT_EQ(run.boundary.kind(side), expected[side]);

  const Tensor<1, 3> normal({1., 0., 0.});
  expect_equal(run.boundary.outside(1, inside(), normal, {}, 0.), inside());

  const auto inflow = run.boundary.outside(2, inside(), normal, {}, 0.);
  EXPECT_DOUBLE_EQ(inflow.density, 7.);
  EXPECT_DOUBLE_EQ(inflow.velocity[2], 3.);
  EXPECT_DOUBLE_EQ(inflow.pressure, 5e6);

  const Point<3> place(0.25, 0.5, 0.);
  const auto initial = run.boundary.outside(4, inside(), normal, place, 9.);
  EXPECT_DOUBLE_EQ(initial.density, 1.25);
  EXPECT_DOUBLE_EQ(initial.pressure, 1.5e5);
  EXPECT_DOUBLE_EQ(initial.velocity.norm(), 0.);
}


TEST(Boundary, ExactFollowsTheReferenceInTime)
{
  const GasRun<1> run(riemann_problem +
                      std::vector<std::string>{"Boundaries/x high=exact"});
  const Tensor<1, 1> normal({1.});
  GasState<1> any;
  const Point<1> place(0.75);
  double before = 0., after = 0.;
  for (const double time : {0., 0.1, 0.2})
  {
    const auto state = run.boundary.outside(1, any, normal, place, time);
    expect_equal(state, run.reference.value(place, time));
    before = time == 0. ? state.pressure : before;
    after = state.pressure;
  }
  EXPECT_GT(std::abs(after - before), 0.1 * before);
}


TEST(Boundary, ClosedMeansWallsAndPeriodicSides)
{
  const GasRun<2> walls({});
  EXPECT_TRUE(walls.boundary.is_closed(walls.coarse_mesh));
  const GasRun<2> open({"Boundaries/y high=open"});
  EXPECT_FALSE(open.boundary.is_closed(open.coarse_mesh));
  const GasRun<2> inflow({"Boundaries/x low=inflow"});
  EXPECT_FALSE(inflow.boundary.is_closed(inflow.coarse_mesh));
  const GasRun<2> initial({"Boundaries/x low=initial"});
  EXPECT_FALSE(initial.boundary.is_closed(initial.coarse_mesh));
  // The kind of a periodic side does not matter.
  const GasRun<2> periodic(
    {"Boundaries/y high=open", "Domain/Periodic directions=y"});
  EXPECT_TRUE(periodic.boundary.is_closed(periodic.coarse_mesh));
  // Sides that the dimension does not have do not count.
  const GasRun<1> line({"Boundaries/y high=open"});
  EXPECT_TRUE(line.boundary.is_closed(line.coarse_mesh));
}


TEST(Boundary, BadInputIsRefused)
{
  EXPECT_NE(refusal<2>({"Boundaries/x low=exact"}).find("Reference/Kind"),
            std::string::npos);
  EXPECT_NE(refusal<2>({"Boundaries/x low=open", "Boundaries/By id=3 wall"})
              .find("By id"),
            std::string::npos);
  EXPECT_NE(refusal<2>({"Boundaries/By id=3: door"}).find("door"),
            std::string::npos);
  EXPECT_NE(refusal<2>({"Boundaries/By id=-3: wall"}).find("By id"),
            std::string::npos);
  EXPECT_NE(refusal<2>({"Boundaries/Inflow/Pressure=-1"}).find("Inflow"),
            std::string::npos);
  EXPECT_EQ(refusal<2>({"Boundaries/By id=3: open, 7: wall"}), "");
}


TEST(Boundary, WallsHoldTheGasBack)
{
  // Mirrored layer by layer: the half of a symmetric flow behaves as the
  // whole.
  const auto state = [](const Point<1> &p) {
    GasState<1> result;
    const double x = std::abs(p[0]);
    result.density = 1. + std::exp(-20. * (x - 0.4) * (x - 0.4));
    result.pressure = 1e5 * (1. + 3. * std::exp(-30. * (x - 0.4) * (x - 0.4)));
    return result;
  };
  for (const auto &method :
       {finite_volume(1),
        finite_volume(8),
        galerkin(3) + std::vector<std::string>{"Method/Blending=false"},
        galerkin(1),
        galerkin(2),
        galerkin(3),
        galerkin(3) + std::vector<std::string>{"Method/Limiter=superbee"}})
  {
    GasRun<1> half(method + std::vector<std::string>{"Domain/Coarse leaves=8"});
    GasRun<1> whole(method +
                    std::vector<std::string>{"Domain/Coarse leaves=16",
                                             "Domain/Lower corner=-1"});
    half.set_state(state);
    whole.set_state(state);
    for (unsigned int i = 0; i < 60; ++i)
    {
      half.step();
      whole.step();
    }
    EXPECT_NEAR(half.time, whole.time, 1e-12 * whole.time);
    double largest = 0.;
    for (unsigned int leaf = 0; leaf < 8; ++leaf)
    {
      const auto a = half.field.leaf(leaf);
      const auto b = whole.field.leaf(8 + leaf);
      for (unsigned int i = 0; i < a.size(); ++i)
        largest = std::max(largest,
                           std::abs(a[i] - b[i]) /
                             (i < half.layout.n_points ? 1. : 1e5));
    }
    EXPECT_LT(largest, 1e-11);
  }
}
