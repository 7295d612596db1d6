// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/io/course_forecast.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace contrecoup;
using namespace contrecoup::io;

namespace
{
constexpr unsigned int coarse = 1, fine = 2, run = 3;

// A man before C-4 (blast/showcase/c4_human.prm with three levels of the body):
// simulated time [ms], what trials with cells four and two times as large, and
// the run itself had cost until then [s]. At 1.6 ms the mesh becomes 3-D; from
// 5 ms on the scene lets it get coarse.
const std::vector<std::array<double, 4>> rows = {
  {{0, 0, 0, 0}},
  {{0.1, 0.9716, 0.2536, 0.2562}},
  {{0.2, 1.582, 0.4131, 0.4173}},
  {{0.3, 2.089, 0.5453, 0.5508}},
  {{0.4, 2.515, 0.6566, 0.6633}},
  {{0.5, 2.881, 0.752, 0.7597}},
  {{0.6, 4.358, 2.728, 2.401}},
  {{0.7, 6.077, 5.446, 4.809}},
  {{0.8, 7.967, 8.625, 7.693}},
  {{0.9, 10.14, 12.22, 10.91}},
  {{1, 12.82, 16.49, 14.57}},
  {{1.1, 16.25, 21.72, 18.99}},
  {{1.2, 19.52, 26.97, 23.85}},
  {{1.3, 21.98, 31.02, 27.04}},
  {{1.4, 22.94, 35.37, 30.89}},
  {{1.5, 23.77, 40.05, 35.36}},
  {{1.6, 24.6, 43.42, 39.59}},
  {{1.867, 26.92, 52.83, 52.27}},
  {{2.133, 29.19, 63.04, 67.12}},
  {{2.4, 31.38, 72.65, 82}},
  {{2.667, 33.38, 81.52, 96.71}},
  {{2.933, 35.25, 89.96, 111.8}},
  {{3.2, 37.13, 98.39, 126.6}},
  {{3.467, 38.98, 106.5, 141.2}},
  {{3.733, 40.77, 114.6, 156.3}},
  {{4, 42.5, 122.6, 171.5}},
  {{4.267, 44.21, 130.3, 186.6}},
  {{4.533, 45.94, 138.2, 202.1}},
  {{4.8, 47.69, 146.2, 218.5}},
  {{5.067, 49.39, 153.7, 232.3}},
  {{5.333, 50.94, 157.6, 235.6}},
  {{5.6, 52.48, 161.3, 238.5}},
  {{5.867, 53.99, 165.2, 241.3}},
  {{6.133, 55.59, 169.1, 244.2}},
  {{6.4, 57.09, 173, 247}},
  {{6.667, 58.6, 177, 249.9}},
  {{6.933, 60.1, 181, 252.7}},
  {{7.2, 61.6, 185, 255.4}},
  {{7.467, 63.11, 189, 258.1}},
  {{7.733, 64.62, 193, 260.7}},
  {{8, 66.12, 196.9, 263.3}},
  {{8.267, 67.62, 200.5, 265.2}},
  {{8.533, 69.13, 204, 266.9}},
  {{8.8, 70.64, 207.4, 268.5}},
  {{9.067, 72.18, 210.9, 270.2}},
  {{9.333, 73.68, 214.3, 271.9}},
  {{9.6, 75.19, 217.6, 273.6}},
  {{9.867, 76.7, 221, 275.2}},
  {{10.13, 78.21, 224.3, 276.9}},
  {{10.4, 79.72, 227.6, 278.5}},
  {{10.67, 81.23, 230.9, 280.2}},
  {{10.93, 82.73, 234.2, 281.9}},
  {{11.2, 84.23, 237.4, 283.5}},
  {{11.47, 85.74, 240.6, 285.2}},
  {{11.73, 87.24, 243.8, 286.8}},
  {{12, 88.78, 247.1, 288.5}}};

constexpr double begin_of_3d = 1.6;

ExpectedCourse course_of(const unsigned int column)
{
  ExpectedCourse course;
  for (const auto &row : rows)
    course.emplace_back(1e-3 * row[0], row[column]);
  return course;
}

Trial trial_of(const unsigned int column, const unsigned int levels)
{
  Trial trial;
  trial.levels = levels;
  for (const unsigned int dimension : {2, 3})
  {
    trial.stages.push_back({dimension});
    for (const auto &row : rows)
      if (dimension == 2 ? row[0] <= begin_of_3d : row[0] >= begin_of_3d)
        trial.stages.back().course.emplace_back(1e-3 * row[0], row[column]);
  }
  return trial;
}

/// Largest factor between what is said to be left and what is, from a tenth of
/// the cost to nineteen twentieths.
double largest_factor(const ExpectedCourse &course, const double slowness)
{
  const ExpectedCourse found = course_of(run);
  const double end = found.back().first;
  const double whole = slowness * found.back().second;
  RemainingTime remaining(0., end, course);
  double largest = 1.;
  for (const auto &[time, seconds] : found)
  {
    const double cost = slowness * seconds;
    remaining.add(time, cost);
    if (cost < 0.1 * whole || cost > 0.95 * whole)
      continue;
    const double factor = remaining.left() / (whole - cost);
    largest = std::max({largest, factor, 1. / factor});
  }
  return largest;
}
} // namespace


TEST(CourseForecast, TellsTheTimeLeftOfAnAdaptiveRun)
{
  const auto first = course_of(fine);
  const double in_2d = cost_until(first, 1e-3 * begin_of_3d);
  const ExpectedCourse course =
    forecast_course(trial_of(coarse, 2),
                    trial_of(fine, 1),
                    {in_2d, first.back().second - in_2d});
  for (const double slowness : {0.3, 1., 4.})
    EXPECT_LT(largest_factor(course, slowness), 1.6) << slowness;
  // Neither the run's past alone nor one trial tells as much.
  EXPECT_GT(largest_factor({}, 1.), 2.);
  EXPECT_GT(largest_factor(first, 1.), 2.);
}


// Of two spans one costs four times as much on finer meshes, one the same.
TEST(CourseForecast, MomentsGrowAsTheyDidBetweenTrials)
{
  Trial before, last;
  before.levels = 3;
  last.levels = 2;
  before.stages.push_back({3});
  before.stages[0].course = {{0., 0.}, {1., 10.}, {2., 20.}};
  last.stages.push_back({3});
  last.stages[0].course = {{0., 0.}, {1., 40.}, {2., 50.}};
  const ExpectedCourse course = forecast_course(before, last, {650.});
  EXPECT_NEAR(cost_until(course, 1.), 640., 1e-9);
  EXPECT_NEAR(cost_until(course, 2.), 650., 1e-9);
  const ExpectedCourse alone = forecast_course({}, last, {100.});
  EXPECT_NEAR(cost_until(alone, 1.), 80., 1e-9);
}


TEST(CourseForecast, TrialsWithoutStepsHaveNoCourse)
{
  EXPECT_TRUE(forecast_course({}, {}, {}).empty());
}
