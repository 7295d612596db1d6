// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/triangle_intersections.h>
#include <contrecoup/geometry/shape/triangle_repair.h>
#include <contrecoup/geometry/shape/triangulated_surface.h>

#include "spheres.h"
#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using dealii::Point;

TEST(TriangulatedSurface, DistanceIsThatOfTheTriangles)
{
  const TriangleMesh mesh = make_sphere(24);
  const TriangulatedSurface surface(mesh);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> place(-1.6, 1.6);
  for (unsigned int i = 0; i < 300; ++i)
  {
    const Point<3> p(place(generator), place(generator), place(generator));
    // The polyhedron lies within 1 - cos(pi / 48) of the sphere.
    EXPECT_NEAR(surface.value(p), p.norm() - 1., 0.005) << p;
    EXPECT_NEAR(surface.gradient(p) * p / p.norm(), 1., 0.01) << p;
    EXPECT_NEAR(surface.winding_number(p), p.norm() < 1. ? 1. : 0., 0.03) << p;
    const Point<3> q =
      p + 0.01 * Point<3>(place(generator), place(generator), place(generator));
    EXPECT_LE(std::abs(surface.value(p) - surface.value(q)),
              p.distance(q) + 1e-12);
  }
}


TEST(TriangulatedSurface, OverlappingPiecesAreOneBody)
{
  TriangleMesh mesh = make_sphere(16);
  append(mesh, make_sphere(16, Point<3>(1., 0., 0.)));
  repair(mesh);
  const TriangulatedSurface surface(mesh);
  EXPECT_NEAR(surface.winding_number({0.5, 0., 0.}), 2., 0.03);
  EXPECT_LT(surface.value({0.5, 0.1, 0.}), 0.);
  EXPECT_LT(surface.value({1.9, 0., 0.}), 0.);
  EXPECT_GT(surface.value({0.5, 0.95, 0.}), 0.);
  const auto pairs = find_self_intersections(mesh);
  ASSERT_FALSE(pairs.empty());
  for (const TrianglePair &pair : pairs)
    EXPECT_NEAR(pair.place[0], 0.5, 0.2);
}


TEST(TriangulatedSurface, CleanSurfacesHaveNoIntersections)
{
  EXPECT_TRUE(find_self_intersections(make_sphere(20)).empty());
}


TEST(TriangleRepair, SoupBecomesOneClosedPiece)
{
  const TriangleMesh sphere = make_sphere(16);
  TriangleMesh mesh = to_soup(sphere);
  const RepairReport report = repair(mesh);
  EXPECT_EQ(report.n_pieces, 1u);
  EXPECT_EQ(mesh.vertices.size(), sphere.vertices.size());
  EXPECT_EQ(report.n_holes + report.n_flipped + report.n_open_edges, 0u);
  EXPECT_TRUE(report.lines().empty());
  EXPECT_NEAR(mesh.volume(), sphere.volume(), 1e-12);
}


TEST(TriangleRepair, FlippedAndMissingTrianglesAreMended)
{
  const TriangleMesh sphere = make_sphere(16);
  TriangleMesh mesh = to_soup(sphere);
  std::mt19937 generator(9);
  unsigned int n_flipped = 0;
  for (auto &triangle : mesh.triangles)
    if (generator() % 4 == 0)
    {
      std::swap(triangle[0], triangle[1]);
      ++n_flipped;
    }
  // Two holes: of one triangle, and of two neighbours; and a sliver.
  mesh.triangles.erase(mesh.triangles.begin() + 200);
  mesh.triangles.erase(mesh.triangles.begin() + 300,
                       mesh.triangles.begin() + 302);
  mesh.triangles.push_back({{0, 0, 1}});
  const RepairReport report = repair(mesh);
  EXPECT_NEAR(report.n_flipped, n_flipped, 3.);
  EXPECT_EQ(report.n_holes, 2u);
  EXPECT_EQ(report.n_degenerate, 1u);
  EXPECT_EQ(report.n_open_edges, 0u);
  EXPECT_NEAR(mesh.volume(), sphere.volume(), 1e-2);
  EXPECT_EQ(report.lines().size(), 3u);
}


TEST(TriangleRepair, InsideOutIsTurnedAndCavitiesStay)
{
  TriangleMesh mesh = make_sphere(12);
  for (auto &triangle : mesh.triangles)
    std::swap(triangle[0], triangle[1]);
  EXPECT_EQ(repair(mesh).n_flipped, mesh.triangles.size());
  EXPECT_GT(mesh.volume(), 0.);

  TriangleMesh hollow = make_sphere(12);
  TriangleMesh cavity = make_sphere(12, Point<3>(), 0.5);
  for (auto &triangle : cavity.triangles)
    std::swap(triangle[0], triangle[1]);
  append(hollow, cavity);
  EXPECT_EQ(repair(hollow).n_flipped, 0u);
  const TriangulatedSurface surface(hollow);
  EXPECT_NEAR(surface.value({0., 0., 0.}), 0.5, 0.02);
  EXPECT_NEAR(surface.value({0., 0., 0.75}), -0.25, 0.02);
}
