// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_box.h>

#include <deal.II/base/quadrature_lib.h>

#include "octree/generated_mesh.h"
#include <gtest/gtest.h>

#include <cmath>

namespace contrecoup::gas
{
namespace
{
  template <int dim>
  std::unique_ptr<LeafMesh<dim>>
  curved_mesh(const std::string &generator,
              const std::string &arguments,
              const unsigned int cell_degree,
              const unsigned int refinement,
              const unsigned int times = 0,
              const MPI_Comm communicator = MPI_COMM_WORLD)
  {
    return make_mesh<dim>(
      generator, arguments, refinement, times, true, communicator, cell_degree);
  }

  template <int dim>
  double volume_of_curves(const LeafMesh<dim> &mesh)
  {
    const dealii::QGauss<dim> quadrature(7);
    double sum = 0.;
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    {
      const LeafBox<dim> box = leaf_box(mesh, leaf);
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        sum += quadrature.weight(q) * box.jacobian(quadrature.point(q));
    }
    return dealii::Utilities::MPI::sum(sum, mesh.communicator());
  }

  /// Volume of a polygon or polyhedron of leaves relative to the smooth body,
  /// after one and two refinements.
  template <int dim>
  std::array<double, 2> volume_errors(const unsigned int cell_degree)
  {
    const std::string center = dim == 2 ? "0,0" : "0,0,0";
    const double exact = dim == 2 ? M_PI : 4. / 3. * M_PI;
    std::array<double, 2> errors;
    for (unsigned int i = 0; i < 2; ++i)
      errors[i] =
        std::abs(volume_of_curves(*curved_mesh<dim>(
                   "hyper_ball", center + ":1:false", cell_degree, 1 + i)) /
                   exact -
                 1.);
    return errors;
  }

  /// Coordinates on a coarse face of a place of the fine face of a quarter.
  struct OnFace
  {
    double a;
    double b;
  };

  /// Checks at points of all hanging faces that the fine faces make up the
  /// coarse one; returns how many fine faces there are.
  template <int dim>
  unsigned int expect_quarters_meet(const LeafMesh<dim> &mesh)
  {
    const unsigned int m = 3; // points from end to end of an edge
    unsigned int n = 0;
    for (const auto &face : mesh.hanging_faces())
      if (face.coarse_leaf < mesh.n_owned())
        for (unsigned int part = 0; part < face.n_fine; ++part, ++n)
          for (unsigned int point = 0; point < std::pow(m, dim - 1); ++point)
          {
            const unsigned int i = point % m, j = point / m;
            const OnFace coarse = {0.5 * (part % 2 + i / (m - 1.)),
                                   0.5 * (part / 2 + j / (m - 1.))};
            const unsigned int own =
              matched_face_point(face.match.orientation, i, j, m);
            const OnFace fine = {own % m / (m - 1.), own / m / (m - 1.)};
            const auto area = outward_area(
              mesh, face.coarse_leaf, face.coarse_face, coarse.a, coarse.b);
            const auto finer = outward_area(
              mesh, face.fine_leaf[part], face.match.face, fine.a, fine.b);
            EXPECT_LT((area + finer * double(face.n_fine)).norm(),
                      1e-12 * area.norm());
          }
    return dealii::Utilities::MPI::sum(n, mesh.communicator());
  }

