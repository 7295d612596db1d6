// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <deal.II/grid/grid_generator.h>

#include "../../set_entries.h"
#include "gas_run.h"
#include <gtest/gtest.h>

#include <set>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
template <int dim>
std::unique_ptr<LeafMesh<dim>>
make_mesh(const std::vector<std::string> &lines,
          const std::function<bool(const Point<dim> &)> &wanted = {},
          const unsigned int times = 0)
{
  dealii::ParameterHandler prm;
  CoarseMesh<dim>::declare_parameters(prm);
  set_entries(prm, lines);
  CoarseMesh<dim> coarse;
  coarse.parse_parameters(prm);
  auto mesh = std::make_unique<LeafMesh<dim>>(MPI_COMM_WORLD);
  mesh->create(coarse);
  mesh->triangulation().refine_global(coarse.initial_refinement());
  mesh->distribute();
  for (unsigned int i = 0; i < times; ++i)
  {
    for (const auto &cell : mesh->triangulation().active_cell_iterators())
      if (cell->is_locally_owned() && wanted(cell->center()))
        cell->set_refine_flag();
    mesh->triangulation().execute_coarsening_and_refinement();
    mesh->distribute();
  }
  return mesh;
}


/// Cell centres of all stored leaves by number; ghosts found by their
/// global index.
template <int dim>
std::map<unsigned int, Point<dim>> centres(const LeafMesh<dim> &mesh)
{
  std::map<unsigned int, Point<dim>> result;
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    result[leaf] = mesh.cell(leaf)->center();
  for (unsigned int i = 0; i < mesh.n_ghosts(); ++i)
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_ghost() && cell->subdomain_id() == mesh.ghosts()[i].owner &&
          cell->global_active_cell_index() == mesh.ghosts()[i].global_index)
        result[mesh.n_batches() * double_width + i] = cell->center();
  return result;
}


/// Checks every face of every owned leaf of an axis-aligned box of edge one
/// in each direction: what stands across it lies where it must.
template <int dim>
class FaceCheck
{
public:
  explicit FaceCheck(const LeafMesh<dim> &mesh)
    : mesh_(mesh)
    , centres_(centres(mesh))
  {}

  void run()
  {
    ASSERT_EQ(centres_.size(), mesh_.n_owned() + mesh_.n_ghosts());
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
    {
      const SpecialFace *previous = nullptr;
      for (auto s = mesh_.special_begin(batch); s != mesh_.special_end(batch);
           ++s)
      {
        EXPECT_LE(previous ? previous->face : 0, s->face);
        previous = s;
        ASSERT_LT(s->lane, mesh_.n_filled_lanes(batch));
        EXPECT_TRUE(
          special_.insert({batch * double_width + s->lane, s->face}).second);
        check_special(batch * double_width + s->lane, *s);
      }
    }
    for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
      for (unsigned int face = 0; face < 2 * dim; ++face)
        check_ordinary(leaf, face);
  }

  unsigned int n_boundary = 0, n_coarse_sides = 0, n_fine_sides = 0,
               n_ordinary = 0;

private:
  double size(const unsigned int leaf, const unsigned int d) const
  {
    return mesh_.extents(leaf / double_width)[d][leaf % double_width];
  }

  /// Distance along the box, which repeats itself.
  static double difference(const double a, const double b)
  {
    const double x = a - b;
    return x - std::round(x);
  }

