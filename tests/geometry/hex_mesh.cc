// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/mesh/hex_mesh.h>
#include <contrecoup/geometry/mesh/hex_quality.h>
#include <contrecoup/geometry/mesh/mesh_smoothing.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using dealii::Point;
using dealii::Tensor;

namespace
{
const HexCorners unit_cube{{{0., 0., 0.},
                            {1., 0., 0.},
                            {1., 1., 0.},
                            {0., 1., 0.},
                            {0., 0., 1.},
                            {1., 0., 1.},
                            {1., 1., 1.},
                            {0., 1., 1.}}};

/// Volume by Gauss quadrature of deal.II, exact for trilinear hexahedra.
double quadrature_volume(const HexCorners &corners)
{
  dealii::Triangulation<3> mesh;
  dealii::CellData<3> cell(8);
  const std::array<unsigned int, 8> order{{0, 1, 3, 2, 4, 5, 7, 6}};
  for (unsigned int v = 0; v < 8; ++v)
    cell.vertices[v] = order[v];
  mesh.create_triangulation({corners.begin(), corners.end()}, {cell}, {});
  return mesh.begin_active()->measure();
}

HexMesh ball_mesh(const double size, const unsigned int levels = 0)
{
  const auto ball = std::make_shared<Sphere>(Point<3>(), 1.);
  const auto core = std::make_shared<Sphere>(Point<3>(), 0.5);
  const ShapeBody body(
    ball,
    {{{"core", Tissue::brain}, core}, {{"shell", Tissue::skeleton}, ball}});
  LabelGrid grid = make_grid(ball->bounding_box(), size);
  body.fill(grid);
  return make_hex_mesh(grid, body.parts(), levels);
}
} // namespace


TEST(HexQuality, VolumeIsThatOfTheTrilinearCell)
{
  EXPECT_NEAR(volume(unit_cube), 1., 1e-14);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> shift(-0.25, 0.25);
  for (unsigned int sample = 0; sample < 20; ++sample)
  {
    HexCorners corners = unit_cube;
    for (Point<3> &corner : corners)
      corner += Tensor<1, 3>(
        Point<3>(5. + shift(generator), shift(generator), shift(generator)));
    EXPECT_NEAR(volume(corners), quadrature_volume(corners), 1e-13);
  }
}


TEST(HexQuality, ScaledJacobianOfKnownCells)
{
  EXPECT_NEAR(scaled_jacobian(unit_cube), 1., 1e-14);
  HexCorners brick = unit_cube;
  for (Point<3> &corner : brick)
    corner[1] *= 100.;
  EXPECT_NEAR(scaled_jacobian(brick), 1., 1e-14);
  // Sheared by 60 degrees: the sine of the angle that is left.
  HexCorners sheared = unit_cube;
  for (Point<3> &corner : sheared)
    corner[0] += std::tan(M_PI / 3.) * corner[2];
  EXPECT_NEAR(scaled_jacobian(sheared), 0.5, 1e-14);
  // One corner pushed through the opposite one folds it.
  HexCorners folded = unit_cube;
  folded[6] = Point<3>(-0.5, -0.5, -0.5);
  EXPECT_LT(scaled_jacobian(folded), 0.);
}


TEST(HexQuality, CharacteristicLengthOfABrickIsItsThickness)
{
  HexCorners brick = unit_cube;
  for (Point<3> &corner : brick)
    corner = Point<3>(3. * corner[0], 0.2 * corner[1], 2. * corner[2]);
  EXPECT_NEAR(characteristic_length(brick), 0.2, 1e-14);
}


TEST(HexMesh, CellsAndFacetsOfABall)
{
  const HexMesh mesh = ball_mesh(0.1);
  const auto quality = measure_quality(mesh);
  ASSERT_EQ(quality.size(), 2u);
  const HexQuality all = quality[0] + quality[1];
  EXPECT_EQ(all.n_cells, mesh.cells.size());
  EXPECT_NEAR(all.volume, 1e-3 * mesh.cells.size(), 1e-9);
  // The lattice count of a ball's volume is off by less than (h / R)^1.5.
  EXPECT_NEAR(all.volume / (4. / 3. * M_PI), 1., 0.031);
  EXPECT_NEAR(quality[0].volume / (M_PI / 6.), 1., 0.089);
  EXPECT_NEAR(all.shortest_edge, 0.1, 1e-12);
  EXPECT_NEAR(all.longest_edge, 0.1, 1e-12);
  EXPECT_NEAR(all.first_moment.norm(), 0., 1e-12);

  // Facets look outwards and close the surface.
  Tensor<1, 3> sum;
  double flux = 0.;
  for (const HexMesh::Facet &facet : mesh.boundary)
  {
    const Tensor<1, 3> area = mesh.area_vector(facet);
    EXPECT_NEAR(area.norm(), 0.01, 1e-12);
    sum += area;
    flux += area * mesh.center(facet) / 3.;
    EXPECT_EQ(mesh.part[facet.cell], 1);
  }
  EXPECT_NEAR(sum.norm(), 0., 1e-12);
  EXPECT_NEAR(flux, all.volume, 1e-10);

  // No two nodes at one place.
  std::vector<Point<3>> nodes = mesh.nodes;
  const auto before = [](const Point<3> &a, const Point<3> &b) {
    return std::array<double, 3>{{a[0], a[1], a[2]}} <
           std::array<double, 3>{{b[0], b[1], b[2]}};
  };
  std::sort(nodes.begin(), nodes.end(), before);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    EXPECT_NE(nodes[i], nodes[i + 1]);
}


