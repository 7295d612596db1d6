// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

#include <gtest/gtest.h>

using namespace contrecoup;
using dealii::Point;

namespace
{
/// A ball in a ball, with a bar through both, cut by a box.
BodyPointer make_body()
{
  const auto outer = std::make_shared<Sphere>(Point<3>(), 1.);
  const auto inner = std::make_shared<Sphere>(Point<3>(0.2, 0., 0.), 0.5);
  const auto bar = std::make_shared<Cylinder>(
    Point<3>(0., 0., -2.), Point<3>(0., 0.3, 2.), 0.15);
  const auto box =
    std::make_shared<RoundedBox>(Point<3>(0.1, 0., 0.), Point<3>(0.9, 2., 2.));
  return std::make_shared<ShapeBody>(
    std::make_shared<Intersection>(
      std::make_shared<Union>(std::vector<ShapePointer>{outer, bar}), box),
    std::vector<ShapeBody::PartShape>{{{"bar", Tissue::skeleton}, bar},
                                      {{"inner", Tissue::brain}, inner},
                                      {{"outer", Tissue::soft_tissue}, outer}});
}

double volume_of(const LabelGrid &grid, const unsigned char label)
{
  return grid.volume() *
         std::count(grid.labels.begin(), grid.labels.end(), label);
}
} // namespace


TEST(Body, FillGivesEveryCubeThePartAtItsCentre)
{
  for (const Placement &placement :
       {Placement(),
        Placement(1.2, Point<3>(0.3, 0.2, -1.), Point<3>(3., 2., 1.))})
  {
    const BodyPointer body = make_body()->placed(placement);
    LabelGrid grid = make_grid(body->surface()->bounding_box(), 0.07);
    body->fill(grid);
    std::array<unsigned int, 4> count{};
    for (unsigned int k = 0; k < grid.size[2]; ++k)
      for (unsigned int j = 0; j < grid.size[1]; ++j)
        for (unsigned int i = 0; i < grid.size[0]; ++i)
        {
          const unsigned char part = body->part_at(grid.center(i, j, k));
          ASSERT_EQ(grid.at(i, j, k), part) << grid.center(i, j, k);
          ++count[std::min<unsigned int>(part, 3)];
        }
    for (const unsigned int n : count)
      EXPECT_GT(n, 500u);
  }
}


TEST(Body, CubesMakeTheVolumeOfABall)
{
  const auto ball = std::make_shared<Sphere>(Point<3>(0.1, 0.2, 0.3), 0.5);
  const ShapeBody body(ball, {{{"ball", Tissue::water}, ball}});
  LabelGrid grid = make_grid(ball->bounding_box(), 0.02);
  body.fill(grid);
  // The lattice count of a ball's volume is off by less than (h / R)^1.5.
  EXPECT_NEAR(volume_of(grid, 0) / (4. / 3. * M_PI * 0.125), 1., 8e-3);
}


TEST(Body, PlacedBodiesKeepTheirParts)
{
  const BodyPointer body = make_body();
  const Placement placement(0.5, Point<3>(0., 0., 1.), Point<3>(1., 0., 0.));
  const BodyPointer placed = body->placed(placement);
  ASSERT_EQ(placed->parts().size(), 3u);
  EXPECT_EQ(placed->parts()[1].name, "inner");
  for (const Point<3> &point :
       {Point<3>(0., 0., 0.), Point<3>(0.5, 0.1, 0.), Point<3>(0.1, 0.8, 0.)})
    EXPECT_EQ(placed->part_at(placement.apply(point)), body->part_at(point));
}


TEST(LabelGrid, CoversItsBoxWithRoomToSpare)
{
  const dealii::BoundingBox<3> box(
    {Point<3>(-0.31, 0.2, 0.), Point<3>(0.5, 0.9, 1.)});
  const LabelGrid grid = make_grid(box, 0.1);
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double end = grid.origin[d] + grid.size[d] * grid.spacing;
    EXPECT_LE(grid.origin[d], box.lower_bound(d) - 0.1 + 1e-12);
    EXPECT_GE(end, box.upper_bound(d) + 0.1 - 1e-12);
    EXPECT_LE(grid.size[d], box.side_length(d) / 0.1 + 4.);
  }
  EXPECT_NEAR(grid.origin[2] / 0.1, std::round(grid.origin[2] / 0.1), 1e-12);
  EXPECT_EQ(grid.labels.size(),
            std::size_t(grid.size[0]) * grid.size[1] * grid.size[2]);
  EXPECT_EQ(grid.label_or_outside(-1, 0, 0), LabelGrid::outside);
}


TEST(LabelGrid, TooManyCubesAreRefusedWithTheirSize)
{
  const dealii::BoundingBox<3> box({Point<3>(), Point<3>(1., 1., 2.)});
  try
  {
    make_grid(box, 1e-5);
    FAIL() << "not refused";
  }
  catch (const InputError &error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("1e-05 m"), std::string::npos) << message;
    EXPECT_NE(message.find("1 x 1 x 2 m"), std::string::npos) << message;
  }
}


// Labels as digits, "." for nothing; layers of 3 x 3 cubes.
std::array<unsigned int, 256> count_pieces(const std::string &picture)
{
  LabelGrid grid;
  grid.spacing = 1.;
  grid.size = {{3, 3, 2}};
  for (const char c : picture)
    if (c != ' ')
      grid.labels.push_back(c == '.' ? LabelGrid::outside : c - '0');
  return count_components(grid);
}


TEST(LabelGrid, PiecesAreConnectedThroughFaces)
{
  // A ring around a cube.
  const auto ring = count_pieces("000 010 000  ... ... ...");
  EXPECT_EQ(ring[0], 1u);
  EXPECT_EQ(ring[1], 1u);
  EXPECT_EQ(ring[LabelGrid::outside], 1u);
  // Cubes that touch at edges only, next to two on top of each other.
  const auto diagonal = count_pieces("0.. .0. ..2  .0. ... ..2");
  EXPECT_EQ(diagonal[0], 3u);
  EXPECT_EQ(diagonal[2], 1u);
  EXPECT_EQ(diagonal[LabelGrid::outside], 4u);
  // A bow that stands on its two ends.
  const auto bow = count_pieces("1.1 ... ...  111 ... 1..");
  EXPECT_EQ(bow[1], 2u);
  EXPECT_EQ(bow[0], 0u);
}
