// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/particle_block.h>
#include <contrecoup/mpm/particle_motion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace contrecoup::mpm;

namespace
{
/// A number for a column of the particle with a tag.
double value(const unsigned int tag, const unsigned int column)
{
  return 1000. * tag + column;
}

ParticleBlock tagged(const unsigned int n)
{
  ParticleBlock block;
  for (unsigned int tag = 0; tag < n; ++tag)
  {
    const std::size_t p = block.append();
    EXPECT_EQ(p, tag);
    for (unsigned int c = 0; c < column::n_columns; ++c)
    {
      EXPECT_EQ(block[c][p], 0.);
      block[c][p] = value(tag, c);
    }
  }
  return block;
}

void expect_particle(const ParticleBlock &block,
                     const std::size_t p,
                     const unsigned int tag,
                     const unsigned int n_columns = column::n_columns)
{
  for (unsigned int c = 0; c < n_columns; ++c)
    ASSERT_EQ(block[c][p], value(tag, c));
}
} // namespace

TEST(ParticleBlock, keeps_particles_while_it_grows)
{
  const ParticleBlock block = tagged(1000);
  ASSERT_EQ(block.size(), 1000u);
  for (unsigned int tag = 0; tag < 1000; ++tag)
    expect_particle(block, tag, tag);
  // Lanes may read and write on from the last particle.
  EXPECT_GE(block[1] - block[0],
            static_cast<std::ptrdiff_t>(1000 - 1 + ParticleBlock::padding));
}

TEST(ParticleBlock, the_last_takes_the_place_of_what_is_removed)
{
  ParticleBlock block = tagged(4);
  block.remove(1);
  ASSERT_EQ(block.size(), 3u);
  expect_particle(block, 0, 0);
  expect_particle(block, 1, 3);
  expect_particle(block, 2, 2);
  block.remove(2);
  block.remove(0);
  block.remove(0);
  EXPECT_EQ(block.size(), 0u);
  EXPECT_EQ(block.append(), 0u);
  EXPECT_EQ(block[column::mass][0], 0.);
}

TEST(ParticleBlock, copies_particles_and_their_states)
{
  const ParticleBlock from = tagged(3);
  ParticleBlock to = tagged(1);
  to.append(from, 2);
  expect_particle(to, 1, 2);
  double state[column::n_state_columns];
  from.copy_state(1, state);
  to.append(state);
  expect_particle(to, 2, 1, column::n_state_columns);
  for (unsigned int c = column::n_state_columns; c < column::n_columns; ++c)
    EXPECT_EQ(to[c][2], 0.);
}

TEST(ParticleMotion, finds_the_largest_rate_and_what_is_not_finite)
{
  for (unsigned int n = 1; n < 20; ++n)
  {
    ParticleBlock block;
    for (unsigned int p = 0; p < n; ++p)
      block.append();
    EXPECT_EQ(largest_rate(block), 0.);
    block[column::mean_rate + n % 9][n - 1] = -3.;
    EXPECT_EQ(largest_rate(block), 3.);
    block[column::mean_rate + (n + 4) % 9][n / 2] =
      std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isinf(largest_rate(block)));
  }
}