  void expect_across(const unsigned int leaf,
                     const unsigned int face,
                     const unsigned int other,
                     const double ratio,
                     const unsigned int quarter)
  {
    ASSERT_TRUE(centres_.count(other)) << other;
    unsigned int t = 0;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double h = size(leaf, d);
      double expected = 0.;
      if (d == face / 2)
        expected = (face % 2 ? 1. : -1.) * 0.5 * h * (1. + ratio);
      else if (ratio < 1.)
        expected = ((quarter >> t) & 1U ? 0.25 : -0.25) * h;
      if (d != face / 2)
        ++t;
      // Where opposite sides are equally far both signs are right.
      EXPECT_NEAR(
        difference(centres_[other][d], centres_[leaf][d] + expected), 0., 1e-12)
        << "leaf " << leaf << " face " << face << " direction " << d;
    }
  }

  void check_special(const unsigned int leaf, const SpecialFace &s)
  {
    EXPECT_EQ(mesh_.neighbors(leaf / double_width, s.face)[leaf % double_width],
              leaf);
    if (s.kind == SpecialFace::Kind::boundary)
    {
      ++n_boundary;
      EXPECT_EQ(s.index, s.face);
      EXPECT_NEAR(centres_[leaf][s.face / 2],
                  s.face % 2 ? 1. - 0.5 * size(leaf, s.face / 2)
                             : 0.5 * size(leaf, s.face / 2),
                  1e-12);
      return;
    }
    const HangingFace<dim> &hanging = mesh_.hanging_faces()[s.index];
    EXPECT_EQ(hanging.match.face, hanging.coarse_face ^ 1U);
    EXPECT_EQ(hanging.match.orientation, 0);
    if (s.kind == SpecialFace::Kind::coarse_side)
    {
      ++n_coarse_sides;
      EXPECT_EQ(hanging.coarse_leaf, leaf);
      EXPECT_EQ(hanging.coarse_face, s.face);
      for (unsigned int part = 0; part < hanging.n_fine; ++part)
        expect_across(leaf, s.face, hanging.fine_leaf[part], 0.5, part);
    }
    else
    {
      ++n_fine_sides;
      EXPECT_EQ(hanging.match.face, s.face);
      ASSERT_LT(s.part, hanging.n_fine);
      EXPECT_EQ(hanging.fine_leaf[s.part], leaf);
      // Seen from the coarse leaf, this one is at its quarter.
      ASSERT_TRUE(centres_.count(hanging.coarse_leaf));
      unsigned int t = 0;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double h = size(leaf, d);
        const double offset = d == s.face / 2
                                ? (s.face % 2 ? 1.5 : -1.5) * h
                                : ((s.part >> t++) & 1U ? -0.5 : 0.5) * h;
        EXPECT_NEAR(difference(centres_[hanging.coarse_leaf][d],
                               centres_[leaf][d] + offset),
                    0.,
                    1e-12);
      }
    }
  }

  void check_ordinary(const unsigned int leaf, const unsigned int face)
  {
    if (special_.count({leaf, face}))
      return;
    ++n_ordinary;
    const unsigned int other =
      mesh_.neighbors(leaf / double_width, face)[leaf % double_width];
    const FaceMatch match =
      mesh_.matches(leaf / double_width, face)[leaf % double_width];
    expect_across(leaf, face, other, 1., 0);
    EXPECT_EQ(match.face, face ^ 1U);
    EXPECT_EQ(match.orientation, 0);
    if (other < mesh_.n_owned())
    {
      EXPECT_EQ(
        mesh_.neighbors(other / double_width, match.face)[other % double_width],
        leaf);
      EXPECT_FALSE(special_.count({other, match.face}));
    }
  }

  const LeafMesh<dim> &mesh_;
  std::map<unsigned int, Point<dim>> centres_;
  std::set<std::pair<unsigned int, unsigned int>> special_;
};


double total(const double mine)
{
  return dealii::Utilities::MPI::sum(mine, MPI_COMM_WORLD);
}


/// Faces of all leaves at the boundary, as the octree tells.
template <int dim>
double boundary_faces(const LeafMesh<dim> &mesh)
{
  double result = 0.;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int f : cell->face_indices())
        result += cell->at_boundary(f);
  return total(result);
}


/// Checks the mesh and that its faces add up over all ranks.
template <int dim>
void check(const LeafMesh<dim> &mesh,
           const double n_leaves,
           const double n_boundary)
{
  EXPECT_EQ(mesh.n_global(), n_leaves);
  FaceCheck<dim> faces(mesh);
  faces.run();
  // In 1-D every rank has the whole mesh.
  const auto sum = [](const double x) { return dim == 1 ? x : total(x); };
  EXPECT_EQ(sum(mesh.n_owned()), n_leaves);
  EXPECT_EQ(sum(faces.n_boundary), n_boundary);
  EXPECT_EQ(sum(faces.n_fine_sides),
            sum(faces.n_coarse_sides) * HangingFace<dim>::n_fine);
  EXPECT_EQ(sum(faces.n_ordinary + faces.n_boundary + faces.n_coarse_sides +
                faces.n_fine_sides),
            n_leaves * 2 * dim);
}
} // namespace


