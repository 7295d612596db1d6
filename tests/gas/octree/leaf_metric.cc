// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/octree/leaf_metric.h>

#include "octree/generated_mesh.h"
#include <gtest/gtest.h>

#include <cmath>

namespace contrecoup::gas
{
namespace
{
  /// Largest sum of outward areas of a subcell over its surface.
  template <int dim>
  double largest_gap(const LeafMesh<dim> &mesh, const unsigned int n)
  {
    const LeafLayout layout(dim, n, 1);
    LeafMetric<dim> metric(n);
    double largest = 0.;
    for (unsigned int batch = 0; batch < mesh.n_batches(); ++batch)
    {
      metric.reinit(mesh, batch);
      std::vector<typename LeafMetric<dim>::Vector> sums(layout.n_points);
      std::vector<Lanes<double>> surface(layout.n_points, Lanes<double>(0.));
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int line = 0; line < layout.n_face_points; ++line)
          for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int q = layout.face_point(2 * d, line, i);
            const auto &low = metric.area(d, i, line);
            const auto &high = metric.area(d, i + 1, line);
            sums[q] += high - low;
            surface[q] += std::sqrt(low * low) + std::sqrt(high * high);
          }
      for (unsigned int q = 0; q < layout.n_points; ++q)
        for (unsigned int lane = 0; lane < double_width; ++lane)
          for (unsigned int d = 0; d < dim; ++d)
            largest =
              std::max(largest, std::abs(sums[q][d][lane]) / surface[q][lane]);
    }
    return largest;
  }

  /// Checks that the fine faces of each hanging face of an owned leaf make up
  /// the coarse one, quarter by quarter; returns how many there are.
  template <int dim>
  unsigned int expect_no_gaps(const LeafMesh<dim> &mesh)
  {
    unsigned int n = 0;
    for (const auto &face : mesh.hanging_faces())
      if (face.coarse_leaf < mesh.n_owned())
        for (unsigned int part = 0; part < face.n_fine; ++part, ++n)
        {
          const auto coarse = outward_area<dim>(mesh.cell(face.coarse_leaf),
                                                face.coarse_face,
                                                0.25 + 0.5 * (part % 2),
                                                0.25 + 0.5 * (part / 2));
          const auto fine = outward_area<dim>(
            mesh.stored_cell(face.fine_leaf[part]), face.match.face, 0.5, 0.5);
          EXPECT_LT((coarse + fine * double(face.n_fine)).norm(),
                    1e-14 * coarse.norm());
        }
    return dealii::Utilities::MPI::sum(n, mesh.communicator());
  }

  /// Vertices of owned and ghost leaves by the names of their cells.
  template <int dim>
  std::map<std::string, std::vector<dealii::Point<dim>>>
  vertices_of(const LeafMesh<dim> &mesh)
  {
    std::map<std::string, std::vector<dealii::Point<dim>>> result;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
          result[cell->id().to_string()].push_back(cell->vertex(v));
    return result;
  }

  /// Checks that all vertices of a mesh are where another one, which has all
  /// leaves, has them.
  template <int dim>
  void expect_vertices(const LeafMesh<dim> &mesh, const LeafMesh<dim> &whole)
  {
    const auto expected = vertices_of(whole);
    for (const auto &[name, places] : vertices_of(mesh))
    {
      ASSERT_TRUE(expected.count(name)) << name;
      for (unsigned int v = 0; v < places.size(); ++v)
        EXPECT_LT(places[v].distance(expected.at(name)[v]), 1e-14) << name;
    }
  }

  template <int dim>
  double total_volume(const LeafMesh<dim> &mesh, const unsigned int n)
  {
    LeafMetric<dim> metric(n);
    double sum = 0.;
    for (unsigned int batch = 0; batch < mesh.n_batches(); ++batch)
    {
      metric.reinit(mesh, batch);
      for (unsigned int q = 0; q < LeafLayout(dim, n, 1).n_points; ++q)
        for (unsigned int lane = 0; lane < mesh.n_filled_lanes(batch); ++lane)
          sum += metric.volume(q)[lane];
    }
    return dealii::Utilities::MPI::sum(sum, mesh.communicator());
  }

  /// The volumes against the quadrature of the map's Jacobian.
  template <int dim>
  void expect_quadrature(const LeafMesh<dim> &mesh, const unsigned int n)
  {
    Scheme scheme;
    scheme.n_points = n;
    const LeafPoints<dim> points(scheme, Geometry::plane);
    LeafMetric<dim> metric(n);
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    {
      metric.reinit(mesh, leaf / double_width);
      for (unsigned int q = 0; q < LeafLayout(dim, n, 1).n_points; ++q)
      {
        const double exact = point_volume(leaf_box(mesh, leaf), points, q);
        EXPECT_GT(exact, 0.);
        EXPECT_NEAR(metric.volume(q)[leaf % double_width] / exact, 1., 1e-13);
      }
    }
  }
} // namespace

