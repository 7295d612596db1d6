// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/run/modelling_plan.h>
#include <contrecoup/numerics/injury/expected_blast.h>
#include <contrecoup/numerics/injury/wave_reflection.h>

#include "../../named_value.h"
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <tuple>

using namespace contrecoup;
using namespace contrecoup::gas;

namespace
{
constexpr double pressure = 101325., density = 1.225;
const double sound_speed = std::sqrt(1.4 * pressure / density);

/// A charge at the origin of a quarter plane, open at x = 3 and y = 5.
ModellingPlan<2> quarter()
{
  ModellingPlan<2> plan;
  plan.energy = 4e6;
  plan.ambient.density = density;
  plan.ambient.pressure = pressure;
  plan.upper = dealii::Point<2>(3., 5.);
  plan.open_sides = {1, 3};
  plan.probes = {dealii::Point<2>(2., 0.), dealii::Point<2>(0., 1.)};
  plan.gauges = plan.probes;
  plan.end_time = 0.01;
  plan.smallest_subcell = 0.01;
  return plan;
}

/// Earliest arrival of this charge's front [s].
double arrival(const double distance, const double factor = 1.)
{
  return earliest_front(factor * 4e6, pressure, density, distance);
}

bool fails(const ModellingPlan<2> &plan, const std::string &name)
{
  for (const Assumption &item : plan.plan())
    if (item.name == name)
      return item.fails();
  ADD_FAILURE() << "no item " << name;
  return false;
}
} // namespace

// The shortest way to a mirrored probe: by x = 3 to (2, 0), at (4, 0).
TEST(ModellingPlan, KnowsTheFirstReflection)
{
  const ModellingPlan<2> plan = quarter();
  EXPECT_DOUBLE_EQ(value_of(plan.plan(), "reflection"), arrival(4.));

  // x = 3 was reached at 2 ms, y = 5 not yet.
  ModellingPlan<2>::Measurements measured;
  measured.time = 0.008;
  measured.smallest_subcell = 0.01;
  measured.side_arrivals.fill(OpenSides<2>::never);
  measured.side_arrivals[1] = 0.002;
  EXPECT_DOUBLE_EQ(value_of(plan.audit(measured), "reflection"),
                   0.002 + 1. / sound_speed);
  // No side was reached: nothing can be back sooner than from the nearest.
  measured.side_arrivals[1] = OpenSides<2>::never;
  measured.time = 0.01;
  for (const Assumption &item : plan.audit(measured))
    if (item.name == "reflection")
    {
      EXPECT_DOUBLE_EQ(item.value, 0.01 + 1. / sound_speed);
      EXPECT_EQ(
        item.quantity,
        "earliest possible reflection from an open side at the probe at 2, 0 m");
    }
}

// Along a side that it meets at grazing angle the front disturbs a probe sooner
// than sound could come back from there: the estimate stands. With both after
// the end there is nothing to judge.
TEST(ModellingPlan, LeavesTheEstimateWhereTheMeasuredReturnIsLater)
{
  ModellingPlan<2> plan = quarter();
  plan.upper[1] = 1.;
  plan.open_sides = {3};
  plan.gauges = {dealii::Point<2>(2.9, 0.)};
  const double expected = arrival(std::hypot(2.9, 2.));
  ModellingPlan<2>::Measurements measured;
  measured.smallest_subcell = 0.01;
  measured.side_arrivals.fill(OpenSides<2>::never);
  measured.side_arrivals[3] = expected - 1.5 / sound_speed;
  for (const double end : {1.1 * expected, 0.9 * expected})
  {
    plan.end_time = measured.time = end;
    EXPECT_DOUBLE_EQ(value_of(plan.plan(), "reflection"), expected);
    EXPECT_EQ(fails(plan, "reflection"), end > expected);
    EXPECT_EQ(std::isnan(value_of(plan.audit(measured), "reflection")),
              end > expected);
  }
}

