// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/element/hex8_corner_weights.h>
#include <contrecoup/numerics/element/hex8_moments.h>
#include <contrecoup/numerics/element/hex8_wedge.h>

#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
/// A cell of a wedge about an axis between these places (out, along the axis).
HexVectors<double>
wedge_cell(const HexWedge &wedge,
           const std::array<std::array<double, 2>, 4> &section)
{
  // The corners of the section, and the side.
  constexpr unsigned int place[] = {0, 1, 1, 0, 3, 2, 2, 3};
  constexpr double sign[] = {-1., -1., 1., 1., -1., -1., 1., 1.};
  HexVectors<double> corners;
  for (unsigned int i = 0; i < 8; ++i)
  {
    corners[i][wedge.out()] = section[place[i]][0];
    corners[i][wedge.side()] = sign[i] * wedge.slope * section[place[i]][0];
    corners[i][wedge.axis] = section[place[i]][1];
  }
  return corners;
}

constexpr std::array<std::array<double, 2>, 4> skewed{
  {{{0.5, 0.1}}, {{1.4, -0.1}}, {{1.6, 0.9}}, {{0.7, 1.2}}}};
} // namespace

/// A brick's corners have an eighth each; in a ring from the axis on, the outer
/// ones, whose function is r / h, have two thirds of its volume.
TEST(Hex8Wedge, weighs_corners_by_what_is_around_them)
{
  const HexWedge wedge{2, 0.1};
  const auto ring = hex_corner_weights(
    wedge_cell(wedge, {{{{0., 0.}}, {{1., 0.}}, {{1., 1.}}, {{0., 1.}}}}));
  for (unsigned int i = 0; i < 8; ++i)
    EXPECT_NEAR(ring[i], (i % 4 == 1 || i % 4 == 2 ? 2. : 1.) / 12., 1e-15);
  const HexVectors<double> brick{{{{0., 0., 0.}},
                                  {{2., 0., 0.}},
                                  {{2., 3., 0.}},
                                  {{0., 3., 0.}},
                                  {{0., 0., 1.}},
                                  {{2., 0., 1.}},
                                  {{2., 3., 1.}},
                                  {{0., 3., 1.}}}};
  for (const double part : hex_corner_weights(brick))
    EXPECT_NEAR(part, 0.125, 1e-15);
}

/// By differences of volumes, whose nodes move along the sides.
TEST(Hex8Wedge, knows_the_lengths_of_motion_along_its_sides)
{
  for (unsigned int axis = 0; axis < 3; ++axis)
    for (const double slope : {0.01, 0.5})
    {
      const HexWedge wedge{axis, slope};
      const auto corners = wedge_cell(wedge, skewed);
      double wanted = 0.;
      for (unsigned int i = 0; i < 8; ++i)
        for (const bool is_radial : {true, false})
        {
          const auto volume = [&](const double way) {
            auto moved = corners;
            if (is_radial)
            {
              moved[i][wedge.out()] += way;
              moved[i][wedge.side()] +=
                corners[i][wedge.side()] > 0. ? slope * way : -slope * way;
            }
            else
              moved[i][axis] += way;
            return hex_moments(moved).volume;
          };
          wanted += std::pow((volume(1e-3) - volume(-1e-3)) / 2e-3, 2);
        }
      auto g = hex_geometry(to_modes(corners));
      wedge.restrict_lengths(g);
      EXPECT_NEAR(g.gradient_square, wanted, 1e-9 * wanted) << axis;
    }
}

/// Sections that turn about the side's normal, or move along the sides, have no
/// mode that is resisted, and the gradients of a body of revolution.
TEST(Hex8Wedge, has_the_gradients_of_a_body_of_revolution)
{
  const HexWedge wedge{2, 0.3};
  const auto corners = wedge_cell(wedge, skewed);
  const auto g = hex_geometry(to_modes(corners));
  HexVectors<double> u;
  for (unsigned int i = 0; i < 8; ++i)
  {
    const double radial = 0.2 * corners[i][2];
    u[i] = {{radial,
             corners[i][1] > 0. ? 0.3 * radial : -0.3 * radial,
             -0.2 * corners[i][0]}};
  }
  const auto h = mean_gradient(g, to_modes(u));
  EXPECT_NEAR(h[0][2], 0.2, 1e-15);
  EXPECT_NEAR(h[2][0], -0.2, 1e-15);
  EXPECT_NEAR(h[0][0], 0., 1e-15);
  // Radial displacement over the radius, averaged by the volume.
  const auto moments = hex_moments(corners);
  double height = 0.;
  for (unsigned int i = 0; i < 4; ++i)
  {
    const auto &a = skewed[i], &b = skewed[(i + 1) % 4];
    const double part = 0.5 * (a[0] * b[1] - b[0] * a[1]);
    height += part * (a[1] + b[1]) / 3.;
  }
  EXPECT_NEAR(h[1][1], 0.2 * height * 2. * 0.3 / moments.volume, 1e-14);
  auto modes = hourglass_modes(g, to_modes(u), h);
  EXPECT_GT(std::abs(modes[0][1]), 1e-3);
  wedge.restrict_modes(modes);
  for (const auto &mode : modes)
    for (const double value : mode)
      EXPECT_NEAR(value, 0., 1e-15);
}