TEST(LeafMetric, SurfacesAreClosed)
{
  EXPECT_LT(largest_gap(*make_mesh<2>("hyper_ball", "0,0:1:true", 2), 5),
            1e-14);
  EXPECT_LT(largest_gap(*make_mesh<3>("hyper_ball", "0,0,0:1:true", 1), 4),
            1e-14);
  EXPECT_LT(
    largest_gap(*make_mesh<3>("hyper_shell", "0,0,0:1:2:6:false", 1), 4),
    1e-14);
}

// The manifold of a sphere bends edges that hang; see HangingVertices.
TEST(LeafMetric, HangingFacesHaveNoGaps)
{
  const auto shell = make_mesh<2>("hyper_shell", "0,0:1:2:7:false", 1, 2);
  EXPECT_GT(expect_no_gaps(*shell), 0U);
  const auto thick = make_mesh<3>("hyper_shell", "0,0,0:1:2:6:false", 0, 3);
  EXPECT_GT(expect_no_gaps(*thick), 0U);
  const auto ball = make_mesh<3>("hyper_ball", "0,0,0:1:false", 0, 2);
  EXPECT_GT(expect_no_gaps(*ball), 0U);
}

TEST(LeafMetric, HangingVerticesDependOnTheLeavesAlone)
{
  const auto make = [](const bool rebuilds_always, const MPI_Comm comm) {
    return make_mesh<3>(
      "hyper_shell", "0,0,0:1:2:6:false", 0, 4, rebuilds_always, comm);
  };
  const auto whole = make(false, MPI_COMM_SELF);
  expect_vertices(*make(true, MPI_COMM_SELF), *whole);
  expect_vertices(*make(true, MPI_COMM_WORLD), *whole);
}

TEST(LeafMetric, VolumesAreThoseOfTheMap)
{
  expect_quadrature(*make_mesh<2>("hyper_shell", "3,4:1:2:7:false", 1), 3);
  expect_quadrature(*make_mesh<3>("hyper_ball", "5,6,7:2:true", 1), 2);
}

TEST(LeafMetric, BallConverges)
{
  const double disk = M_PI, ball = 4. / 3. * M_PI;
  double disk_error[2], ball_error[2];
  for (unsigned int i = 0; i < 2; ++i)
  {
    disk_error[i] =
      disk - total_volume(*make_mesh<2>("hyper_ball", "0,0:1:true", 3 + i), 2);
    ball_error[i] =
      ball -
      total_volume(*make_mesh<3>("hyper_ball", "0,0,0:1:true", 1 + i), 2);
  }
  EXPECT_NEAR(disk_error[0] / disk_error[1], 4., 0.1);
  EXPECT_NEAR(ball_error[0] / ball_error[1], 4., 0.5);
  // Refined four times, the disk is a polygon of 64 sides.
  EXPECT_NEAR(disk - disk_error[1], 32. * std::sin(2. * M_PI / 64.), 1e-13);
}

TEST(LeafMetric, BoxesKeepTheirEdges)
{
  const auto mesh =
    make_mesh<3>("subdivided_hyper_rectangle", "2,1,1:0,0,0:2,3,4:false", 0);
  if (mesh->n_owned() == 0) // on a third rank
    return;
  LeafMetric<3> metric(2);
  metric.reinit(*mesh, 0);
  EXPECT_DOUBLE_EQ(metric.volume(5)[0], 0.5 * 1.5 * 2.);
  EXPECT_DOUBLE_EQ(metric.area(0, 1, 2)[0][0], 3.);
  EXPECT_EQ(metric.area(0, 1, 2)[1][0], 0.);
  EXPECT_DOUBLE_EQ(metric.area(1, 0, 1)[1][0], 1.);
  EXPECT_DOUBLE_EQ(metric.area(2, 2, 3)[2][0], 0.75);
  EXPECT_DOUBLE_EQ(metric.face_center(1, 0, 2)[2][0], 3.);
  EXPECT_DOUBLE_EQ(metric.tangent(0, 0, 0, 2)[2][0], 1.);
}
} // namespace contrecoup::gas
