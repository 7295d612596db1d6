// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/transfer_kernels.h>

#include "particle_case.h"
#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using namespace contrecoup::mpm;

namespace
{
using Place = dealii::Point<3>;

/// Cubes of 1 m, halved in a ball about a corner of the box, which is on
/// sides that reflect.
GridBox ball_box(const unsigned int degree)
{
  GridBox box;
  box.n_cells = {{14, 13, 12}};
  box.reflects = {{true, false, true, false, false, false}};
  box.halving.degree = degree;
  box.halving.blocks = [](const Place &lower, const double edge) {
    Place middle = lower;
    for (unsigned int d = 0; d < 3; ++d)
      middle[d] += 0.5 * edge;
    return middle.distance({0., 0., 6.}) < 5.;
  };
  return box;
}

/// Particles of any place, but three cells from sides that do not reflect.
Particles random_particles(TileGrid &grid, const unsigned int n)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<> part(0., 1.), any(-1., 1.);
  Particles particles(1);
  for (unsigned int i = 0; i < n; ++i)
  {
    const Place place(
      11. * part(random), 10. * part(random), 3. + 6. * part(random));
    ParticleBlock &block = particles.block(grid.tile_at(place), 0);
    const std::size_t p = block.append();
    for (unsigned int c = 0; c < column::n_columns; ++c)
      block[c][p] = any(random);
    for (unsigned int d = 0; d < 3; ++d)
      block[column::position + d][p] = place[d];
    block[column::mass][p] = 1. + part(random);
    block[column::volume][p] = 1. + part(random);
    block[column::dilatation][p] *= 0.1;
  }
  particles.sort(grid);
  return particles;
}

/// Calls @p work(source, block of the only material) for each tile.
template <typename Work>
void for_each_tile(const std::vector<TileGrid::Source> &sources,
                   Particles &particles,
                   const Work &work)
{
  auto source = sources.begin();
  for (auto &tile : particles.tiles())
    work(*source++, tile.second[0]);
}

/// Numbers at nodes that are mirror images where they should be.
NodeValues random_values(const TileGrid &grid, const unsigned int n)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<> any(-1., 1.);
  NodeValues values(n);
  values.clear(grid);
  for (unsigned int c = 0; c < n; ++c)
    for (std::size_t i = 0; i < grid.n_locally_owned_nodes(); ++i)
      values[c][i] = any(random);
  for (unsigned int d = 0; d < 3; ++d)
    for (const std::uint32_t node : grid.plane_nodes()[d])
      for (unsigned int c = d; c < n; c += 3)
        values[c][node] = 0.;
  return values;
}

double sum_of(const dealii::AlignedVector<double> &values)
{
  double sum = 0.;
  for (const double value : values)
    sum += value;
  return sum;
}

/// Power of stresses and moments at a particle.
double power(const ParticleBlock &block, const std::size_t p)
{
  constexpr unsigned int entry[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  double sum = 0.;
  const double smoothed =
    (1. + block[column::dilatation][p]) * block[column::smoothed][p];
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int e = 0; e < 3; ++e)
      sum -=
        block[column::mean_rate + 3 * d + e][p] *
        (block[column::volume][p] *
           (block[column::stress + entry[d][e]][p] - (d == e ? smoothed : 0.)) -
         block[column::moment + entry[d][e]][p]);
  return sum;
}
} // namespace

TEST(GridLevels, hold_all_particles_and_tiles_of_both_levels)
{
  TileGrid grid;
  grid.reinit(ball_box(3), MPI_COMM_SELF, {});
  Particles particles = random_particles(grid, 4000);
  EXPECT_EQ(particles.size(), 4000u);
  std::array<std::size_t, 2> n{};
  std::size_t n_border = 0;
  for_each_tile(
    grid.sources(), particles, [&](const auto &source, auto &block) {
      n[source.level] += block.size();
      n_border += source.coarse != nullptr;
      const WindowGeometry place = window_geometry(grid, source);
      EXPECT_EQ(place.cell_size, source.level == 0 ? 1. : 0.5);
      for (std::size_t p = 0; p < block.size(); ++p)
        for (unsigned int d = 0; d < 3; ++d)
        {
          const double way = block[column::position + d][p] - place.lower[d];
          EXPECT_GE(way, 0.);
          EXPECT_LT(way, 4. * place.cell_size);
        }
    });
  EXPECT_GT(n[0], 1000u);
  EXPECT_GT(n[1], 400u);
  EXPECT_GT(n_border, 10u);
}

