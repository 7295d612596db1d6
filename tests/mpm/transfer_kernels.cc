// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/transfer_kernels.h>
#include <contrecoup/numerics/element/spline_weights.h>

#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using namespace contrecoup::mpm;

namespace
{
constexpr unsigned int stride = window_stride;
const WindowGeometry place{{{-0.3, 0.2, 1.}}, 0.5};

/// Particles anywhere in a tile, also on its lower sides, with any state.
ParticleBlock random_particles(const unsigned int n)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<> any(-1., 1.), in_tile(0., 4.),
    positive(0.5, 1.5);
  ParticleBlock block;
  for (unsigned int i = 0; i < n; ++i)
  {
    const std::size_t p = block.append();
    for (unsigned int c = 0; c < column::n_columns; ++c)
      block[c][p] = any(random);
    for (unsigned int d = 0; d < 3; ++d)
      block[column::position + d][p] =
        place.lower[d] + place.cell_size * (i < 3 ? i : in_tile(random));
    block[column::mass][p] = positive(random);
    block[column::volume][p] = positive(random);
    block[column::dilatation][p] *= 0.1;
  }
  return block;
}

Window random_window(const unsigned int n_components)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<> any(-1., 1.);
  Window window(n_components * stride);
  for (double &value : window)
    value = any(random);
  return window;
}

SplineWeights weights(const unsigned int degree, const double x)
{
  return degree == 1   ? spline_weights<1>(x)
         : degree == 2 ? spline_weights<2>(x)
                       : spline_weights<3>(x);
}

/// A node of a window that a particle reaches.
struct Node
{
  unsigned int at;
  double value;
  std::array<double, 3> slope, place;
};

std::vector<Node> nodes_of(const unsigned int degree,
                           const ParticleBlock &block,
                           const std::size_t p)
{
  std::array<SplineWeights, 3> w;
  for (unsigned int d = 0; d < 3; ++d)
    w[d] = weights(degree,
                   (block[column::position + d][p] - place.lower[d]) /
                     place.cell_size);
  std::vector<Node> nodes;
  for (unsigned int k = 0; k <= degree; ++k)
    for (unsigned int j = 0; j <= degree; ++j)
      for (unsigned int i = 0; i <= degree; ++i)
      {
        const unsigned int index[] = {i, j, k};
        Node node{0, 1., {{1., 1., 1.}}, {}};
        for (int d = 2; d >= 0; --d)
        {
          const int n = w[d].first + int(index[d]);
          node.at = 8 * node.at + (n - TileGrid::window_start);
          node.place[d] = place.lower[d] + place.cell_size * n;
          node.value *= w[d].value[index[d]];
          for (int e = 0; e < 3; ++e)
            node.slope[e] *= e == d ? w[d].slope[index[d]] / place.cell_size
                                    : w[d].value[index[d]];
        }
        nodes.push_back(node);
      }
  return nodes;
}

