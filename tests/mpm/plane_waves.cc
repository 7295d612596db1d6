// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/spline_dispersion.h>

#include "particle_case.h"
#include "sign_changes.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::mpm;

namespace
{
/// Standing waves of water in a box of mirrors after some periods.
struct Wave
{
  double speed;  ///< over that of sound
  double energy; ///< mean of the last period, over that of the start
};

/**
 * One half wave along each direction of the box.
 * @param n_cells of the box along x and y; 1: the wave does not go that way
 */
Wave standing_wave(const TransferScheme &scheme,
                   const std::array<unsigned int, 2> &n_cells,
                   const double n_periods,
                   const double courant)
{
  const double amplitude = 0.1, sound_speed = std::sqrt(2.2e6);
  GridBox box;
  box.n_cells = {{n_cells[0], n_cells[1], 1}};
  box.reflects.fill(true);
  ParticleMaterial water;
  water.name = "water";
  water.law = Tait(1000., 2.2e9);
  ParticleCase one(box, scheme, {water}, MPI_COMM_SELF);
  const bool is_plane = n_cells[1] == 1;
  const double k_x = dealii::numbers::PI / n_cells[0],
               k_y = is_plane ? 0. : dealii::numbers::PI / n_cells[1],
               k = std::hypot(k_x, k_y),
               period = 2. * dealii::numbers::PI / (k * sound_speed);
  const auto mode = [&](const double x, const double y) {
    dealii::Tensor<1, 3> v;
    v[0] = k_x / k * std::sin(k_x * x) * std::cos(k_y * y);
    v[1] = k_y / k * std::cos(k_x * x) * std::sin(k_y * y);
    return v;
  };
  one.fill([](const auto &) { return 0; },
           [&](const auto &x) { return amplitude * mode(x[0], x[1]); },
           {{2, is_plane ? 1u : 2u, 1}});
  const auto part_of_mode = [&]() {
    return one.sum([&](const ParticleBlock &block, const std::size_t p) {
      const auto v =
        mode(block[column::position][p], block[column::position + 1][p]);
      return v[0] * block[column::velocity][p] +
             v[1] * block[column::velocity + 1][p];
    });
  };
  const double start = one.totals().kinetic_energy;
  SignChanges changes(part_of_mode());
  double sum = 0.;
  unsigned int n_samples = 0;
  one.run(n_periods * period, courant, [&]() {
    changes.add(one.time, part_of_mode());
    if (one.time > (n_periods - 1.) * period)
    {
      const auto totals = one.totals();
      sum += (totals.kinetic_energy + totals.stored_energy) / start;
      ++n_samples;
    }
  });
  const auto &times = changes.times;
  return {0.5 * (times.size() - 1) * period / (times.back() - times.front()),
          sum / n_samples};
}
} // namespace

// Waves of 16 and 8 cells are as slow as theory says, and so much the less as
// the series is longer; what MUSL gains or loses is a staggering by half a
// step.
TEST(PlaneWaves, have_the_speed_of_theory)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
    for (const unsigned int n_terms : {1u, 2u, 4u})
      for (const unsigned int n : {8u, 16u})
      {
        SCOPED_TRACE(std::to_string(degree) + " " + std::to_string(n_terms) +
                     " " + std::to_string(n));
        TransferScheme scheme;
        scheme.degree = degree;
        scheme.series_order = n_terms;
        const Wave wave = standing_wave(scheme, {{n / 2, 1}}, 5., 0.2);
        EXPECT_NEAR(wave.speed,
                    SplineDispersion(degree).speed(n, n_terms),
                    n == 8 ? 0.01 : 0.003);
        EXPECT_NEAR(wave.energy, 1., n == 8 ? 0.02 : 0.005);
      }
}

// At 30 degrees to the grid: 16 cells in a wave.
TEST(PlaneWaves, are_as_fast_aslant)
{
  TransferScheme scheme;
  EXPECT_NEAR(standing_wave(scheme, {{9, 16}}, 5., 0.2).speed, 0.948, 0.003);
  scheme.series_order = 2;
  EXPECT_NEAR(standing_wave(scheme, {{9, 16}}, 5., 0.2).speed, 0.998, 0.003);
  scheme.series_order = 4;
  const Wave wave = standing_wave(scheme, {{9, 16}}, 5., 0.2);
  EXPECT_NEAR(wave.speed, 1., 0.002);
  EXPECT_NEAR(wave.energy, 1., 0.005);
}

// FLIP with MUSL loses no more energy with shorter steps; with a series of two
// terms, the default, what is off goes with the square of the step. With USL it
// loses in proportion to steps; affine transfers lose a part in every one.
TEST(PlaneWaves, lose_less_with_shorter_steps)
{
  const auto loss = [](const Transfer transfer,
                       const StressUpdate update,
                       const double courant,
                       const unsigned int series_order = 1) {
    return 1. - standing_wave(
                  {3, transfer, update, series_order}, {{8, 1}}, 5., courant)
                  .energy;
  };
  const auto flip = Transfer::flip;
  const auto musl = StressUpdate::modified_last, usl = StressUpdate::last;
  const double musl_loss = std::abs(loss(flip, musl, 0.2));
  EXPECT_LT(musl_loss, 0.005);
  EXPECT_LT(std::abs(loss(flip, musl, 0.1)), std::max(musl_loss, 0.002));
  double last = std::abs(loss(flip, musl, 0.8, 2));
  EXPECT_LT(last, 0.028);
  for (const double courant : {0.4, 0.2, 0.1, 0.05})
  {
    const double now = std::abs(loss(flip, musl, courant, 2));
    EXPECT_LT(now, 0.27 * last);
    last = now;
  }
  const double usl_loss = loss(flip, usl, 0.2);
  EXPECT_GT(usl_loss, 0.05);
  EXPECT_NEAR(loss(flip, usl, 0.1), 0.5 * usl_loss, 0.1 * usl_loss);
  EXPECT_GT(loss(Transfer::affine, musl, 0.1),
            1.3 * loss(Transfer::affine, musl, 0.2));
}
