// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/element/hex8_moments.h>

#include "hexahedra.h"
#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;

namespace
{
std::array<Vector3<double>, 4> face_of(const Corners &corners,
                                       const unsigned int face)
{
  std::array<Vector3<double>, 4> result;
  for (unsigned int i = 0; i < 4; ++i)
    result[i] = corners[hex_faces[face][i]];
  return result;
}

Corners moved(const Corners &corners, const double most, std::mt19937 &random)
{
  std::uniform_real_distribution<double> shift(-most, most);
  Corners result = corners;
  for (auto &corner : result)
    for (double &x : corner)
      x += shift(random);
  return result;
}

const Corners cube{{{{0., 0., 0.}},
                    {{1., 0., 0.}},
                    {{1., 1., 0.}},
                    {{0., 1., 0.}},
                    {{0., 0., 1.}},
                    {{1., 0., 1.}},
                    {{1., 1., 1.}},
                    {{0., 1., 1.}}}};
} // namespace

TEST(Hex8Moments, of_a_cube_are_volume_and_centre)
{
  const auto moments = hex_moments(cube);
  EXPECT_NEAR(moments.volume, 1., 1e-15);
  for (unsigned int d = 0; d < 3; ++d)
    EXPECT_NEAR(moments.first[d], 0.5, 1e-15);
  EXPECT_NEAR(smallest_corner_jacobian(cube), 1., 1e-15);
}

TEST(Hex8Moments, of_a_frustum_are_those_of_its_integral)
{
  Corners frustum = cube;
  for (const unsigned int i : {4, 5, 6, 7})
  {
    frustum[i][0] = 0.3 + 1.7 * cube[i][0];
    frustum[i][1] = -0.2 + 1.7 * cube[i][1];
    frustum[i][2] = 2.;
  }
  const double a = 1., b = 1.7 * 1.7, h = 2.;
  const auto moments = hex_moments(frustum);
  EXPECT_NEAR(moments.volume, h / 3. * (a + std::sqrt(a * b) + b), 1e-14);
  EXPECT_NEAR(
    moments.first[2], h * h * (1. / 2. + 2. * 0.7 / 3. + 0.49 / 4.), 1e-13);
}

TEST(Hex8Moments, what_faces_sweep_closes_volume_and_moment)
{
  std::mt19937 random(3);
  for (unsigned int n = 0; n < 50; ++n)
  {
    const Corners before = moved(cube, 0.2, random);
    const Corners after = moved(before, 0.2, random);
    HexMoments<double> sum = hex_moments(before);
    for (unsigned int f = 0; f < 6; ++f)
    {
      const auto swept = swept_moments(face_of(before, f), face_of(after, f));
      sum.volume += swept.volume;
      for (unsigned int d = 0; d < 3; ++d)
        sum.first[d] += swept.first[d];
    }
    const auto expected = hex_moments(after);
    EXPECT_NEAR(sum.volume, expected.volume, 1e-14);
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(sum.first[d], expected.first[d], 1e-14);
  }
}

TEST(Hex8Moments, sees_a_corner_that_is_pushed_in)
{
  for (unsigned int i = 0; i < 8; ++i)
  {
    Corners bad = cube;
    for (unsigned int d = 0; d < 3; ++d)
      bad[i][d] += 0.7 * (1. - 2. * cube[i][d]);
    EXPECT_LT(smallest_corner_jacobian(bad), 0.) << i;
  }
}