// Splines are 1 together, also their sums at the border, and linear functions
// of the nodes' places are linear functions at the particles.
TEST(GridLevels, reproduce_linear_functions)
{
  for (const unsigned int degree : {1u, 3u})
  {
    TileGrid grid;
    grid.reinit(ball_box(degree), MPI_COMM_SELF, {});
    Particles particles = random_particles(grid, 4000);
    // Odd in mirrors: x, y; even: 1, z.
    const auto linear = [](const Place &x, const unsigned int c) {
      return c == 2 ? 1. - 0.3 * x[2] : (0.4 + c) * x[c];
    };
    NodeValues values(3);
    values.clear(grid);
    for (unsigned int c = 0; c < 3; ++c)
      for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
        values[c][n] = linear(grid.place(n), c);
    Window window(3 * window_stride);
    double error = 0.;
    for_each_tile(
      grid.sources(), particles, [&](const auto &source, auto &block) {
        const WindowGeometry place = window_geometry(grid, source);
        read_window(source, values, 0, {1, 2, 4}, window.data());
        collect_rate(degree, window.data(), place, block);
        for (std::size_t p = 0; p < block.size(); ++p)
          for (unsigned int k = 0; k < 9; ++k)
          {
            const double expected = k == 0   ? 0.4
                                    : k == 4 ? 1.4
                                    : k == 8 ? -0.3
                                             : 0.;
            error = std::max(
              error,
              std::abs(block[column::velocity_gradient + k][p] - expected));
          }
        Window motion(6 * window_stride);
        std::copy_n(window.data(), 3 * window_stride, motion.data());
        collect_motion(degree, 1., motion.data(), place, block);
        for (std::size_t p = 0; p < block.size(); ++p)
          for (unsigned int c = 0; c < 3; ++c)
            error = std::max(error,
                             std::abs(block[column::velocity_change + c][p] -
                                      linear({block[column::position][p],
                                              block[column::position + 1][p],
                                              block[column::position + 2][p]},
                                             c)));
      });
    EXPECT_LT(error, 1e-13) << degree;
  }
}

// Whatever the nodes have, motion and its gradient are the same on both sides
// of the border.
TEST(GridLevels, cubic_splines_are_smooth_at_the_border)
{
  TileGrid grid;
  grid.reinit(ball_box(3), MPI_COMM_SELF, {});
  std::mt19937 random(3);
  std::uniform_real_distribution<> part(0., 1.);
  Particles particles(1);
  std::size_t n = 0;
  for (unsigned int i = 0; i < 3000; ++i)
  {
    // On sides of blocks.
    Place place(8. * part(random), 8. * part(random), 3. + 6. * part(random));
    const unsigned int d = i % 3;
    place[d] = 2. * std::round(0.5 * place[d]);
    std::array<Place, 2> sides{{place, place}};
    sides[0][d] -= 1e-10;
    sides[1][d] += 1e-10;
    if (sides[0][d] < 0. || grid.level_at(sides[0]) == grid.level_at(sides[1]))
      continue;
    for (const Place &side : sides)
    {
      ParticleBlock &block = particles.block(grid.tile_at(side), 0);
      const std::size_t p = block.append();
      for (unsigned int e = 0; e < 3; ++e)
        block[column::position + e][p] = side[e];
      block[column::probe][p] = n;
    }
    ++n;
  }
  ASSERT_GT(n, 100u);
  particles.sort(grid);
  const NodeValues motion = random_values(grid, 6);
  std::vector<std::array<double, 12>> found(n);
  double largest = 0.;
  Window window(6 * window_stride);
  for_each_tile(
    grid.sources(), particles, [&](const auto &source, auto &block) {
      read_window(source, motion, 0, {1, 2, 4, 1, 2, 4}, window.data());
      collect_motion(
        3, 1., window.data(), window_geometry(grid, source), block);
      for (std::size_t p = 0; p < block.size(); ++p)
        for (unsigned int k = 0; k < 12; ++k)
        {
          const double value = k < 3 ? block[column::velocity_change + k][p]
                                     : block[column::mean_rate + k - 3][p];
          largest = std::max(largest, std::abs(value));
          // One side comes with the other sign.
          found[std::size_t(block[column::probe][p])][k] +=
            source.level == 0 ? value : -value;
        }
    });
  EXPECT_GT(largest, 0.3);
  for (const auto &difference : found)
    for (const double value : difference)
      EXPECT_NEAR(value, 0., 1e-8);
}

