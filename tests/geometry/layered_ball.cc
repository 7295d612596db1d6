// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/layered_ball.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/tria_accessor.h>

#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
/// Volume of an ellipsoid.
double volume(const std::array<double, 3> &axes)
{
  return 4. / 3. * dealii::numbers::PI * axes[0] * axes[1] * axes[2];
}

LayeredBall head(const unsigned int n)
{
  LayeredBall ball;
  ball.semi_axes = {{{0.084, 0.068, 0.060}},
                    {{0.0865, 0.0705, 0.0625}},
                    {{0.093, 0.077, 0.069}}};
  ball.cells_across = {n, 2, 3};
  ball.cells_along_cube = 2 * n;
  return ball;
}

struct Found
{
  std::vector<double> volumes = std::vector<double>(3, 0.);
  double least_jacobian = 1.; ///< over the volume of the cell
};

/// The least determinant of the edges at a corner.
double least_jacobian(const dealii::CellAccessor<3> &cell)
{
  double least = std::numeric_limits<double>::max();
  for (const unsigned int v : cell.vertex_indices())
  {
    // Along the axes of the cell, whichever side the corner is at.
    const auto edge = [&](const unsigned int d) {
      const unsigned int bit = 1U << d;
      return cell.vertex(v | bit) - cell.vertex(v & ~bit);
    };
    least =
      std::min(least, edge(0) * dealii::cross_product_3d(edge(1), edge(2)));
  }
  return least;
}

Found look(const dealii::Triangulation<3> &mesh)
{
  Found result;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    result.volumes[cell->material_id()] += cell->measure();
    result.least_jacobian =
      std::min(result.least_jacobian, least_jacobian(*cell) / cell->measure());
  }
  return result;
}
} // namespace

TEST(LayeredBall, fills_its_ellipsoids_with_good_cells)
{
  const LayeredBall coarse_head = head(4), fine_head = head(8);
  dealii::Triangulation<3> coarse, fine;
  make_layered_ball(coarse_head, coarse);
  make_layered_ball(fine_head, fine);
  EXPECT_EQ(coarse.n_active_cells(), 8U * 8U * 8U + 6U * 8U * 8U * (4U + 5U));
  const Found found = look(coarse), finer = look(fine);
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double exact = volume(fine_head.semi_axes[i]) -
                         (i == 0 ? 0. : volume(fine_head.semi_axes[i - 1]));
    EXPECT_NEAR(finer.volumes[i], exact, 8e-3 * exact) << i;
    // The error is of second order.
    EXPECT_NEAR(
      (exact - found.volumes[i]) / (exact - finer.volumes[i]), 4., 0.4)
      << i;
  }
  EXPECT_GT(found.least_jacobian, 0.3);
  EXPECT_GT(finer.least_jacobian, 0.3);
}

TEST(LayeredBall, is_halved_at_planes_of_symmetry)
{
  LayeredBall ball = head(4);
  dealii::Triangulation<3> whole, quarter;
  make_layered_ball(ball, whole);
  ball.is_halved = {{false, true, true}};
  make_layered_ball(ball, quarter);
  EXPECT_EQ(4 * quarter.n_active_cells(), whole.n_active_cells());
  const Found all = look(whole), part = look(quarter);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(4. * part.volumes[i], all.volumes[i], 1e-14);
  unsigned int count[4] = {0, 0, 0, 0};
  for (const auto &face : quarter.active_face_iterators())
    if (face->at_boundary())
      ++count[face->boundary_id()];
  EXPECT_EQ(count[0], 6U * 8U * 8U / 4U);
  EXPECT_EQ(count[1], 0U);
  EXPECT_EQ(count[2], count[3]);
  EXPECT_EQ(count[2], 4U * 8U + (4U + 4U + 8U) * 9U);
}

TEST(LayeredBall, makes_a_wedge_about_any_axis)
{
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    LayeredBall ball = head(4);
    for (auto &axes : ball.semi_axes)
      axes[(axis + 1) % 3] = axes[(axis + 2) % 3] = 0.9 * axes[axis];
    ball.semi_axes[1][axis] = 1.05 * ball.semi_axes[0][axis];
    ball.semi_axes[2][axis] = 1.1 * ball.semi_axes[0][axis];
    ball.is_halved.fill(true);
    ball.is_halved[axis] = false;
    dealii::Triangulation<3> quarter, mesh;
    make_layered_ball(ball, quarter);
    ball.wedge_axis = axis;
    ball.wedge_slope = 0.1;
    make_layered_ball(ball, mesh);
    EXPECT_EQ(mesh.n_active_cells(), 4U * 8U + 2U * 8U * (4U + 5U));
    // Sections turn about the axis by 0.1 to either side, which are thinner
    // there than the quarter's cells with straight edges.
    const Found found = look(mesh), whole = look(quarter);
    for (unsigned int i = 0; i < 3; ++i)
      EXPECT_NEAR(found.volumes[i] / (2. * 0.1),
                  whole.volumes[i] / (0.5 * dealii::numbers::PI),
                  0.02 * whole.volumes[i])
        << i;
    EXPECT_GT(found.least_jacobian, 0.);
    unsigned int count[4] = {0, 0, 0, 0};
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        ++count[face->boundary_id()];
    EXPECT_EQ(count[0], 16U);
    EXPECT_EQ(count[axis + 1], 0U);
    EXPECT_EQ(count[ball.across_middle() + 1], 8U + 2U * (4U + 5U));
    EXPECT_EQ(count[ball.normal_to_middle() + 1], 2U * mesh.n_active_cells());
    // From side to side.
    for (const auto &cell : mesh.active_cell_iterators())
      for (unsigned int v = 0; v < 8; ++v)
      {
        const auto &vertex = cell->vertex(v);
        EXPECT_NEAR(vertex[ball.normal_to_middle()],
                    (v & 2U ? 0.1 : -0.1) * vertex[ball.across_middle()],
                    1e-15);
      }
  }
}

TEST(LayeredBall, refuses_a_wedge_that_is_not_round)
{
  dealii::Triangulation<3> mesh;
  LayeredBall ball = head(4);
  ball.is_halved = {{true, true, false}};
  ball.wedge_axis = 2;
  ball.wedge_slope = 0.1;
  EXPECT_THROW(make_layered_ball(ball, mesh), InputError);
  for (auto &axes : ball.semi_axes)
    axes[1] = axes[0];
  EXPECT_NO_THROW(make_layered_ball(ball, mesh));
  mesh.clear();
  ball.is_halved[1] = false;
  EXPECT_THROW(make_layered_ball(ball, mesh), InputError);
}

TEST(LayeredBall, refuses_layers_without_thickness)
{
  dealii::Triangulation<3> mesh;
  LayeredBall ball = head(4);
  ball.semi_axes[1] = ball.semi_axes[0];
  EXPECT_THROW(make_layered_ball(ball, mesh), InputError);
  ball = head(4);
  ball.cells_across[2] = 0;
  EXPECT_THROW(make_layered_ball(ball, mesh), InputError);
  ball = head(4);
  ball.cells_along_cube = 3;
  EXPECT_THROW(make_layered_ball(ball, mesh), InputError);
}