namespace
{
std::set<std::uint32_t> hanging_numbers(const HexMesh &mesh)
{
  std::set<std::uint32_t> numbers;
  for (const auto &hanging : mesh.hanging_nodes)
    numbers.insert(hanging.node);
  return numbers;
}

/// Expects each hanging node to be where its masters say.
void expect_hanging_nodes_in_place(const HexMesh &mesh)
{
  const auto numbers = hanging_numbers(mesh);
  EXPECT_EQ(numbers.size(), mesh.hanging_nodes.size());
  for (const auto &hanging : mesh.hanging_nodes)
  {
    Tensor<1, 3> place;
    double sum = 0.;
    for (std::size_t m = 0; m < hanging.masters.size(); ++m)
    {
      EXPECT_EQ(numbers.count(hanging.masters[m]), 0u);
      place += hanging.weights[m] * mesh.nodes[hanging.masters[m]];
      sum += hanging.weights[m];
    }
    EXPECT_NEAR(sum, 1., 1e-14);
    EXPECT_LT(mesh.nodes[hanging.node].distance(Point<3>(place)), 1e-12);
  }
}

HexQuality all_quality(const HexMesh &mesh)
{
  HexQuality all;
  for (const HexQuality &part : measure_quality(mesh))
    all = all + part;
  return all;
}
} // namespace


TEST(HexMesh, MergedCubesFillTheSameBody)
{
  const HexMesh fine = ball_mesh(0.06);
  const HexMesh merged = ball_mesh(0.06, 3);
  EXPECT_LT(merged.cells.size(), 0.75 * fine.cells.size());
  EXPECT_GT(merged.hanging_nodes.size(), 100u);
  EXPECT_EQ(merged.boundary.size(), fine.boundary.size());
  EXPECT_EQ(merged.interfaces.size(), fine.interfaces.size());
  const auto before = measure_quality(fine);
  const auto after = measure_quality(merged);
  for (unsigned int part = 0; part < 2; ++part)
    EXPECT_NEAR(after[part].volume, before[part].volume, 1e-10);
  EXPECT_GT(all_quality(merged).longest_edge, 0.119);
  expect_hanging_nodes_in_place(merged);
}


// The mesh is graded 2:1 and conforming but for its hanging nodes: a node in
// the closure of a cell is its corner, or hangs in the middle of an edge or
// face.
TEST(HexMesh, NodesInSidesOfLargeCubesHang)
{
  const HexMesh mesh = ball_mesh(0.08, 3);
  const auto hanging = hanging_numbers(mesh);
  unsigned int n_found = 0;
  for (const HexMesh::Cell &cell : mesh.cells)
  {
    const Point<3> &low = mesh.nodes[cell[0]];
    const double width = mesh.nodes[cell[6]][0] - low[0];
    if (width < 0.1)
      continue;
    for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node)
    {
      const Tensor<1, 3> place = (mesh.nodes[node] - low) / (0.5 * width);
      bool is_within = true;
      bool is_corner = true;
      for (unsigned int d = 0; d < 3; ++d)
      {
        is_within &= place[d] > -1e-9 && place[d] < 2. + 1e-9;
        is_corner &= std::abs(place[d] - 1.) > 1. - 1e-9;
        if (!is_within)
          break;
      }
      if (!is_within || is_corner)
        continue;
      ++n_found;
      EXPECT_EQ(hanging.count(node), 1u);
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(place[d], std::round(place[d]), 1e-9) << "not 2:1";
    }
  }
  EXPECT_GT(n_found, 100u);
}


TEST(MeshSmoothing, MakesBallsOfStairs)
{
  for (const unsigned int levels : {0u, 2u})
  {
    HexMesh mesh = ball_mesh(0.08, levels);
    const double volume = all_quality(mesh).volume;
    // Root mean square distance of the surface from the ball.
    const auto roughness = [&]() {
      double sum = 0.;
      for (const HexMesh::Facet &facet : mesh.boundary)
        sum += std::pow(mesh.center(facet).norm() - 1., 2);
      return std::sqrt(sum / mesh.boundary.size());
    };
    const double before = roughness();
    const SmoothingReport report = smooth(mesh, {20, 0.2});
    EXPECT_LT(roughness(), 0.5 * before);
    const HexQuality quality = all_quality(mesh);
    EXPECT_GE(quality.smallest_scaled_jacobian, 0.2);
    EXPECT_NEAR(quality.volume / volume, 1., 0.01);
    EXPECT_GT(report.n_moved, 1000u);
    EXPECT_GT(report.largest_displacement, 0.01);
    EXPECT_LT(report.largest_displacement, 0.08);
    expect_hanging_nodes_in_place(mesh);
  }
}


TEST(MeshSmoothing, KeepsTheScaledJacobianAskedFor)
{
  for (const double smallest : {0.05, 0.5, 0.8})
  {
    HexMesh mesh = ball_mesh(0.15, 1);
    const SmoothingReport report = smooth(mesh, {20, smallest});
    EXPECT_GE(all_quality(mesh).smallest_scaled_jacobian, smallest);
    if (smallest > 0.3)
    {
      EXPECT_GT(report.n_held_back, 0u) << smallest;
    }
  }
}
