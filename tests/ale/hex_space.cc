// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/hex_space.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace contrecoup;
using ale::HexSpace;

namespace
{
dealii::Triangulation<3> &bricks(dealii::Triangulation<3> &mesh)
{
  dealii::GridGenerator::subdivided_hyper_rectangle(
    mesh, {5, 3, 4}, dealii::Point<3>(), dealii::Point<3>(5., 3., 4.), true);
  return mesh;
}

double volume(const HexSpace &space,
              const dealii::AlignedVector<double> &x,
              const std::size_t cell)
{
  HexVectors<double> corners;
  for (unsigned int i = 0; i < 8; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      corners[i][d] = x[4 * space.cell(cell)[i] + d];
  return hex_moments(corners).volume;
}
} // namespace

TEST(HexSpace, has_every_cell_once_with_its_corners)
{
  dealii::Triangulation<3> mesh;
  HexSpace space;
  space.reinit(bricks(mesh), MPI_COMM_WORLD);
  const auto x = space.positions(4);
  double sum = 0.;
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
    sum += volume(space, x, c);
  EXPECT_NEAR(dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD), 60., 1e-12);
  EXPECT_EQ(
    dealii::Utilities::MPI::sum(space.n_locally_owned_cells(), MPI_COMM_WORLD),
    60U);
  EXPECT_EQ(
    dealii::Utilities::MPI::sum(space.n_locally_owned_nodes(), MPI_COMM_WORLD),
    6U * 4U * 5U);
  for (std::size_t c = 0; c < space.n_cells(); ++c)
  {
    EXPECT_NEAR(volume(space, x, c), 1., 1e-14);
    for (unsigned int i = 0; i < 8; ++i)
    {
      const unsigned int node = space.cell(c)[i];
      const auto &vertex = mesh.get_vertices()[space.node_number(node)];
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_EQ(vertex[d], x[4 * node + d]);
    }
  }
}

TEST(HexSpace, faces_close_every_own_cell)
{
  dealii::Triangulation<3> mesh;
  HexSpace space;
  space.reinit(bricks(mesh), MPI_COMM_WORLD);
  const auto x = space.positions(4);
  std::vector<unsigned int> count(space.n_cells(), 0);
  std::vector<std::array<double, 3>> sum(space.n_cells(), {{0., 0., 0.}});
  for (const auto &face : space.faces())
  {
    std::array<Vector3<double>, 4> corners;
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        corners[i][d] = x[4 * face.nodes[i] + d];
    Vector3<double> a, b;
    for (unsigned int d = 0; d < 3; ++d)
    {
      a[d] = corners[2][d] - corners[0][d];
      b[d] = corners[3][d] - corners[1][d];
    }
    const auto area = cross(a, b);
    const auto add = [&](const std::uint32_t cell, const double sign) {
      ++count[cell];
      for (unsigned int d = 0; d < 3; ++d)
        sum[cell][d] += 0.5 * sign * area[d];
    };
    add(face.inside, 1.);
    if (face.outside != HexSpace::no_cell)
      add(face.outside, -1.);
    else
    {
      // deal.II's numbers of the sides of a box.
      const unsigned int d = face.boundary / 2;
      EXPECT_NEAR(0.5 * area[d], face.boundary % 2 ? 1. : -1., 1e-14);
    }
  }
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
  {
    EXPECT_EQ(count[c], 6U);
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(sum[c][d], 0., 1e-14);
  }
}

TEST(HexSpace, knows_all_cells_around_nodes_of_own_cells)
{
  dealii::Triangulation<3> mesh;
  HexSpace space;
  space.reinit(bricks(mesh), MPI_COMM_WORLD);
  std::map<unsigned int, std::set<unsigned int>> expected;
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      expected[cell->vertex_index(v)].insert(cell->index());
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
    for (const unsigned int node : space.cell(c))
    {
      std::set<unsigned int> found;
      for (const unsigned int cell : space.cells_around(node))
        found.insert(space.cell_number(cell));
      EXPECT_EQ(found, expected[space.node_number(node)]);
    }
}

TEST(HexSpace, exchanges_fields_of_nodes)
{
  dealii::Triangulation<3> mesh;
  HexSpace space;
  space.reinit(bricks(mesh), MPI_COMM_WORLD);
  ale::FieldExchange exchange;
  exchange.reinit(space.nodes(), 4);
  ASSERT_EQ(exchange.size(), 4 * space.n_nodes());
  dealii::AlignedVector<double> count(exchange.size());
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
    for (const unsigned int node : space.cell(c))
      count[4 * node + 2] += 1.;
  exchange.compress_add(count);
  exchange.update_ghost_values(count);
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
    for (const unsigned int node : space.cell(c))
      EXPECT_EQ(count[4 * node + 2], space.cells_around(node).size());
}

TEST(HexSpace, refuses_inverted_cells)
{
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::hyper_cube(mesh);
  mesh.begin_active()->vertex(0) = dealii::Point<3>(0.9, 0.9, 0.9);
  HexSpace space;
  EXPECT_THROW(space.reinit(mesh, MPI_COMM_WORLD), InputError);
}