/// Volume times the stress that resists strains, less moments from outside.
double stress(const ParticleBlock &block,
              const std::size_t p,
              const unsigned int d,
              const unsigned int e)
{
  constexpr unsigned int entry[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  const double smoothed =
    (1. + block[column::dilatation][p]) * block[column::smoothed][p];
  return block[column::volume][p] *
           (block[column::stress + entry[d][e]][p] - (d == e ? smoothed : 0.)) -
         block[column::moment + entry[d][e]][p];
}

/// Mass, momentum and force by plain loops.
Window plain_deposit(const unsigned int degree,
                     const bool affine,
                     const ParticleBlock &block)
{
  Window window(7 * stride);
  for (std::size_t p = 0; p < block.size(); ++p)
    for (const Node &node : nodes_of(degree, block, p))
    {
      const double mass = block[column::mass][p] * node.value;
      window[node.at] += mass;
      for (unsigned int d = 0; d < 3; ++d)
      {
        double velocity = block[column::velocity + d][p];
        double force = block[column::force + d][p] * node.value;
        for (unsigned int e = 0; e < 3; ++e)
        {
          if (affine)
            velocity += block[column::affine + 3 * d + e][p] *
                        (node.place[e] - block[column::position + e][p]);
          force -= stress(block, p, d, e) * node.slope[e];
        }
        window[stride * (1 + d) + node.at] += mass * velocity;
        window[stride * (4 + d) + node.at] += force;
      }
    }
  return window;
}

/// A linear function of the nodes' places: component d has the value
/// b_d + A_d . x.
constexpr double slope[3][3] = {{0.3, -0.2, 0.7},
                                {0.1, 0.5, -0.4},
                                {-0.6, 0.2, 0.1}};
double linear(const unsigned int d, const std::array<double, 3> &x)
{
  return 0.4 - d + slope[d][0] * x[0] + slope[d][1] * x[1] + slope[d][2] * x[2];
}

Window linear_window()
{
  Window window(3 * stride);
  for (unsigned int d = 0; d < 3; ++d)
    for (int k = 0; k < 8; ++k)
      for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i)
        {
          const int index[] = {i, j, k};
          std::array<double, 3> x;
          for (unsigned int e = 0; e < 3; ++e)
            x[e] = place.lower[e] +
                   place.cell_size * (index[e] + TileGrid::window_start);
          window[stride * d + i + 8 * (j + 8 * k)] = linear(d, x);
        }
  return window;
}

/// Sum over the nodes of the window of the product of components.
double product(const Window &a,
               const unsigned int first_a,
               const Window &b,
               const unsigned int first_b,
               const unsigned int n)
{
  double sum = 0.;
  for (unsigned int c = 0; c < n; ++c)
    for (unsigned int i = 0; i < TileGrid::window_size; ++i)
      sum += a[stride * (first_a + c) + i] * b[stride * (first_b + c) + i];
  return sum;
}
} // namespace

TEST(TransferKernels, deposit_what_plain_loops_do)
{
  // All numbers of particles that a batch may be left with.
  for (unsigned int degree = 1; degree <= 3; ++degree)
    for (unsigned int n = 1; n <= 17; ++n)
      for (const bool affine : {false, true})
        for (const Deposit what :
             {Deposit::momentum, Deposit::momentum_force, Deposit::force})
        {
          if (affine && degree == 1)
            continue;
          const ParticleBlock block = random_particles(n);
          const Window expected = plain_deposit(degree, affine, block);
          Window window(7 * stride);
          deposit(degree, what, affine, block, place, window.data());
          const unsigned int first = what == Deposit::force ? 4 : 0;
          const unsigned int last = what == Deposit::momentum ? 4 : 7;
          double error = 0.;
          for (unsigned int c = first; c < last; ++c)
            for (unsigned int i = 0; i < TileGrid::window_size; ++i)
              error = std::max(error,
                               std::abs(window[stride * (c - first) + i] -
                                        expected[stride * c + i]));
          EXPECT_LT(error, 2e-13) << degree << " " << n << " " << affine << " "
                                  << static_cast<int>(what);
        }
}

TEST(TransferKernels, deposit_all_mass_and_momentum)
{
  const ParticleBlock block = random_particles(100);
  std::array<double, 4> expected{};
  for (std::size_t p = 0; p < block.size(); ++p)
  {
    expected[0] += block[column::mass][p];
    for (unsigned int d = 0; d < 3; ++d)
      expected[1 + d] +=
        block[column::mass][p] * block[column::velocity + d][p];
  }
  for (unsigned int degree = 1; degree <= 3; ++degree)
    for (const bool affine : {false, true})
    {
      Window window(4 * stride);
      deposit(degree, Deposit::momentum, affine, block, place, window.data());
      for (unsigned int c = 0; c < 4; ++c)
      {
        double sum = 0.;
        for (unsigned int i = 0; i < TileGrid::window_size; ++i)
          sum += window[stride * c + i];
        EXPECT_NEAR(sum, expected[c], 1e-13 * expected[0]);
      }
      if (degree == 1)
        break;
    }
}