// A wall close to the charge makes one wave with it; one through its centre is
// in the energy. That by a wall farther away merges with the front where the
// way is long against the distances of charge and gauge from it.
TEST(ModellingPlan, KnowsWhatWallsAdd)
{
  ModellingPlan<2> plan = quarter();
  plan.walls = {2};
  for (const auto &[height, gauge, factor] : {std::tuple{0., 0., 1.},
                                              std::tuple{0.05, 0., 2.},
                                              std::tuple{0.05, 0.05, 2.},
                                              std::tuple{0.5, 0.2, 2.},
                                              std::tuple{2., 2., 1.}})
  {
    plan.centre[1] = height;
    plan.gauges = {dealii::Point<2>(2., gauge)};
    EXPECT_DOUBLE_EQ(value_of(plan.plan(), "reflection"),
                     arrival(std::hypot(4., height - gauge), factor))
      << height;
    const double reach = plan.expected_reach(0.01);
    EXPECT_GE(arrival(1.0021 * reach, factor), 0.01) << height;
    EXPECT_LE(arrival(0.998 * reach, factor), 0.01) << height;
  }
}

// The way by the side opposite to the ground begins next to the ground.
TEST(ModellingPlan, FollowsTheReflectionByTheGroundUpwards)
{
  ModellingPlan<2> plan = quarter();
  plan.walls = {2};
  plan.open_sides = {3};
  plan.centre[1] = 1.5;
  plan.gauges = {dealii::Point<2>(0., 0.)};
  EXPECT_DOUBLE_EQ(value_of(plan.plan(), "reflection"), arrival(8.5));
}

// Waves due back after the stop are neither measured nor judged, whether the
// front is on its way to the side or from there; one that is back is.
TEST(ModellingPlan, JudgesOfAStoppedRunOnlyWhatItHasSeen)
{
  const ModellingPlan<2> plan = quarter();
  ModellingPlan<2>::Measurements measured;
  measured.smallest_subcell = 0.01;
  measured.side_arrivals.fill(OpenSides<2>::never);
  for (const auto &[side, stop, is_seen] :
       {std::tuple{OpenSides<2>::never, 0.003, false},
        std::tuple{0.002, 0.003, false},
        std::tuple{0.002, 0.006, true}})
  {
    measured.side_arrivals[1] = side;
    measured.time = stop;
    for (const Assumption &item : plan.audit(measured))
      if (item.name == "reflection")
      {
        EXPECT_EQ(std::isnan(item.value), !is_seen) << stop;
        EXPECT_EQ(item.fails(), is_seen) << stop;
      }
  }
}

// Those of lines and planes count as probes do, by the nearest to a side.
TEST(ModellingPlan, LooksAtAllGaugesForReflections)
{
  ModellingPlan<2> plan = quarter();
  plan.probes.clear();
  plan.gauges = {dealii::Point<2>(2., 0.), dealii::Point<2>(2.5, 0.5)};
  const std::vector<Assumption> items = plan.plan();
  EXPECT_DOUBLE_EQ(value_of(items, "reflection"),
                   arrival(std::hypot(3.5, 0.5)));
  for (const Assumption &item : items)
    if (item.name == "reflection")
      EXPECT_EQ(
        item.quantity,
        "first reflection from an open side at the probe at 2.5, 0.5 m");
    else
      EXPECT_NE(item.name, "air");
  plan.gauges.clear();
  for (const Assumption &item : plan.plan())
    EXPECT_NE(item.name, "reflection");
}

TEST(ModellingPlan, FailsWhenTheEndIsTooLate)
{
  ModellingPlan<2> plan = quarter();
  const double back = arrival(4.);
  for (const double factor : {0.9, 1.1})
  {
    plan.end_time = factor * back;
    EXPECT_EQ(fails(plan, "reflection"), factor > 1.);
  }
}

// Long runs feel gravity, and fine cells viscosity.
TEST(ModellingPlan, KnowsWhatItLeavesOut)
{
  ModellingPlan<2> plan = quarter();
  EXPECT_FALSE(fails(plan, "gravity"));
  EXPECT_FALSE(fails(plan, "viscosity"));
  EXPECT_FALSE(fails(plan, "air"));
  plan.end_time = 2.;
  plan.smallest_subcell = 1e-4;
  plan.probes = {dealii::Point<2>(0.1, 0.)};
  EXPECT_TRUE(fails(plan, "viscosity"));
  EXPECT_TRUE(fails(plan, "air"));
  plan.probes = {dealii::Point<2>(30., 0.)};
  EXPECT_TRUE(fails(plan, "gravity"));
  // sqrt(nu t) with nu = 1.8e-5 / 1.225.
  EXPECT_NEAR(value_of(plan.plan(), "viscosity"),
              std::sqrt(1.8e-5 / 1.225 * 2.) / 1e-4,
              1e-10);
}

