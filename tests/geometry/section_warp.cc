// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/body/organ_fit.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>
#include <contrecoup/geometry/shape/section_warp.h>

#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using dealii::Point;

namespace
{
/// A leaning, twisted limb that becomes wider upwards.
SectionWarp make_warp()
{
  SectionFrame frame, new_frame;
  new_frame.origin = Point<3>(0.1, 0.2, 0.3);
  new_frame.along = Point<3>(0.6, 0., 0.8);
  new_frame.first = Point<3>(0.8, 0., -0.6);
  new_frame.second = Point<3>(0., 1., 0.);
  std::vector<SectionPair> pairs(3);
  for (unsigned int i = 0; i < 3; ++i)
  {
    pairs[i].station = 0.5 * i;
    pairs[i].new_station = 0.1 + 0.6 * i;
    pairs[i].center[0] = 0.02 * i;
    pairs[i].new_center[1] = 0.05 * i * i;
    pairs[i].ratio[0] = 1. + 0.1 * i;
    pairs[i].ratio[1] = 0.9;
    pairs[i].turn = 0.1;
    pairs[i].new_turn = 0.3 * i;
  }
  return SectionWarp(frame, new_frame, pairs);
}
} // namespace


TEST(SectionWarp, CarriesCentersAndWidths)
{
  const SectionWarp warp = make_warp();
  const Point<3> center = warp.apply(Point<3>(0.02, 0., 0.5));
  EXPECT_LT(center.distance(warp.new_frame().point({{0.7, 0., 0.05}})), 1e-12);
  // A point along the first direction of the section's widths.
  const Point<3> beside =
    warp.apply(Point<3>(0.02 + 0.1 * std::cos(0.1), 0.1 * std::sin(0.1), 0.5));
  EXPECT_NEAR(beside.distance(center), 0.11, 1e-12);
  EXPECT_NEAR(
    (beside - center) * warp.new_frame().second, 0.11 * std::sin(0.3), 1e-12);
}


TEST(SectionWarp, IsInvertedExactlyAlsoBeyondItsEnds)
{
  const SectionWarp warp = make_warp();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-1., 2.);
  for (unsigned int i = 0; i < 1000; ++i)
  {
    const Point<3> point(place(random), place(random), place(random));
    EXPECT_LT(warp.pull_back(warp.apply(point)).distance(point), 1e-12);
  }
}


TEST(WarpedShape, HasTheVolumeAndNoLargerSlopeThanOne)
{
  const auto ball = std::make_shared<Sphere>(Point<3>(0.03, 0.01, 0.4), 0.2);
  const WarpedShape warped(ball, make_warp());
  const LabelGrid grid = fill_shape(warped, 0.005);
  double sum = 0.;
  for (unsigned int k = 0; k < grid.size[2]; ++k)
    for (unsigned int j = 0; j < grid.size[1]; ++j)
      for (unsigned int i = 0; i < grid.size[0]; ++i)
      {
        const Point<3> point = grid.center(i, j, k);
        const bool is_inside = ball->value(make_warp().pull_back(point)) <= 0.;
        EXPECT_EQ(grid.at(i, j, k) != LabelGrid::outside, is_inside);
        sum += is_inside ? grid.volume() : 0.;
      }
  // Lengths along the limb by 1.2, widths by 1.08 at the centre and 0.9.
  const double volume = 4. / 3. * dealii::numbers::PI * std::pow(0.2, 3);
  EXPECT_NEAR(sum / (volume * 1.2 * 1.08 * 0.9), 1., 0.01);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-0.2, 1.2), step(-0.02, 0.02);
  for (unsigned int i = 0; i < 10000; ++i)
  {
    const Point<3> a(place(random), place(random), place(random));
    const Point<3> b = a + Point<3>(step(random), step(random), step(random));
    if (warped.value(a) < 0. && warped.value(b) < 0.)
    {
      EXPECT_LE(std::abs(warped.value(a) - warped.value(b)), a.distance(b));
    }
  }
}


TEST(OrganFit, MovesBonesIntoALimb)
{
  // A bone off the middle of its limb, and one as thick as that.
  const Cylinder limb({0.02, 0., -0.2}, {0.02, 0., 0.8}, 0.03);
  constexpr double depth = 0.001;
  for (const double radius : {0.015, 0.035})
  {
    const OrganSurface bone(
      Cylinder({0., 0., 0.12}, {0., 0., 0.48}, radius), 0.006, 0.);
    std::vector<SectionPair> pairs(7);
    for (unsigned int i = 0; i < pairs.size(); ++i)
      pairs[i].station = pairs[i].new_station = 0.1 * i;
    const SectionWarp before({}, {}, pairs);
    EXPECT_LT(bone.least_depth(limb, before), 0.);
    const SectionWarp after = with_limb_inside(before, limb, bone, depth);
    EXPECT_GE(bone.least_depth(limb, after), depth);
    for (unsigned int i = 1; i < 6; ++i)
    {
      const SectionPair &pair = after.pairs()[i];
      EXPECT_NEAR(pair.new_center[1], 0., 1e-3);
      EXPECT_GT(pair.new_center[0], 0.005);
      EXPECT_GT(pair.ratio[0], radius < 0.03 ? 0.9 : 0.6);
    }
    // A bone that is deep enough stays as it is.
    const SectionWarp again = with_limb_inside(after, limb, bone, depth);
    for (unsigned int i = 0; i < 7; ++i)
      EXPECT_EQ(again.pairs()[i].ratio[0], after.pairs()[i].ratio[0]);
  }
}
