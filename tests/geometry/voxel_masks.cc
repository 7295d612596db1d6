// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/image/voxel_mask.h>
#include <contrecoup/geometry/shape/grid_distance.h>

#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using dealii::Point;
using dealii::Tensor;

namespace
{
VoxelMask ball_mask(const unsigned int n, const double radius)
{
  VoxelMask mask{{{n, n, n}}, {{0.1, 0.1, 0.1}}, {}};
  for (unsigned int k = 0; k < n; ++k)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        mask.inside.push_back(
          0.1 * Point<3>(i, j, k).distance(Point<3>(n, n, n) * 0.5) < radius);
  return mask;
}

Tensor<2, 3> diagonal(const double spacing)
{
  Tensor<2, 3> axes;
  for (unsigned int d = 0; d < 3; ++d)
    axes[d][d] = spacing;
  return axes;
}
} // namespace


TEST(VoxelMask, DistanceIsThatOfTheNearestVoxel)
{
  VoxelMask mask{{{7, 5, 6}}, {{1., 0.5, 2.}}, {}};
  std::mt19937 generator(4);
  for (unsigned int i = 0; i < 7 * 5 * 6; ++i)
    mask.inside.push_back(generator() % 20 == 0);
  ASSERT_GT(mask.count(), 3u);
  const auto center = [](const unsigned int i) {
    return Point<3>(i % 7, 0.5 * (i / 7 % 5), 2. * (i / 35));
  };
  const std::vector<float> found = distance_to(mask);
  for (unsigned int i = 0; i < found.size(); ++i)
  {
    double least = 1e9;
    for (unsigned int j = 0; j < found.size(); ++j)
      if (mask.inside[j])
        least = std::min(least, center(i).distance(center(j)));
    EXPECT_NEAR(found[i], least, 1e-5);
  }
}


TEST(VoxelMask, HolesGapsAndPieces)
{
  // A box open to the bottom, with a slit in its lid, and a crumb.
  VoxelMask mask{{{12, 12, 12}}, {{1., 1., 1.}}, {}};
  for (unsigned int k = 0; k < 12; ++k)
    for (unsigned int j = 0; j < 12; ++j)
      for (unsigned int i = 0; i < 12; ++i)
      {
        const bool in_box = i >= 2 && i <= 9 && j >= 2 && j <= 9 && k <= 8;
        const bool in_wall = i == 2 || i == 9 || j == 2 || j == 9 || k == 8;
        const bool in_slit = k == 8 && i == 5 && j >= 3 && j <= 8;
        mask.inside.push_back((in_box && in_wall && !in_slit) ||
                              (i == 11 && j == 11 && k == 11));
      }
  const VoxelMask walls = largest_piece(mask);
  EXPECT_EQ(walls.count(), mask.count() - 1);
  EXPECT_EQ(with_filled_holes(walls).count(), walls.count());
  const VoxelMask shut = closed(walls, 2.5);
  EXPECT_EQ(shut.inside[5 + 12 * (5 + 12 * 8)], 1);
  EXPECT_EQ(with_filled_holes(shut).inside[6 + 12 * (6 + 12 * 1)], 1);
  EXPECT_EQ(with_filled_holes(shut).count(), 8u * 8u * 9u);
}


// From afar the projection along the gradients of a grid misses the nearest
// voxel by several.
TEST(GridDistance, FindsTheNearestPlaceFromAfar)
{
  VoxelMask mask{{{40, 40, 60}}, {{0.1, 0.1, 0.1}}, {}};
  std::vector<Point<3>> centers;
  for (unsigned int k = 0; k < 60; ++k)
    for (unsigned int j = 0; j < 40; ++j)
      for (unsigned int i = 0; i < 40; ++i)
      {
        const double x = (i - 20.) / 18., y = (j - 20.) / 14.,
                     z = (k - 30.) / 26.;
        mask.inside.push_back(x * x + y * y + z * z < 1.);
        if (mask.inside.back())
          centers.push_back(Point<3>(0.1 * i, 0.1 * j, 0.1 * k));
      }
  const GridDistance shape(mask, diagonal(0.1), Tensor<1, 3>());
  for (const Point<3> &point : {Point<3>(15., 2.3, 3.),
                                Point<3>(15., 4., 3.),
                                Point<3>(15., 9., 8.),
                                Point<3>(12., 14., -3.),
                                Point<3>(4.5, 4.5, 7.)})
  {
    double least = 1e9;
    for (const Point<3> &center : centers)
      least = std::min(least, point.distance(center));
    EXPECT_NEAR(point.distance(shape.nearest(point)), least - 0.05, 0.06)
      << point;
  }
}


TEST(GridDistance, IsCloseToABallAndNeverTooLarge)
{
  const double radius = 0.8;
  const VoxelMask mask = ball_mask(24, radius);
  const GridDistance shape(mask, diagonal(0.1), Tensor<1, 3>());
  const Point<3> center(1.2, 1.2, 1.2);
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> place(-1., 3.4);
  const auto sample = [&]() {
    return Point<3>(place(generator), place(generator), place(generator));
  };
  for (unsigned int i = 0; i < 500; ++i)
  {
    const Point<3> p = sample();
    const double exact = p.distance(center) - radius;
    EXPECT_LE(std::abs(shape.value(p)), std::abs(exact) + 0.1) << p;
    if (std::abs(exact) > 0.1)
    {
      EXPECT_EQ(shape.value(p) > 0., exact > 0.) << p;
    }
    if (exact > 0.1 && exact < 0.3)
    {
      EXPECT_GT(shape.normal(p) * (p - center) / p.distance(center), 0.8) << p;
    }
    for (const Point<3> &q : {sample(), p + 0.01 * (sample() - p)})
      EXPECT_LE(std::abs(shape.value(p) - shape.value(q)),
                p.distance(q) * (1. + 1e-6) + 1e-6);
    EXPECT_LT((shape.gradient(p) - shape.Shape::gradient(p)).norm(), 0.05) << p;
  }
  for (unsigned int i = 0; i < mask.inside.size(); ++i)
  {
    const Point<3> p(0.1 * (i % 24), 0.1 * (i / 24 % 24), 0.1 * (i / 576));
    EXPECT_EQ(shape.value(p) < 0., mask.inside[i] == 1);
  }
}
