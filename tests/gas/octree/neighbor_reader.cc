// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/neighbor_reader.h>

#include <gtest/gtest.h>

#include <vector>

using namespace contrecoup;
using namespace contrecoup::gas;

namespace
{
/// A number for each component and point of a leaf, all different.
double
value(const unsigned int leaf, const unsigned int c, const unsigned int q)
{
  return leaf * 1000. + c * 100. + q;
}


/// Reads leaves in disorder, of up to as many batches as lanes.
template <typename Real>
void expect_that_leaves_are_read()
{
  constexpr unsigned int width = n_lanes<Real>;
  const unsigned int n_batches = width + 1, n_components = 6;
  const LeafLayout layout(3, 2, n_components, precision_of<Real>);
  std::vector<Real> field(n_batches * layout.batch_size());
  for (unsigned int leaf = 0; leaf < n_batches * width; ++leaf)
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int q = 0; q < layout.n_points; ++q)
        field[layout.offset(leaf) + layout.value(c, q)] = value(leaf, c, q);

  for (const unsigned int step : {1U, 3U, width, width + 1})
  {
    std::array<unsigned int, width> leaves;
    for (unsigned int lane = 0; lane < width; ++lane)
      leaves[lane] =
        (5 + (lane * step) % (width * width)) % (n_batches * width);
    NeighborReader<Real> reader;
    reader.reinit(leaves.data(), layout);
    EXPECT_LE(reader.n_sources(), width);
    for (unsigned int q = 0; q < layout.n_points; ++q)
    {
      std::array<Lanes<Real>, 6> all;
      reader.read(field.data() + layout.value(0, q), layout.value(1, 0), all);
      for (unsigned int c = 0; c < n_components; ++c)
      {
        const Lanes<Real> one = reader.read(field.data() + layout.value(c, q));
        for (unsigned int lane = 0; lane < width; ++lane)
        {
          EXPECT_EQ(all[c][lane], Real(value(leaves[lane], c, q)))
            << "step " << step << ", lane " << lane;
          EXPECT_EQ(one[lane], all[c][lane]);
        }
      }
    }
  }
}
} // namespace


TEST(NeighborReader, ReadsLeavesOfAnyBatches)
{
  expect_that_leaves_are_read<double>();
  expect_that_leaves_are_read<float>();
}
