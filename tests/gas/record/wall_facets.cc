// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/record/wall_facets.h>

#include "body_run.h"
#include <gtest/gtest.h>

#include <map>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;
using dealii::Tensor;

namespace
{
template <int dim>
Lines ball(const std::string &treatment)
{
  return Lines{"Rigid body/Kind=body",
               "Rigid body/Treatment=" + treatment,
               "Body/Kind=shape",
               "Body/Shape/Shape=sphere",
               "Body/Shape/Size=0.213",
               std::string("Body/Shift=0.53, 0.48, ") +
                 (dim == 3 ? "0.51" : "0"),
               "Domain/Initial refinement=2"} +
         finite_volume(4);
}


template <int dim>
WallFacets<dim> facets_of(GasRun<dim> &run)
{
  run.set_state([](const Point<dim> &) { return still_air<dim>(); });
  WallFacets<dim> facets;
  EXPECT_TRUE(facets.mesh_changed(run.snapshot()));
  return facets;
}


/// Volume without gas, of all ranks.
double closed_volume(const GasRun<3> &run)
{
  double sum = 0.;
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
    for (unsigned int q = 0; q < run.layout.n_points; ++q)
      sum += (1. - run.field.open_fraction(leaf, q)) *
             point_volume(leaf_box(run.mesh, leaf), run.points, q);
  return dealii::Utilities::MPI::sum(sum, run.mesh.communicator());
}


/// Vertices of a facet.
std::vector<Point<3>> corners(const io::SkinMesh &skin, const std::size_t facet)
{
  std::vector<Point<3>> result;
  for (std::int64_t i = facet == 0 ? 0 : skin.ends[facet - 1];
       i < skin.ends[facet];
       ++i)
  {
    const float *x = &skin.vertices[3 * skin.corners[i]];
    result.emplace_back(x[0], x[1], x[2]);
  }
  return result;
}


bool is_first_rank()
{
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}
} // namespace


TEST(WallFacets, PolygonsHaveTheFacetsAreasAndCloseTheSkin)
{
  for (const std::string treatment : {"embedded", "staircase"})
  {
    GasRun<3> run(ball<3>(treatment));
    const auto facets = facets_of(run);
    const double closed = closed_volume(run);
    const io::SkinMesh &skin = facets.skin();
    if (!is_first_rank())
    {
      EXPECT_TRUE(skin.ends.empty());
      continue;
    }
    ASSERT_EQ(skin.ends.size(), facets.n_global());
    EXPECT_FALSE(skin.are_lines);
    double volume = 0.;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t f = 0; f < skin.ends.size(); ++f)
    {
      const auto x = corners(skin, f);
      Tensor<1, 3> area;
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        const std::size_t j = (i + 1) % x.size();
        area += 0.5 * cross_product_3d(x[i], x[j]);
        volume += x[0] * cross_product_3d(x[i], x[j]) / 6.;
        const auto *numbers =
          &skin.corners[skin.ends[f] - std::int64_t(x.size())];
        if (numbers[i] < numbers[j])
          ++edges[{numbers[i], numbers[j]}];
        else
          --edges[{numbers[j], numbers[i]}];
      }
      // Geometry has area vectors into the body.
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(area[d], -facets.geometry()[6 * f + 3 + d], 1e-8) << f;
    }
    // Each edge is passed as often there as back.
    for (const auto &edge : edges)
      EXPECT_EQ(edge.second, 0) << treatment;
    // Within a cell, an outline is filled by other triangles; steps are cut
    // off.
    if (treatment == "embedded")
      EXPECT_NEAR(volume, closed, 5e-3 * closed);
    else
      EXPECT_NEAR(volume, closed, 0.15 * closed);
  }
}


TEST(WallFacets, LinesHaveTheFacetsLengths)
{
  GasRun<2> run(ball<2>("embedded"));
  const auto facets = facets_of(run);
  const io::SkinMesh &skin = facets.skin();
  if (!is_first_rank())
    return;
  ASSERT_EQ(skin.ends.size(), facets.n_global());
  EXPECT_TRUE(skin.are_lines);
  for (std::size_t f = 0; f < skin.ends.size(); ++f)
  {
    const auto x = corners(skin, f);
    ASSERT_GE(x.size(), 2U);
    const Tensor<1, 3> along = x.back() - x.front();
    const double *area = &facets.geometry()[6 * f + 3];
    EXPECT_NEAR(std::abs(along[1]), std::abs(area[0]), 1e-7) << f;
    EXPECT_NEAR(std::abs(along[0]), std::abs(area[1]), 1e-7) << f;
  }
}


TEST(WallFacets, RanksDoNotChangeABitOfTheSkin)
{
  GasRun<3> alone(ball<3>("embedded"), MPI_COMM_SELF);
  GasRun<3> together(ball<3>("embedded"));
  const auto one = facets_of(alone), all = facets_of(together);
  if (!is_first_rank())
    return;
  EXPECT_EQ(one.skin().vertices, all.skin().vertices);
  EXPECT_EQ(one.skin().corners, all.skin().corners);
  EXPECT_EQ(one.skin().ends, all.skin().ends);
}
