// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using dealii::Point;
using dealii::Tensor;

namespace
{
struct Case
{
  std::string name;
  ShapePointer shape;
  bool is_exact; ///< value() is the true distance outside
};

std::vector<Case> cases()
{
  const auto sphere = std::make_shared<Sphere>(Point<3>(0.1, 0.2, -0.1), 0.3);
  const auto ellipsoid = std::make_shared<Ellipsoid>(
    Point<3>(0., 0.1, 0.), Tensor<1, 3>({0.5, 0.2, 0.3}));
  const auto box = std::make_shared<RoundedBox>(
    Point<3>(0.3, 0., 0.), Tensor<1, 3>({0.2, 0.3, 0.1}), 0.05);
  const auto cylinder = std::make_shared<Cylinder>(
    Point<3>(-0.2, 0., 0.), Point<3>(0.3, 0.1, 0.2), 0.15);
  const auto sweep = std::make_shared<Sweep>(
    std::vector<Sweep::Node>{{Point<3>(-0.4, 0., 0.), 0.1},
                             {Point<3>(0., 0.1, 0.), 0.2},
                             {Point<3>(0.3, -0.2, 0.2), 0.05}});
  const Placement placement(
    1.5, Point<3>(0.3, -0.5, 1.), Point<3>(0.1, 0.2, 0.3));
  return {
    {"sphere", sphere, true},
    {"ellipsoid", ellipsoid, true},
    {"rounded box", box, true},
    {"cylinder", cylinder, true},
    {"sweep", sweep, true},
    {"union",
     std::make_shared<Union>(std::vector<ShapePointer>{sphere, box}),
     true},
    {"blend",
     std::make_shared<Union>(std::vector<ShapePointer>{sphere, box, sweep},
                             0.1),
     false},
    {"difference",
     std::make_shared<Intersection>(box, sphere, Intersection::With::outside),
     false},
    {"intersection",
     std::make_shared<Intersection>(ellipsoid, cylinder),
     false},
    {"offset", std::make_shared<Offset>(ellipsoid, 0.05), true},
    {"placed", std::make_shared<PlacedShape>(ellipsoid, placement), true}};
}

/// Points in and around a shape.
std::vector<Point<3>> samples(const Shape &shape, const unsigned int count)
{
  dealii::BoundingBox<3> box = shape.bounding_box();
  box.extend(0.2);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> unit(0., 1.);
  std::vector<Point<3>> points;
  for (unsigned int i = 0; i < count; ++i)
    points.push_back(
      box.unit_to_real({unit(generator), unit(generator), unit(generator)}));
  return points;
}
} // namespace


TEST(Shape, ValueNeverChangesByMoreThanTheWayGone)
{
  for (const Case &c : cases())
  {
    const auto points = samples(*c.shape, 400);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      // A far pair and a near one.
      const Point<3> near = points[i] + 0.01 * (points[i + 1] - points[i]);
      for (const Point<3> &other : {points[i + 1], near})
        ASSERT_LE(std::abs(c.shape->value(points[i]) - c.shape->value(other)),
                  points[i].distance(other) * (1. + 1e-9) + 1e-12)
          << c.name << " at " << points[i] << " and " << other;
    }
  }
}


TEST(Shape, GradientIsThatOfTheValueAndPointsOut)
{
  for (const Case &c : cases())
  {
    unsigned int n_smooth = 0;
    const auto points = samples(*c.shape, 300);
    for (const Point<3> &point : points)
    {
      const Tensor<1, 3> exact = c.shape->gradient(point);
      const Tensor<1, 3> numeric = c.shape->Shape::gradient(point);
      EXPECT_LE(exact.norm(), 1. + 1e-6) << c.name;
      if ((exact - numeric).norm() < 1e-4)
        ++n_smooth;
    }
    // All but the few at edges.
    EXPECT_GE(n_smooth, 297u) << c.name;
  }
}


TEST(Shape, StepOfTheExactDistanceLandsOnTheSurface)
{
  for (const Case &c : cases())
    for (const Point<3> &point : samples(*c.shape, 200))
      if (c.is_exact && c.shape->value(point) > 0.)
      {
        const Point<3> foot =
          point - c.shape->value(point) * c.shape->gradient(point);
        EXPECT_NEAR(c.shape->value(foot), 0., 1e-7)
          << c.name << " at " << point;
      }
}


TEST(Shape, ProjectionIsOnTheSurface)
{
  for (const Case &c : cases())
    for (const Point<3> &point : samples(*c.shape, 200))
      if (std::abs(c.shape->value(point)) < 0.03)
      {
        EXPECT_NEAR(c.shape->value(c.shape->project(point)), 0., 1e-8)
          << c.name << " at " << point;
        EXPECT_GE(std::abs(c.shape->distance(point)),
                  std::abs(c.shape->value(point)) - 1e-8)
          << c.name;
      }
}


// In the plane of symmetry between two legs, gradients lead to what is behind.
TEST(Shape, NearestPointIsThatOfTheNearerLegs)
{
  const auto ball = [](const Point<3> &center) {
    return std::make_shared<Ellipsoid>(center, Point<3>(0.1, 0.1, 0.1));
  };
  const Union body(
    {ball({0., 0.3, 0.}), ball({0., -0.3, 0.}), ball({-0.5, 0., 0.})});
  for (const double y : {0., 0.01})
  {
    const Point<3> charge(1., y, 0.);
    EXPECT_NEAR(charge.distance(body.nearest(charge)),
                Point<3>(1., 0.3 - y, 0.).norm() - 0.1,
                1e-6);
  }
}