  /// Places inside owned leaves by the names of their cells.
  template <int dim>
  std::map<std::string, dealii::Point<dim>> places(const LeafMesh<dim> &mesh)
  {
    dealii::Point<dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = 0.1 + 0.3 * d;
    std::map<std::string, dealii::Point<dim>> result;
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
      result[mesh.cell(leaf)->id().to_string()] = leaf_box(mesh, leaf).place(x);
    return result;
  }
} // namespace

// Nodes on the wall: an edge of degree k encloses the area to order k + 1 at
// least, of even degree to k + 2.
TEST(CurvedShapes, BallConvergesFasterWithTheDegree)
{
  const std::array<double, 5> orders = {{0., 2., 4., 4., 6.}};
  for (const unsigned int degree : {1U, 2U, 3U, 4U})
  {
    const auto errors = volume_errors<2>(degree);
    EXPECT_GT(std::log2(errors[0] / errors[1]), orders[degree] - 0.2) << degree;
  }
  for (const unsigned int degree : {2U, 3U})
  {
    const auto errors = volume_errors<3>(degree);
    EXPECT_GT(std::log2(errors[0] / errors[1]), orders[degree] - 0.4) << degree;
  }
  EXPECT_LT(volume_errors<3>(3)[1], 1e-4);
}

TEST(CurvedShapes, HangingFacesHaveNoGaps)
{
  for (const unsigned int degree : {2U, 3U, 4U})
  {
    const auto ring =
      curved_mesh<2>("hyper_shell", "0,0:1:2:7:false", degree, 1, 2);
    EXPECT_GT(expect_quarters_meet(*ring), 0U);
    const auto shell =
      curved_mesh<3>("hyper_shell", "0,0,0:1:2:6:false", degree, 0, 3);
    EXPECT_GT(expect_quarters_meet(*shell), 0U);
    const auto ball =
      curved_mesh<3>("hyper_ball", "0,0,0:1:false", degree, 0, 2);
    EXPECT_GT(expect_quarters_meet(*ball), 0U);
  }
}

TEST(CurvedShapes, AreAlikeOnAnyNumberOfRanks)
{
  const auto alone = places(*curved_mesh<3>(
    "hyper_shell", "0,0,0:1:2:6:false", 3, 0, 3, MPI_COMM_SELF));
  for (const auto &[name, place] :
       places(*curved_mesh<3>("hyper_shell", "0,0,0:1:2:6:false", 3, 0, 3)))
    EXPECT_LT(place.distance(alone.at(name)), 1e-14) << name;
}

TEST(CurvedShapes, PlacesAndReferencePlacesAgree)
{
  const auto mesh = curved_mesh<3>("hyper_ball", "0,0,0:1:false", 3, 0, 1);
  const auto &shapes = *mesh->curved_shapes();
  const dealii::Point<3> x(0.2, 0.7, 0.4);
  for (unsigned int leaf = 0; leaf < mesh->n_owned(); ++leaf)
  {
    const auto place = leaf_box(*mesh, leaf).place(x);
    EXPECT_LT(place.distance(shapes.mapping().transform_unit_to_real_cell(
                mesh->cell(leaf), x)),
              1e-14);
    EXPECT_LT(x.distance(shapes.mapping().transform_real_to_unit_cell(
                mesh->cell(leaf), place)),
              1e-10);
  }
}

TEST(CurvedShapes, OnlyMeshesWithManifoldsAreCurved)
{
  EXPECT_NE(curved_mesh<2>("hyper_ball", "0,0:1:true", 2, 0)->curved_shapes(),
            nullptr);
  EXPECT_EQ(curved_mesh<2>("hyper_ball", "0,0:1:true", 1, 0)->curved_shapes(),
            nullptr);
  EXPECT_EQ(curved_mesh<2>("hyper_cube", "0:1:false", 2, 0)->curved_shapes(),
            nullptr);
}

// The sphere's manifold bends cells near the centre until they are inverted.
TEST(CurvedShapes, InvertedCellsAreRefused)
{
  const auto mesh = curved_mesh<3>("hyper_ball", "0,0,0:1:true", 3, 2);
  EXPECT_THROW(
    {
      mesh->curved_shapes()->check("Domain/Initial refinement");
      throw InputError("no leaf of this rank is inverted");
    },
    InputError);
  const auto good = curved_mesh<3>("hyper_ball", "0,0,0:1:false", 3, 2);
  EXPECT_NO_THROW(good->curved_shapes()->check("Domain/Initial refinement"));
}
} // namespace contrecoup::gas
