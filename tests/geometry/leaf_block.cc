// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/leaf_block.h>

#include <gtest/gtest.h>

#include <cmath>

using contrecoup::LeafBlock;
using contrecoup::sum_over_leaves;

namespace
{
/// A ball of 20.3 leaves in radius in a box of n leaves along each edge: three
/// cells in each leaf, nine where its surface is nearer than a leaf.
class Ball
{
public:
  explicit Ball(const unsigned int n)
    : all_{{{0, 0, 0}}, {{n, n + 1, n / 2}}}
  {}

  double sum()
  {
    return sum_over_leaves<3>(
      all_,
      [this](const LeafBlock<3> &block) {
        double diagonal = 0.;
        for (unsigned int d = 0; d < 3; ++d)
          diagonal += std::pow(block.end[d] - block.begin[d], 2);
        ++looks;
        return std::abs(distance(block)) > 0.5 * std::sqrt(diagonal) + 1.;
      },
      3.,
      [this](const LeafBlock<3> &leaf) {
        ++looks;
        return cells(leaf);
      });
  }

  double sum_of_each() const
  {
    double sum = 0.;
    LeafBlock<3> leaf;
    for (unsigned int x = 0; x < all_.end[0]; ++x)
      for (unsigned int y = 0; y < all_.end[1]; ++y)
        for (unsigned int z = 0; z < all_.end[2]; ++z)
        {
          leaf.begin = {{x, y, z}};
          leaf.end = {{x + 1, y + 1, z + 1}};
          sum += cells(leaf);
        }
    return sum;
  }

  double n_leaves() const
  {
    return all_.n_leaves();
  }

  double looks = 0.;

private:
  static double distance(const LeafBlock<3> &block)
  {
    double square = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      square += std::pow(0.5 * (block.begin[d] + block.end[d]) - 30.2, 2);
    return std::sqrt(square) - 20.3;
  }

  static double cells(const LeafBlock<3> &leaf)
  {
    return std::abs(distance(leaf)) < 1. ? 9. : 3.;
  }

  LeafBlock<3> all_;
};
} // namespace

TEST(LeafBlock, SumIsThatOfAllLeaves)
{
  Ball ball(80);
  EXPECT_EQ(ball.n_leaves(), 80. * 81. * 40.);
  EXPECT_EQ(ball.sum(), ball.sum_of_each());
  EXPECT_GT(ball.sum_of_each(), 3. * ball.n_leaves());
}


TEST(LeafBlock, LooksGoWithTheSurfaceAndNotWithTheBox)
{
  Ball small(110), large(2000);
  small.sum();
  const double surplus = large.sum() - 3. * large.n_leaves();
  // 5200 leaves have their centre within one of the surface, twice as many
  // within that and half a diagonal; and blocks down to them.
  EXPECT_LT(small.looks, 1e5);
  EXPECT_LT(large.looks, 1.5 * small.looks);
  EXPECT_GT(large.n_leaves(), 3e9);
  Ball middle(150);
  EXPECT_EQ(surplus, middle.sum_of_each() - 3. * middle.n_leaves());
}


TEST(LeafBlock, OneLeafIsLookedAtByItself)
{
  const auto never = [](const LeafBlock<1> &) -> bool {
    ADD_FAILURE() << "there is no block";
    return true;
  };
  EXPECT_EQ(
    sum_over_leaves<1>(
      {{{4}}, {{5}}}, never, 1., [](const LeafBlock<1> &) { return 7.; }),
    7.);
}