TEST(Shape, BoundingBoxHoldsTheShape)
{
  for (const Case &c : cases())
  {
    const auto box = c.shape->bounding_box();
    for (const Point<3> &point : samples(*c.shape, 2000))
      if (c.shape->value(point) <= 0.)
      {
        EXPECT_TRUE(box.point_inside(point)) << c.name << " at " << point;
      }
  }
}


TEST(Shape, ReachesAsFarAsItsFarthestPoint)
{
  const Tensor<1, 3> direction({0.48, -0.6, 0.64});
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> unit(-1., 1.);
  for (const Case &c : cases())
  {
    const double reach = c.shape->reach(direction);
    double highest = std::numeric_limits<double>::lowest();
    for (Point<3> top : samples(*c.shape, 100))
    {
      // Climbs within the shape, from several places, as it may have peaks.
      for (double way = 0.1; way > 1e-5; way *= 0.99)
      {
        const Point<3> next =
          top +
          way * Point<3>(unit(generator), unit(generator), unit(generator));
        if (c.shape->value(next) <= 0. &&
            (c.shape->value(top) > 0. || next * direction > top * direction))
          top = next;
      }
      if (c.shape->value(top) <= 0.)
        highest = std::max(highest, top * direction);
    }
    const auto [lower, upper] = c.shape->bounding_box().get_boundary_points();
    EXPECT_GE(reach, highest - 1e-12) << c.name;
    EXPECT_LE(reach, highest + 2e-4 * lower.distance(upper)) << c.name;
  }
}


// Not that of the turned box, which is up to 1.7 times as wide.
TEST(Shape, OwnBoxIsThatOfTheTurnedShape)
{
  const Tensor<1, 3> semi_axes({0.3, 0.2, 0.9});
  const auto ellipsoid =
    std::make_shared<Ellipsoid>(Point<3>(1., 2., 3.), semi_axes);
  const Placement placement(
    1.5, Point<3>(0.4, -0.7, 1.1), Point<3>(0.1, 0.2, 0.3));
  const auto box =
    PlacedShape::in_own_box(ellipsoid, placement)->bounding_box();
  const auto loose = PlacedShape(ellipsoid, placement).bounding_box();
  EXPECT_LT(box.center().distance(placement.apply(Point<3>(1., 2., 3.))),
            1e-12);
  for (unsigned int d = 0; d < 3; ++d)
  {
    double square = 0.;
    for (unsigned int e = 0; e < 3; ++e)
      square += std::pow(
        placement.rotate(Point<3>::unit_vector(e))[d] * semi_axes[e], 2);
    EXPECT_NEAR(box.side_length(d), 3. * std::sqrt(square), 1e-12);
    EXPECT_GT(loose.side_length(d), 1.1 * box.side_length(d));
  }
}


TEST(Shape, KnownDistances)
{
  const Ellipsoid ellipsoid({0., 0., 0.}, Tensor<1, 3>({0.3, 0.2, 0.1}));
  EXPECT_NEAR(ellipsoid.value({0., 0., 0.}), -0.1, 1e-9);
  EXPECT_NEAR(ellipsoid.value({0.5, 0., 0.}), 0.2, 1e-9);
  EXPECT_NEAR(ellipsoid.value({0., 0., -0.05}), -0.05, 1e-9);
  EXPECT_NEAR(ellipsoid.value({0.3, 0., 0.}), 0., 1e-9);

  // A cone of half angle 30 degrees between balls of radius 1 and 0.5.
  const Sweep cone({{Point<3>(0., 0., 0.), 1.}, {Point<3>(1., 0., 0.), 0.5}});
  EXPECT_NEAR(cone.value({-2., 0., 0.}), 1., 1e-12);
  EXPECT_NEAR(cone.value({2., 0., 0.}), 0.5, 1e-12);
  const Tensor<1, 3> side({0.5, std::sqrt(0.75), 0.});
  EXPECT_NEAR(cone.value(Point<3>(1.4 * side)), 0.4, 1e-12);
  EXPECT_NEAR(cone.value(Point<3>(0.5, 0., 0.) + 1.15 * side), 0.4, 1e-12);

  const RoundedBox box({0., 0., 0.}, Tensor<1, 3>({1., 1., 1.}), 0.25);
  EXPECT_NEAR(box.value({0., 0., 0.}), -1., 1e-12);
  EXPECT_NEAR(box.value({2., 2., 0.75}), std::sqrt(2.) * 1.25 - 0.25, 1e-12);

  const Cylinder cylinder({0., 0., 0.}, {0., 0., 2.}, 0.5);
  EXPECT_NEAR(cylinder.value({0.8, 0., 2.4}), 0.5, 1e-12);
  EXPECT_NEAR(cylinder.value({0., 0., 0.1}), -0.1, 1e-12);
}


TEST(Shape, PlacementIsUndone)
{
  const Placement placement(2.5, Point<3>(0.1, -2., 3.), Point<3>(1., 2., 3.));
  EXPECT_FALSE(placement.is_identity());
  EXPECT_TRUE(Placement().is_identity());
  const Point<3> point(0.3, -0.4, 0.7);
  EXPECT_LT(placement.pull_back(placement.apply(point)).distance(point), 1e-14);
  // A quarter turn about z brings x to y.
  const Placement quarter(
    2., Point<3>(0., 0., dealii::numbers::PI_2), Point<3>(0., 0., 1.));
  EXPECT_LT(quarter.apply(Point<3>(1., 0., 0.)).distance({0., 2., 1.}), 1e-15);
}