TEST(LeafMesh, UniformBoxes)
{
  check(*make_mesh<1>({"Domain/Coarse leaves=11"}), 11, 2);
  check(
    *make_mesh<2>({"Domain/Coarse leaves=3, 2", "Domain/Initial refinement=1"}),
    24,
    20);
  check(*make_mesh<3>(
          {"Domain/Coarse leaves=1, 2, 1", "Domain/Initial refinement=1"}),
        16,
        40);
}


TEST(LeafMesh, PeriodicBoxes)
{
  check(
    *make_mesh<1>({"Domain/Coarse leaves=9", "Domain/Periodic directions=x"}),
    9,
    0);
  check(*make_mesh<2>(
          {"Domain/Coarse leaves=3, 3", "Domain/Periodic directions=x"}),
        9,
        6);
  check(*make_mesh<3>({"Domain/Coarse leaves=3, 3, 3",
                       "Domain/Periodic directions=x, y, z"}),
        27,
        0);
}


TEST(LeafMesh, OnePeriodicCellIsItsOwnNeighbour)
{
  check(*make_mesh<1>({"Domain/Periodic directions=x"}), 1, 0);
  check(*make_mesh<2>({"Domain/Periodic directions=x, y"}), 1, 0);
  check(*make_mesh<3>({"Domain/Periodic directions=x, y, z"}), 1, 0);
}


TEST(LeafMesh, HangingFacesHaveTheRightLeaves)
{
  const auto plane = make_mesh<2>(
    {"Domain/Coarse leaves=2, 2", "Domain/Initial refinement=1"},
    [](const Point<2> &p) {
      return p.distance({0.4, 0.4}) < 0.3;
    },
    2);
  EXPECT_GT(plane->n_global(), 30);
  check(*plane, total(plane->n_owned()), boundary_faces(*plane));

  const auto space = make_mesh<3>(
    {"Domain/Initial refinement=1"},
    [](const Point<3> &p) {
      return p.distance({0.3, 0.3, 0.3}) < 0.3;
    },
    2);
  EXPECT_GT(space->n_global(), 20);
  check(*space, total(space->n_owned()), boundary_faces(*space));
}


TEST(LeafMesh, HangingFacesAcrossPeriodicSides)
{
  // Leaves at one side are halved; their neighbours across it are not.
  const auto plane = make_mesh<2>(
    {"Domain/Coarse leaves=4, 4", "Domain/Periodic directions=x, y"},
    [](const Point<2> &p) { return p[0] < 0.25 && p[1] < 0.25; },
    1);
  check(*plane, 16 - 1 + 4, 0);
  FaceCheck<2> plane_faces(*plane);
  plane_faces.run();
  EXPECT_EQ(total(plane_faces.n_coarse_sides), 4);

  const auto space = make_mesh<3>(
    {"Domain/Coarse leaves=4, 4, 4", "Domain/Periodic directions=x, y, z"},
    [](const Point<3> &p) { return p[0] < 0.25 && p[1] < 0.25 && p[2] < 0.25; },
    1);
  check(*space, 64 - 1 + 8, 0);
  FaceCheck<3> space_faces(*space);
  space_faces.run();
  EXPECT_EQ(total(space_faces.n_coarse_sides), 6);
}


TEST(LeafMesh, LeavesFollowTheMortonCurve)
{
  const auto mesh = make_mesh<2>({"Domain/Initial refinement=3"});
  const auto morton = [](const Point<2> &p) {
    const unsigned int x = p[0] * 8, y = p[1] * 8;
    unsigned int result = 0;
    for (unsigned int bit = 0; bit < 3; ++bit)
      result |= ((x >> bit) & 1U) << (2 * bit) | ((y >> bit) & 1U)
                                                   << (2 * bit + 1);
    return result;
  };
  for (unsigned int leaf = 1; leaf < mesh->n_owned(); ++leaf)
    EXPECT_EQ(morton(mesh->cell(leaf)->center()),
              morton(mesh->cell(leaf - 1)->center()) + 1);
  for (unsigned int leaf = 0; leaf < mesh->n_owned(); ++leaf)
  {
    EXPECT_EQ(mesh->leaf_of(mesh->cell(leaf)), leaf);
    EXPECT_EQ(
      mesh->leaf_of_global(mesh->cell(leaf)->global_active_cell_index()), leaf);
    for (unsigned int d = 0; d < 2; ++d)
    {
      EXPECT_NEAR(mesh->extents(leaf / double_width)[d][leaf % double_width],
                  0.125,
                  1e-15);
      EXPECT_NEAR(mesh->origins(leaf / double_width)[d][leaf % double_width],
                  mesh->cell(leaf)->center()[d] - 0.0625,
                  1e-15);
    }
  }
}


