// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/surface_patch.h>

#include "bone_and_brain.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using dealii::Point;

namespace
{
/// A box of 60 x 40 x 40 mm whose matter moves with v = (10 y, 2, -3) m/s.
struct Box
{
  explicit Box(const bool refined)
    : mesh(solid::distribute(half_brain(refined), MPI_COMM_WORLD))
  {
    nodes.reinit(mesh.nodes.size());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    {
      nodes.velocity_of(i)[0] = 10. * mesh.nodes[i][1];
      nodes.velocity_of(i)[1] = 2.;
      nodes.velocity_of(i)[2] = -3.;
    }
  }

  solid::SurfacePatch patch(const Point<3> &place, const double radius) const
  {
    solid::SurfacePatch result;
    result.reinit(mesh, place, radius, MPI_COMM_WORLD);
    return result;
  }

  solid::SolidMesh mesh;
  solid::NodeFields<double> nodes;
};
} // namespace


TEST(SurfacePatch, MovesAgainstTheOuterNormal)
{
  for (const bool refined : {false, true})
  {
    const Box box(refined);
    EXPECT_NEAR(
      box.patch(Point<3>(0.03, 0.04, 0.02), 0.0145).inward_velocity(box.nodes),
      -2.,
      1e-12);
    EXPECT_NEAR(
      box.patch(Point<3>(0.03, 0.02, 0.04), 0.0145).inward_velocity(box.nodes),
      3.,
      1e-12);
  }
}


// Four facets in the middle of x = 60 mm, where y is 20 mm in the mean.
TEST(SurfacePatch, MovesAsItsMeanDoes)
{
  const Box box(false);
  const auto end = box.patch(Point<3>(0.06, 0.02, 0.02), 0.0145);
  EXPECT_NEAR(end.area(), 4e-4, 1e-14);
  EXPECT_NEAR(end.inward_velocity(box.nodes), -0.2, 1e-12);
}


// The motion into a closed surface equals that out of it.
TEST(SurfacePatch, OfTheWholeBodyHasNoMeanInTranslation)
{
  const Box box(false);
  const auto whole = box.patch(Point<3>(), 1.);
  EXPECT_NEAR(whole.area(), 2. * (0.06 * 0.08 + 0.0016), 1e-12);
  EXPECT_NEAR(whole.inward_velocity(box.nodes), 0., 1e-12);
}


TEST(SurfacePatch, TakesTheNearestFacetWhereNoneIsWithinTheRadius)
{
  const Box box(false);
  const auto one = box.patch(Point<3>(0.08, 0.015, 0.015), 0.);
  EXPECT_NEAR(one.area(), 1e-4, 1e-14);
  EXPECT_NEAR(one.inward_velocity(box.nodes), -0.15, 1e-12);
}