// Linear splines: a particle on a side, an edge or a node of cells gives all to
// their lowest node, but for a trace, and has the slopes of the cell above.
TEST(TransferKernels, particles_on_sides_belong_to_the_cells_above)
{
  const WindowGeometry even{{{0.25, -0.5, 1.}}, 0.5};
  ParticleBlock block;
  std::vector<std::array<int, 3>> cells;
  for (int i = 0; i < 64; ++i)
  {
    cells.push_back({{i % 4, i / 4 % 4, i / 16}});
    const std::size_t p = block.append();
    for (unsigned int d = 0; d < 3; ++d)
      block[column::position + d][p] =
        even.lower[d] + even.cell_size * cells.back()[d];
    block[column::mass][p] = 1.;
  }
  // Component d grows with the square of the node's number along d.
  Window mass(4 * stride), velocity(3 * stride);
  deposit(1, Deposit::momentum, false, block, even, mass.data());
  double sum = 0.;
  for (unsigned int i = 0; i < TileGrid::window_size; ++i)
  {
    bool is_inside = true;
    const unsigned int index[] = {i % 8, i / 8 % 8, i / 64};
    for (unsigned int d = 0; d < 3; ++d)
    {
      const int node = int(index[d]) + TileGrid::window_start;
      is_inside = is_inside && node >= 0 && node < TileGrid::tile_edge;
      velocity[stride * d + i] = node * node;
    }
    EXPECT_NEAR(mass[i], is_inside ? 1. : 0., 1e-17);
    sum += mass[i];
  }
  EXPECT_EQ(sum, 64.);
  collect_rate(1, velocity.data(), even, block);
  for (std::size_t p = 0; p < block.size(); ++p)
    for (unsigned int k = 0; k < 9; ++k)
      EXPECT_NEAR(block[column::velocity_gradient + k][p],
                  k % 4 == 0 ? (2 * cells[p][k / 4] + 1) / even.cell_size : 0.,
                  1e-14);
}

// Stresses do the same work on the nodes as in the particles, and forces
// from outside work on the nodes as on the particles.
TEST(TransferKernels, deposit_and_collect_are_adjoint)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    ParticleBlock block = random_particles(61);
    const Window motion = random_window(6); // acceleration, mean velocity
    Window deposits(7 * stride);
    deposit(
      degree, Deposit::momentum_force, false, block, place, deposits.data());
    const double step = 0.01;
    collect_motion(degree, step, motion.data(), place, block);
    double power = 0., of_momentum = 0.;
    for (std::size_t p = 0; p < block.size(); ++p)
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double change = block[column::velocity_change + d][p];
        const double mean =
          block[column::position_change + d][p] / step - 0.5 * change;
        power += block[column::force + d][p] * mean;
        of_momentum += block[column::mass][p] * block[column::velocity + d][p] *
                       change / step;
        for (unsigned int e = 0; e < 3; ++e)
          power -=
            stress(block, p, d, e) * block[column::mean_rate + 3 * d + e][p];
      }
    EXPECT_NEAR(product(deposits, 4, motion, 3, 3), power, 2e-13 * 61);
    EXPECT_NEAR(product(deposits, 1, motion, 0, 3), of_momentum, 2e-13 * 61);
  }
}