// A domain that the front crosses at once has almost no quiet part, one that it
// hardly enters almost no other. Leaves that follow the front are few where it
// has not come yet.
TEST(ModellingPlan, EstimatesTheQuietPart)
{
  ModellingPlan<2> plan = quarter();
  plan.end_time = 1.;
  EXPECT_LT(value_of(plan.plan(), "quiet_leaves"), 0.02);
  plan.end_time = 1e-5;
  EXPECT_GT(value_of(plan.plan(), "quiet_leaves"), 0.95);
  plan.adapts = true;
  EXPECT_TRUE(std::isnan(value_of(plan.plan(), "quiet_leaves")));
}

TEST(ModellingPlan, SaysWhatFractionOfTheGasSumsAreOf)
{
  ModellingPlan<2> plan = quarter();
  for (const Assumption &item : plan.plan())
    EXPECT_NE(item.name, "modelled_part");
  plan.n_symmetry_planes = 2;
  EXPECT_EQ(value_of(plan.plan(), "modelled_part"), 0.25);
  ModellingPlan<2>::Measurements measured;
  measured.side_arrivals.fill(OpenSides<2>::never);
  EXPECT_EQ(value_of(plan.audit(measured), "modelled_part"), 0.25);
}

// The nearest side that is no plane through the charge is x = 3.
TEST(ModellingPlan, KnowsHowLongOneDimensionWouldDo)
{
  ModellingPlan<2> plan = quarter();
  plan.end_time = 0.1;
  const ExpectedBlast blast(4e6, pressure, density);
  EXPECT_DOUBLE_EQ(value_of(plan.plan(), "first_stage"),
                   blast.arrival(3.) / 0.1);
  plan.end_time = 1e-4;
  EXPECT_EQ(value_of(plan.plan(), "first_stage"), 1.);
}

TEST(ModellingPlan, AsksForAnEquationOfStateOfProducts)
{
  ModellingPlan<2> plan = quarter();
  ModellingPlan<2>::Measurements measured;
  measured.time = 0.008;
  measured.smallest_subcell = 0.01;
  measured.side_arrivals.fill(OpenSides<2>::never);
  measured.non_ideal_fraction = 0.25;
  // Gas from a first stage is not in the plan of the second.
  EXPECT_EQ(value_of(plan.audit(measured), "equation_of_state"), 0.25);
  plan.non_ideal_fraction = 0.75;
  EXPECT_EQ(value_of(plan.plan(), "equation_of_state"), 0.75);
  EXPECT_EQ(value_of(plan.audit(measured), "equation_of_state"), 0.25);
}

TEST(ModellingPlan, SaysNothingOfUnknownBlastsAndOtherGases)
{
  ModellingPlan<2> plan = quarter();
  plan.energy = 0.;
  EXPECT_TRUE(std::isnan(value_of(plan.plan(), "reflection")));
  EXPECT_TRUE(std::isnan(plan.expected_front(1.)));
  plan.ambient.pressure = 1.;
  for (const Assumption &item : plan.plan())
    EXPECT_TRUE(item.name == "reflection" || item.name == "quiet_leaves");
}


// As that of a pressure in kPa.
TEST(ModellingPlan, KeepsTheItemsOfUnusualAirAroundExplosives)
{
  ModellingPlan<2> plan = quarter();
  plan.ambient.pressure = 101.325;
  plan.surrounds_explosives = true;
  for (const char *name : {"air", "gravity", "viscosity", "heat_conduction"})
    EXPECT_TRUE(std::isnan(value_of(plan.plan(), name))) << name;
}

TEST(ModellingPlan, RemembersItsBlast)
{
  ModellingPlan<2> plan = quarter(), other;
  plan.centre = dealii::Point<2>(1. / 3., 2. / 3.);
  std::stringstream stream;
  plan.save(stream);
  other.load(stream);
  EXPECT_EQ(other.energy, plan.energy);
  EXPECT_EQ(other.centre, plan.centre);
}
