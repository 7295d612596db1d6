// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/cut_cell.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup::gas;

namespace
{
/// Values of a + b x + c y + d z at the corners of the unit cube.
template <unsigned int n>
std::array<double, n>
corners(const double a, const double b, const double c, const double d)
{
  std::array<double, n> result;
  for (unsigned int v = 0; v < n; ++v)
    result[v] = a + b * (v % 2) + c * (v / 2 % 2) + d * (v / 4);
  return result;
}
} // namespace


TEST(CutCell, SegmentsAndSquares)
{
  EXPECT_DOUBLE_EQ(positive_fraction<2>({{3., -1.}}), 0.75);
  EXPECT_EQ(positive_fraction<2>({{0., -1.}}), 0.);
  EXPECT_EQ(positive_fraction<2>({{1., 0.}}), 1.);
  // Triangles of both orientations, a trapezium, and its complement.
  EXPECT_NEAR(
    (positive_fraction<4>(corners<4>(0.5, -1., -1., 0.))), 0.125, 1e-15);
  EXPECT_NEAR(
    (positive_fraction<4>(corners<4>(-0.5, 1., -1., 0.))), 0.125, 1e-15);
  EXPECT_NEAR(
    (positive_fraction<4>(corners<4>(0.25, -1., 0.5, 0.))), 0.5, 1e-15);
  EXPECT_NEAR(
    (positive_fraction<4>(corners<4>(-0.3, 1., 0.2, 0.))), 0.8, 1e-15);
}


TEST(CutCell, CubesCutByPlanes)
{
  // x + y + z < s: s^3/6 for s up to 1, and by inclusion and exclusion on.
  const auto exact = [](const double s) {
    const auto cube = [](const double x) { return x > 0. ? x * x * x : 0.; };
    return (cube(s) - 3. * cube(s - 1.) + 3. * cube(s - 2.)) / 6.;
  };
  for (double s = 0.05; s < 3.; s += 0.1)
  {
    EXPECT_NEAR(
      (positive_fraction<8>(corners<8>(s, -1., -1., -1.))), exact(s), 1e-14);
    // The same mirrored in x, which the simplices are not.
    EXPECT_NEAR((positive_fraction<8>(corners<8>(s - 1., 1., -1., -1.))),
                exact(s),
                1e-14);
  }
}


TEST(CutCell, SmallAndEmptyParts)
{
  const double tiny = 1e-5;
  EXPECT_NEAR((positive_fraction<8>(corners<8>(tiny, -1., -1., -1.))),
              tiny * tiny * tiny / 6.,
              1e-25);
  EXPECT_EQ((positive_fraction<8>(corners<8>(0., -1., -1., -1.))), 0.);
  EXPECT_EQ((positive_fraction<8>(corners<8>(0.1, 1., 1., 1.))), 1.);
  EXPECT_NEAR((positive_fraction<8>(corners<8>(0., 1., 1., 1.))), 1., 1e-15);
}