namespace
{
/// The matches that occur in a mesh.
struct SeenMatches
{
  unsigned int n_faces = 0;
  unsigned int n_not_opposite = 0; ///< a face meets another than its opposite
  std::set<unsigned int> orientations;
};


/// Matches every inner face from both sides.
template <int dim>
SeenMatches check_matches(const dealii::Triangulation<dim> &tria)
{
  SeenMatches seen;
  const unsigned int n = 4;
  const unsigned int n_b = dim == 3 ? n : 1;
  for (const auto &cell : tria.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
    {
      if (cell->at_boundary(f))
        continue;
      const auto other = cell->neighbor(f);
      const unsigned int g = cell->neighbor_of_neighbor(f);
      const FaceMatch there = match_faces<dim>(cell, f, other, g);
      const FaceMatch back = match_faces<dim>(other, g, cell, f);
      EXPECT_EQ(there.face, g);
      EXPECT_EQ(back.face, f);
      ++seen.n_faces;
      seen.n_not_opposite += there.face != (f ^ 1U);
      seen.orientations.insert(there.orientation);

      // Corners that meet are the same vertex ...
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < (dim == 3 ? 2U : 1U); ++j)
        {
          const unsigned int q = matched_face_point(there.orientation, i, j, 2);
          EXPECT_EQ(cell->vertex_index(face_corner<dim>(f, i, j)),
                    other->vertex_index(face_corner<dim>(g, q % 2, q / 2)));
        }
      // ... and every point comes back to itself.
      std::set<unsigned int> reached;
      for (unsigned int b = 0; b < n_b; ++b)
        for (unsigned int a = 0; a < n; ++a)
        {
          const unsigned int q = matched_face_point(there.orientation, a, b, n);
          EXPECT_LT(q, n * n_b);
          reached.insert(q);
          EXPECT_EQ(matched_face_point(back.orientation, q % n, q / n, n),
                    a + n * b);
        }
      EXPECT_EQ(reached.size(), n * n_b);
    }
  return seen;
}
} // namespace


TEST(MatchFaces, RotatedCells)
{
  dealii::Triangulation<2> disk;
  dealii::GridGenerator::hyper_ball(disk);
  disk.refine_global(1);
  // Lines have one direction in the whole of a 2-D mesh.
  const SeenMatches in_disk = check_matches(disk);
  EXPECT_GT(in_disk.n_not_opposite, 0u);
  EXPECT_EQ(in_disk.orientations, std::set<unsigned int>{0});

  dealii::Triangulation<3> ball;
  dealii::GridGenerator::hyper_ball(ball);
  ball.refine_global(1);
  EXPECT_GT(check_matches(ball).n_not_opposite, 0u);

  // Rings and pairs of cells bring up every orientation of a square.
  std::set<unsigned int> orientations;
  const auto add = [&](const dealii::Triangulation<3> &tria) {
    const SeenMatches seen = check_matches(tria);
    EXPECT_GT(seen.n_faces, 0u);
    orientations.insert(seen.orientations.begin(), seen.orientations.end());
  };
  for (unsigned int turns = 0; turns < 4; ++turns)
  {
    dealii::Triangulation<3> ring;
    dealii::GridGenerator::moebius(ring, 8, turns, 4., 1.);
    add(ring);
  }
  for (unsigned int bits = 0; bits < 16; ++bits)
  {
    dealii::Triangulation<3> pair;
    dealii::GridGenerator::non_standard_orientation_mesh(
      pair, bits & 1U, bits & 2U, bits & 4U, bits & 8U);
    add(pair);
  }
  EXPECT_EQ(orientations.size(), 8u);
}