// Mass, force along a mirror, and work of stresses and forces: what is given
// to the nodes is what the particles have.
TEST(GridLevels, deposits_keep_sums_and_are_adjoint)
{
  for (const unsigned int degree : {1u, 3u})
  {
    TileGrid grid;
    grid.reinit(ball_box(degree), MPI_COMM_SELF, {});
    Particles particles = random_particles(grid, 4000);
    const NodeValues motion = random_values(grid, 6);
    NodeValues matter(7);
    matter.clear(grid);
    Window window(7 * window_stride);
    double mass = 0., momentum = 0., work = 0., of_momentum = 0.;
    for_each_tile(
      grid.sources(), particles, [&](const auto &source, auto &block) {
        const WindowGeometry place = window_geometry(grid, source);
        window.fill(0.);
        deposit(
          degree, Deposit::momentum_force, false, block, place, window.data());
        add_window(source, window.data(), 0, {0, 1, 2, 4, 1, 2, 4}, matter);
        read_window(source, motion, 0, {1, 2, 4, 1, 2, 4}, window.data());
        collect_motion(degree, 0.01, window.data(), place, block);
        for (std::size_t p = 0; p < block.size(); ++p)
        {
          mass += block[column::mass][p];
          momentum += block[column::mass][p] * block[column::velocity + 2][p];
          work += power(block, p);
          for (unsigned int d = 0; d < 3; ++d)
          {
            const double change = block[column::velocity_change + d][p];
            work +=
              block[column::force + d][p] *
              (block[column::position_change + d][p] / 0.01 - 0.5 * change);
            of_momentum += block[column::mass][p] *
                           block[column::velocity + d][p] * change / 0.01;
          }
        }
      });
    EXPECT_NEAR(sum_of(matter[0]), mass, 1e-13 * mass);
    EXPECT_NEAR(sum_of(matter[3]), momentum, 1e-13 * mass);
    double of_forces = 0., of_momenta = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
      {
        of_forces += matter[4 + d][n] * motion[3 + d][n];
        of_momenta += matter[1 + d][n] * motion[d][n];
      }
    EXPECT_NEAR(of_forces, work, 1e-13 * mass);
    EXPECT_NEAR(of_momenta, of_momentum, 1e-13 * mass);
    // No node has a negative share.
    for (const double value : matter[0])
      EXPECT_GE(value, 0.);
  }
}

// Hats of the smoothing, whatever the degree of the other splines.
TEST(GridLevels, smoothing_keeps_sums_and_constants)
{
  TileGrid grid;
  grid.reinit(ball_box(3), MPI_COMM_SELF, {});
  Particles particles = random_particles(grid, 4000);
  NodeValues sums(2);
  sums.clear(grid);
  Window window(2 * window_stride);
  double weights = 0., values = 0.;
  for_each_tile(
    grid.linear_sources(), particles, [&](const auto &source, auto &block) {
      window.fill(0.);
      deposit_scalar(block,
                     block[column::mass],
                     block[column::energy],
                     window_geometry(grid, source),
                     window.data());
      add_window(source, window.data(), 0, {0, 0}, sums);
      for (std::size_t p = 0; p < block.size(); ++p)
      {
        weights += block[column::mass][p];
        values += block[column::mass][p] * block[column::energy][p];
      }
    });
  EXPECT_NEAR(sum_of(sums[0]), weights, 1e-13 * weights);
  EXPECT_NEAR(sum_of(sums[1]), values, 1e-13 * weights);
  NodeValues height(1);
  height.clear(grid);
  for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
    height[0][n] = grid.place(n)[2];
  for_each_tile(
    grid.linear_sources(), particles, [&](const auto &source, auto &block) {
      read_window(source, height, 0, {0}, window.data());
      collect_scalar(window.data(),
                     window_geometry(grid, source),
                     block,
                     block[column::smoothed]);
      for (std::size_t p = 0; p < block.size(); ++p)
        EXPECT_NEAR(
          block[column::smoothed][p], block[column::position + 2][p], 1e-13);
    });
}

