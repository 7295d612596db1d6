// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/cut_cell.h>
#include <contrecoup/gas/body/facet_outline.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup::gas;
using dealii::Point;
using dealii::Tensor;

namespace
{
/// Area vector of a closed polygon.
Tensor<1, 3> area_of(const std::vector<Point<3>> &outline)
{
  Tensor<1, 3> sum;
  for (std::size_t i = 0; i < outline.size(); ++i)
    sum += 0.5 * dealii::cross_product_3d(outline[i],
                                          outline[(i + 1) % outline.size()]);
  return sum;
}


/// Area vector of the wall, into the gas, from the openings of the faces.
Tensor<1, 3> wall_of(const std::array<double, 8> &values)
{
  Tensor<1, 3> wall;
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int side = 0; side < 2; ++side)
    {
      // The other directions in ascending order, as in cut_shape().
      const unsigned int a = d == 0 ? 1 : 0, b = d == 2 ? 1 : 2;
      std::array<double, 4> face;
      for (unsigned int v = 0; v < 4; ++v)
        face[v] = values[(side << d) + (v % 2 << a) + (v / 2 << b)];
      wall[d] += (side == 0 ? -1. : 1.) * positive_fraction<4>(face);
    }
  return wall;
}


/// Numbers from -1 to 1 that look like chance.
double next(unsigned int &seed)
{
  seed = 1664525U * seed + 1013904223U;
  return 2. * seed / 4294967296. - 1.;
}
} // namespace


TEST(FacetOutline, APlaneCutsASquare)
{
  // x = 0.25, gas where x is larger.
  std::array<double, 8> values;
  for (unsigned int v = 0; v < 8; ++v)
    values[v] = (v % 2) - 0.25;
  const auto outline = cut_outline<3>(values);
  EXPECT_EQ(outline.size(), 8U); // cuts of four edges and four diagonals
  for (const Point<3> &corner : outline)
    EXPECT_NEAR(corner[0], 0.25, 1e-15);
  EXPECT_NEAR((area_of(outline) - Point<3>(1, 0, 0)).norm(), 0., 1e-14);
}


TEST(FacetOutline, HasTheAreaVectorOfTheOpenings)
{
  unsigned int seed = 1;
  unsigned int n_cut = 0;
  for (unsigned int i = 0; i < 2000; ++i)
  {
    std::array<double, 8> values;
    for (double &value : values)
      value = next(seed);
    // Corners on the surface, and whole faces of them.
    for (unsigned int v = 0; v < i % 5; ++v)
      values[v] = 0.;
    const auto outline = cut_outline<3>(values);
    n_cut += outline.empty() ? 0 : 1;
    EXPECT_NEAR((area_of(outline) - wall_of(values)).norm(), 0., 1e-12) << i;
  }
  EXPECT_GT(n_cut, 1900U);
}


TEST(FacetOutline, NeighborsShareTheCutOfTheirFace)
{
  unsigned int seed = 7;
  std::array<double, 8> left, right;
  for (double &value : left)
    value = next(seed);
  for (double &value : right)
    value = next(seed);
  for (unsigned int v = 0; v < 8; v += 2)
    right[v] = left[v + 1];
  std::vector<Point<3>> shared;
  for (const Point<3> &place : cut_outline<3>(left))
    if (place[0] == 1.)
      shared.push_back(place);
  EXPECT_GE(shared.size(), 2U);
  const auto other = cut_outline<3>(right);
  for (Point<3> place : shared)
  {
    place[0] = 0.;
    EXPECT_NE(std::find(other.begin(), other.end(), place), other.end());
  }
}


TEST(FacetOutline, LinesRunFromEdgeToEdge)
{
  const auto line = cut_outline<2>({{1., -1., 1., -3.}});
  ASSERT_GE(line.size(), 2U);
  const double ends[] = {line.front()[1], line.back()[1]};
  EXPECT_EQ(std::min(ends[0], ends[1]), 0.);
  EXPECT_EQ(std::max(ends[0], ends[1]), 1.);
  for (const Point<2> &place : line)
    EXPECT_TRUE(place[0] > 0.2 && place[0] < 0.6);
  EXPECT_TRUE(cut_outline<2>({{1., 1., 1., 1.}}).empty());
  EXPECT_TRUE(cut_outline<3>({{1., 1., 1., 1., 1., 1., 1., 1.}}).empty());
}


TEST(FacetOutline, ClosedFacesOfACube)
{
  for (unsigned int set = 0; set < 64; ++set)
  {
    std::array<bool, 6> is_closed;
    Tensor<1, 3> area;
    for (unsigned int face = 0; face < 6; ++face)
    {
      is_closed[face] = (set >> face & 1U) != 0;
      if (is_closed[face])
        area[face / 2] += face % 2 == 0 ? 1. : -1.;
    }
    EXPECT_NEAR(
      (area_of(closed_outline<3>(is_closed)) - area).norm(), 0., 1e-14)
      << set;
  }
}


TEST(FacetOutline, ClosedEdgesOfASquare)
{
  EXPECT_TRUE(closed_outline<2>({{false, false, false, false}}).empty());
  const auto corner = closed_outline<2>({{true, false, false, true}});
  ASSERT_EQ(corner.size(), 3U);
  EXPECT_EQ(corner[0], Point<2>(0., 0.));
  EXPECT_EQ(corner[1], Point<2>(0., 1.));
  EXPECT_EQ(corner[2], Point<2>(1., 1.));
}