TEST(TransferKernels, collect_linear_velocities_exactly)
{
  const Window velocity = linear_window();
  Window motion(6 * stride); // acceleration: minus it; mean velocity: twice it
  for (unsigned int i = 0; i < 3 * stride; ++i)
  {
    motion[i] = -velocity[i];
    motion[3 * stride + i] = 2. * velocity[i];
  }
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    ParticleBlock block = random_particles(29);
    const double step = 0.5;
    collect_motion(degree, step, motion.data(), place, block);
    collect_rate(degree, velocity.data(), place, block);
    if (degree > 1)
      collect_affine(degree, velocity.data(), place, block);
    for (std::size_t p = 0; p < block.size(); ++p)
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double v = linear(d,
                                {{block[column::position][p],
                                  block[column::position + 1][p],
                                  block[column::position + 2][p]}});
        EXPECT_NEAR(block[column::velocity_change + d][p], -step * v, 2e-14);
        EXPECT_NEAR(block[column::position_change + d][p],
                    step * (2. - 0.5 * step) * v,
                    2e-14);
        for (unsigned int e = 0; e < 3; ++e)
        {
          const unsigned int k = 3 * d + e;
          EXPECT_NEAR(
            block[column::velocity_gradient + k][p], slope[d][e], 1e-13);
          EXPECT_NEAR(block[column::mean_rate + k][p], 2. * slope[d][e], 1e-13);
          if (degree > 1)
          {
            EXPECT_NEAR(block[column::affine + k][p], slope[d][e], 1e-13);
          }
        }
      }
  }
}

TEST(TransferKernels, mass_matrix_is_symmetric_and_its_rows_are_lumped_masses)
{
  const ParticleBlock block = random_particles(45);
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    Window mass(4 * stride);
    deposit(degree, Deposit::momentum, false, block, place, mass.data());
    Window ones(3 * stride), a = random_window(3), b(3 * stride);
    ones.fill(1.);
    for (unsigned int i = 0; i < 3 * stride; ++i)
      b[i] = std::sin(double(i));
    const auto times = [&](const Window &from) {
      Window to(3 * stride);
      multiply_mass(degree, 1, block, place, from.data(), to.data());
      return to;
    };
    const Window of_ones = times(ones), of_a = times(a), of_b = times(b);
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int i = 0; i < TileGrid::window_size; ++i)
        ASSERT_NEAR(of_ones[stride * c + i], mass[i], 1e-13);
    EXPECT_NEAR(product(of_a, 0, b, 0, 3), product(of_b, 0, a, 0, 3), 1e-12);
    EXPECT_GT(product(of_a, 0, a, 0, 3), 0.);
    EXPECT_LT(product(of_a, 0, a, 0, 3), product(mass, 0, ones, 0, 1) * 3.);
  }
}

TEST(TransferKernels, scalars_are_kept_and_read_back)
{
  const ParticleBlock block = random_particles(31);
  std::vector<double> weight(block.size()), value(block.size()),
    back(block.size());
  double sum = 0., weights_sum = 0.;
  for (std::size_t p = 0; p < block.size(); ++p)
  {
    weight[p] = block[column::mass][p];
    value[p] = block[column::velocity][p];
    sum += weight[p] * value[p];
    weights_sum += weight[p];
  }
  Window window(2 * stride);
  deposit_scalar(block, weight.data(), value.data(), place, window.data());
  double sums[2] = {};
  for (unsigned int i = 0; i < TileGrid::window_size; ++i)
  {
    sums[0] += window[i];
    sums[1] += window[stride + i];
  }
  EXPECT_NEAR(sums[0], weights_sum, 1e-13 * weights_sum);
  EXPECT_NEAR(sums[1], sum, 1e-13 * weights_sum);
  // Reading is the adjoint of adding: weights are the same.
  const Window nodes = random_window(1);
  collect_scalar(nodes.data(), place, block, back.data());
  double expected = 0.;
  for (std::size_t p = 0; p < block.size(); ++p)
    expected += weight[p] * value[p] * back[p];
  EXPECT_NEAR(product(window, 1, nodes, 0, 1), expected, 1e-13 * weights_sum);
  const Window velocity = linear_window();
  collect_scalar(velocity.data(), place, block, back.data());
  for (std::size_t p = 0; p < block.size(); ++p)
    EXPECT_NEAR(back[p],
                linear(0,
                       {{block[column::position][p],
                         block[column::position + 1][p],
                         block[column::position + 2][p]}}),
                1e-14);
}
