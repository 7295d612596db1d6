// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/hex_mesh.h>
#include <contrecoup/geometry/hex_quality.h>
#include <contrecoup/geometry/primitive_shapes.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/tria.h>

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

HexMesh ball_mesh(const double size)
{
  const auto ball = std::make_shared<Sphere>(Point<3>(), 1.);
  const auto core = std::make_shared<Sphere>(Point<3>(), 0.5);
  const ShapeBody body(
    ball,
    {{{"core", Tissue::brain}, core}, {{"shell", Tissue::skeleton}, ball}});
  LabelGrid grid = make_grid(ball->bounding_box(), size);
  body.fill(grid);
  return make_voxel_mesh(grid, body.parts());
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
  // What a lattice counts in a ball is off by less than (h / R)^1.5.
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
