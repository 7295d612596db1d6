// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>
#include <contrecoup/solid/body/mesh_description.h>
#include <contrecoup/solid/boundary/load_alignment.h>
#include <contrecoup/solid/boundary/surface_loads.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

using namespace contrecoup;
using dealii::Point;

namespace
{
constexpr double radius = 0.1;

/// Facets of equal area on the ball around 0, or on its half at y > 0, by the
/// golden angle.
io::LoadFile::Facets facets_of_ball(const bool is_half)
{
  constexpr double pi = 3.14159265358979323846;
  constexpr unsigned int n_facets = 9000; // more than are looked at
  io::LoadFile::Facets facets;
  for (unsigned int i = 0; i < n_facets; ++i)
  {
    const double height = 1. - (2. * i + 1.) / n_facets;
    const double angle = pi * (3. - std::sqrt(5.)) * i;
    const double aside = std::sqrt(1. - height * height);
    const Point<3> normal(
      aside * std::cos(angle), aside * std::sin(angle), height);
    if (is_half && normal[1] < 0.)
      continue;
    for (unsigned int d = 0; d < 3; ++d)
    {
      facets.centroids.push_back(radius * normal[d]);
      facets.normals.push_back(normal[d]);
    }
    facets.areas.push_back(4. * pi * radius * radius / n_facets);
  }
  return facets;
}
} // namespace


// The distances between two balls that are a way apart which is smaller than
// their radius have the mean of half that way, and the cosines between their
// normals that of 1 less a third of (way / radius)^2, exactly.
TEST(LoadAlignment, FacetsAreHalfTheWayOffABallThatWasMoved)
{
  const auto facets = facets_of_ball(false);
  const double edge = std::sqrt(facets.areas[0]);
  for (const double way : {0., 0.02, 0.08})
  {
    const solid::LoadAlignment alignment = solid::measure_load_alignment(
      facets, Sphere(Point<3>(0., 0., way), radius), {});
    EXPECT_NEAR(alignment.distance, 0.5 * way, 2e-3 * way + 1e-12);
    EXPECT_NEAR(alignment.facet_edge, edge, 1e-9);
    EXPECT_NEAR(alignment.offset[2], -way, 1e-3 * radius);
    EXPECT_NEAR(alignment.offset.norm(), way, 1e-2 * radius);
    const double part = way / radius;
    EXPECT_NEAR(
      alignment.agreement, 1. - part * part / 3., 1e-3 * part + 1e-12);
  }
}


// Seen from the other side, facets on the surface face the wrong way.
TEST(LoadAlignment, FacetsThatFaceInwardsDisagree)
{
  auto facets = facets_of_ball(false);
  for (double &number : facets.normals)
    number *= -1.;
  const solid::LoadAlignment alignment =
    solid::measure_load_alignment(facets, Sphere(Point<3>(), radius), {});
  EXPECT_NEAR(alignment.agreement, -1., 1e-12);
}


// Loads of the ball are taken; those that lie on it but face inwards, as on the
// wall of a cavity, are those of another body.
TEST(LoadAlignment, LoadsOnTheSurfaceOfAnotherBodyAreRefused)
{
  const std::string file = "load_place.h5";
  for (const double sign : {1., -1.})
  {
    auto facets = facets_of_ball(false);
    for (double &number : facets.normals)
      number *= sign;
    {
      io::LoadFile loads(file);
      loads.create(facets, {{"application", "test"}});
    }
    ParameterHandler prm;
    solid::MeshDescription::declare_parameters(prm);
    solid::SurfaceLoads::declare_parameters(prm);
    apply_assignments({{{"Mesh"}, "Kind", "body", "test"},
                       {{"Body"}, "Kind", "shape", "test"},
                       {{"Body", "Shape"}, "Shape", "sphere", "test"},
                       {{"Body", "Shape"}, "Size", "0.1", "test"},
                       {{"Loads", "Recorded"}, "File", file, "test"}},
                      prm);
    if (sign > 0.)
      EXPECT_NO_THROW(solid::check_load_alignment(prm));
    else
      EXPECT_THROW(solid::check_load_alignment(prm), InputError);
  }
}


// Recorded at y > 0: mirrored, their middle is that of the ball.
TEST(LoadAlignment, HalvesAreWholesWhenTheyAreMirrored)
{
  const auto facets = facets_of_ball(true);
  const Sphere ball(Point<3>(), radius);
  const auto half = solid::measure_load_alignment(facets, ball, {});
  EXPECT_NEAR(half.offset[1], 0.5 * radius, 1e-2 * radius);
  const auto whole =
    solid::measure_load_alignment(facets, ball, {{false, true, false}});
  EXPECT_NEAR(whole.offset[1], 0., 1e-12);
  EXPECT_NEAR(whole.distance, 0., 1e-12);
}


// The file says of which symmetry its loads are; a body that is on one side of
// the plane itself needs no mirrored loads.
TEST(LoadAlignment, MirrorFollowsTheSymmetryOfTheRecord)
{
  const std::string path = "load_symmetry.h5";
  const auto refusal = [&](const std::array<bool, 3> &mirrored,
                           const double lower) -> std::string {
    try
    {
      solid::require_mirror(
        io::LoadReader(path),
        mirrored,
        {{Point<3>(-1., lower, -1.), Point<3>(1., 1., 1.)}});
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  };
  const auto write = [&](const std::string &factors) {
    io::LoadFile(path).create(facets_of_ball(true),
                              {{"factors_to_whole_body", factors}});
  };
  write("2, 0, 2");
  EXPECT_EQ(refusal({{false, true, false}}, -1.), "");
  EXPECT_EQ(refusal({{false, false, false}}, -0.01), "");
  EXPECT_EQ(refusal({{false, false, false}}, -1.),
            "Loads/Recorded/Mirror = none: the loads were recorded on one side "
            "of the plane of symmetry y = 0, and the body is on both; Mirror "
            "must be y");
  EXPECT_EQ(refusal({{true, true, false}}, -1.),
            "Loads/Recorded/Mirror = x and y: the loads were recorded on both "
            "sides of x = 0; Mirror must be y");
  write("0, 0, 4");
  EXPECT_NE(refusal({{true, false, false}}, -1.).find("must be x and y"),
            std::string::npos);
  write("1, 1, 1");
  EXPECT_EQ(refusal({{false, false, false}}, -1.), "");
  EXPECT_NE(refusal({{false, false, true}}, -1.).find("must be none"),
            std::string::npos);
  std::filesystem::remove(path);
}
