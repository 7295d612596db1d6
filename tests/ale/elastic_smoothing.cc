// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/rezone/elastic_smoothing.h>

#include "slab.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{
constexpr unsigned int width = node_width;

/// Whether a node of the unit cube is at its boundary.
bool is_outside(const double *x)
{
  bool result = false;
  for (unsigned int d = 0; d < 3; ++d)
    result = result || x[d] < 1e-12 || x[d] > 1. - 1e-12;
  return result;
}

std::vector<std::array<bool, 3>> outside(const Slab &slab)
{
  std::vector<std::array<bool, 3>> result;
  for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
  {
    const bool is = is_outside(&slab.state.position[width * n]);
    result.push_back({{is, is, is}});
  }
  return result;
}
} // namespace

TEST(ElasticSmoothing, finds_linear_displacements_exactly)
{
  Slab slab({6, 6, 6}, 1.);
  ElasticOptions options;
  options.tolerance = 1e-12;
  ElasticSmoothing smoothing;
  smoothing.reinit(slab.space, {outside(slab), {}}, options);
  const auto expected = [](const double *x, const unsigned int d) {
    return 0.1 * x[d] + 0.2 * x[(d + 1) % 3] - 0.03;
  };
  dealii::AlignedVector<double> displacement(slab.state.position.size());
  for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
      if (is_outside(&slab.state.position[width * n]))
        displacement[width * n + d] =
          expected(&slab.state.position[width * n], d);
  const unsigned int first = smoothing.solve(slab.state.position, displacement);
  EXPECT_GT(first, 0U);
  for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(displacement[width * n + d],
                  expected(&slab.state.position[width * n], d),
                  1e-11);
  // From its solution the same problem is solved at once.
  EXPECT_LE(smoothing.solve(slab.state.position, displacement), 1U);
}

// The wall at x = 1 goes in by a half: cells of equal stiffness share it
// equally, and where small cells are stiff they keep more of their width.
TEST(ElasticSmoothing, stiffness_keeps_small_cells)
{
  std::vector<double> widths;
  for (const double stiffening : {0., 1.})
  {
    Slab slab({8, 8, 8}, 1.);
    for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
      slab.state.position[width * n] *=
        0.2 + 0.8 * slab.state.position[width * n];
    std::vector<std::array<bool, 3>> prescribed;
    dealii::AlignedVector<double> displacement(slab.state.position.size());
    for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
    {
      const double *x = &slab.state.position[width * n];
      std::array<bool, 3> is{{x[0] < 1e-12 || x[0] > 1. - 1e-12, false, false}};
      for (unsigned int d = 1; d < 3; ++d)
        is[d] = x[d] < 1e-12 || x[d] > 1. - 1e-12;
      prescribed.push_back(is);
      if (x[0] > 1. - 1e-12)
        displacement[width * n] = -0.5;
    }
    ElasticOptions options;
    options.stiffening = stiffening;
    options.tolerance = 1e-10;
    ElasticSmoothing smoothing;
    smoothing.reinit(slab.space, {prescribed, {}}, options);
    smoothing.solve(slab.state.position, displacement);
    const double first = (0.2 + 0.8 / 8.) / 8.;
    double width_now = 0.;
    for (std::size_t n = 0; n < slab.space.n_locally_owned_nodes(); ++n)
      if (std::abs(slab.state.position[width * n] - first) < 1e-12)
        width_now = std::max(width_now, 1. + displacement[width * n] / first);
    widths.push_back(dealii::Utilities::MPI::max(width_now, MPI_COMM_WORLD));
  }
  EXPECT_NEAR(widths[0], 0.5, 1e-6);
  EXPECT_GT(widths[1], 0.8);
}