namespace
{
/// Passage of a pulse along a bar over the border of levels.
struct Passage
{
  double speed;     ///< of the middle of its energy, over that of theory
  double reflected; ///< part of its energy that runs back
  double kept;      ///< all energy over that of the start
};

/// @param to_whole whether it runs from halved cells of 1/2 m to those of 1 m
/// @param width of the pulse: its velocity is exp(-(x / width)^2) [m]
Passage passing_pulse(const unsigned int degree,
                      const bool to_whole,
                      const double width)
{
  const double border = 48., first = 28., way = 40., amplitude = 1e-5;
  GridBox box;
  box.n_cells = {{96, 1, 1}};
  box.reflects.fill(true);
  box.halving.degree = degree;
  box.halving.blocks = [=](const Place &lower, double) {
    return (lower[0] < border) == to_whole;
  };
  ParticleMaterial bar = elastic(1., 0., 1.); // 1 m/s
  bar.kinematics = SolidKinematics::small_strain;
  TransferScheme scheme;
  scheme.degree = degree;
  scheme.series_order = 2;
  ParticleCase one(box, scheme, {bar}, MPI_COMM_SELF);
  one.fill(
    [](const auto &) { return 0; },
    [&](const auto &x) {
      const double part = (x[0] - first) / width;
      return dealii::Tensor<1, 3>({amplitude * std::exp(-part * part), 0., 0.});
    },
    {{2, 1, 1}});
  one.particles.for_each_block([](unsigned int, ParticleBlock &block) {
    for (std::size_t p = 0; p < block.size(); ++p)
      block[column::gradient][p] = -block[column::velocity][p];
  });
  one.step.start(one.grid, one.particles);
  // Energy that runs on, its moment, and energy that runs back.
  const auto sums = [&]() {
    std::array<double, 3> result{};
    one.particles.for_each_block([&](unsigned int, const ParticleBlock &block) {
      for (std::size_t p = 0; p < block.size(); ++p)
      {
        const double v = block[column::velocity][p],
                     strain = block[column::gradient][p],
                     mass = block[column::mass][p];
        const double on = 0.25 * mass * (v - strain) * (v - strain);
        result[0] += on;
        result[1] += on * block[column::position][p];
        result[2] += 0.25 * mass * (v + strain) * (v + strain);
      }
    });
    return result;
  };
  const auto start = sums();
  one.run(way, 0.2);
  const auto end = sums();
  return {(end[1] / end[0] - start[1] / start[0]) / way,
          end[2] / start[0],
          (end[0] + end[2]) / start[0]};
}
} // namespace

// A pulse of 8 whole cells at half its height loses 0.3 % of its energy to one
// that runs back, one of 4 up to 2 % from halved cells to whole ones, where it
// is slow, too. All energy stays.
TEST(GridLevels, pulses_pass_the_border)
{
  struct Case
  {
    unsigned int degree;
    double width, speed_error, reflected;
  };
  for (const Case &one : {Case{1, 4.8, 0.0039, 0.00098},
                          Case{1, 2.4, 0.01, 0.0042},
                          Case{3, 4.8, 0.0033, 0.0031},
                          Case{3, 2.4, 0.036, 0.0235}})
    for (const bool to_whole : {false, true})
    {
      SCOPED_TRACE(std::to_string(one.degree) + " " +
                   std::to_string(one.width));
      const Passage pulse = passing_pulse(one.degree, to_whole, one.width);
      EXPECT_NEAR(pulse.speed, 1., one.speed_error);
      EXPECT_LT(pulse.reflected, one.reflected);
      EXPECT_NEAR(pulse.kept, 1., 5.5e-4);
    }
}
