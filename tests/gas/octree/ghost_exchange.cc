// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "gas_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
/// A number that belongs to one value of one cell of the whole mesh.
double signature(const std::uint64_t cell, const unsigned int i)
{
  return 1000. * cell + i + 1. / (1. + cell + 3. * i);
}


/// Points of a leaf in the two layers below the faces of a mask.
template <int dim>
std::vector<unsigned int> points_near_faces(const unsigned char faces,
                                            const LeafLayout &layout)
{
  EXPECT_NE(faces, 0);
  std::vector<unsigned int> result;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    for (unsigned int depth = 0; depth < std::min(2U, layout.n); ++depth)
      for (unsigned int q = 0; q < layout.n_face_points; ++q)
        if ((faces >> face) & 1U)
          result.push_back(layout.face_point(face, q, depth));
  return result;
}


/// Faces of the ghosts, by number, that owned leaves meet.
template <int dim>
std::map<unsigned int, unsigned int> faces_met(const LeafMesh<dim> &mesh)
{
  std::map<unsigned int, unsigned int> result;
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    for (unsigned int face = 0; face < 2 * dim; ++face)
    {
      const unsigned int other =
        mesh.neighbors(leaf / double_width, face)[leaf % double_width];
      const FaceMatch match =
        mesh.matches(leaf / double_width, face)[leaf % double_width];
      if (other >= mesh.n_batches() * double_width)
        result[other] |= 1U << match.face;
    }
  for (const auto &hanging : mesh.hanging_faces())
  {
    if (hanging.coarse_leaf >= mesh.n_batches() * double_width)
      result[hanging.coarse_leaf] |= 1U << hanging.coarse_face;
    for (const unsigned int leaf : hanging.fine_leaf)
      if (leaf != no_leaf && leaf >= mesh.n_batches() * double_width)
        result[leaf] |= 1U << hanging.match.face;
  }
  return result;
}


template <int dim>
void check_exchange(const std::vector<std::string> &lines)
{
  GasRun<dim> run(finite_volume(4) + lines);
  run.refine([](const Point<dim> &p) { return p[0] + p[1] < 0.9; });
  run.field.reinit(run.layout, run.mesh.n_stored_batches());
  const unsigned int n_values = run.layout.n_points * run.layout.n_components;
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    const auto cell = run.mesh.cell(leaf)->global_active_cell_index();
    std::vector<double> values(n_values);
    for (unsigned int i = 0; i < n_values; ++i)
      values[i] = signature(cell, i);
    run.field.set_leaf(leaf, values);
    run.field.sensors()[leaf] = signature(cell, n_values);
  }

  GhostExchange<dim> exchange;
  exchange.reinit(run.mesh, run.layout);
  // Twice: the second finds its buffers used.
  for (unsigned int repeat = 0; repeat < 2; ++repeat)
    exchange.update(run.field.state(), run.field.sensors());

  const auto faces = faces_met(run.mesh);
  EXPECT_EQ(faces.size(), run.mesh.n_ghosts());
  for (unsigned int i = 0; i < run.mesh.n_ghosts(); ++i)
  {
    const auto cell = run.mesh.ghosts()[i].global_index;
    const unsigned int leaf = run.mesh.n_batches() * double_width + i;
    ASSERT_TRUE(faces.count(leaf));
    // No face that is read may be missing.
    EXPECT_EQ(run.mesh.ghosts()[i].faces | faces.at(leaf),
              run.mesh.ghosts()[i].faces);
    const auto values = run.field.leaf(leaf);
    for (const unsigned int q :
         points_near_faces<dim>(run.mesh.ghosts()[i].faces, run.layout))
      for (unsigned int c = 0; c < run.layout.n_components; ++c)
      {
        const unsigned int k = c * run.layout.n_points + q;
        ASSERT_EQ(values[k], signature(cell, k));
      }
    EXPECT_EQ(run.field.sensors()[leaf], signature(cell, n_values));
  }
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    EXPECT_EQ(run.field.leaf(leaf)[0],
              signature(run.mesh.cell(leaf)->global_active_cell_index(), 0));
  const unsigned int n_ranks =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  EXPECT_EQ(run.mesh.n_ghosts() > 0, n_ranks > 1);
}
} // namespace


TEST(GhostExchange, GhostsEqualTheirOwners)
{
  check_exchange<2>({"Domain/Initial refinement=2"});
  check_exchange<3>({"Domain/Initial refinement=2"});
}


TEST(GhostExchange, AcrossPeriodicSides)
{
  check_exchange<2>({"Domain/Coarse leaves=3, 2",
                     "Domain/Periodic directions=x, y",
                     "Domain/Initial refinement=1"});
  check_exchange<3>({"Domain/Coarse leaves=1, 1, 2",
                     "Domain/Periodic directions=z",
                     "Domain/Initial refinement=1"});
}


TEST(GhostExchange, MixturesHaveOneMoreComponent)
{
  check_exchange<2>(products_in_air() +
                    std::vector<std::string>{"Domain/Initial refinement=2"});
}
