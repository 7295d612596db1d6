// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "solid_bar.h"
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{
constexpr double half_turn = 3.14159265358979323846;

/// An elastic solid of 1000 kg/m^3 with these moduli [Pa].
Region solid_of(const double bulk, const double shear)
{
  SolidMaterial material;
  material.density = 1000.;
  material.bulk_modulus = bulk;
  material.instantaneous_shear = shear;
  Region region;
  region.law = material;
  return region;
}

/// A block of 1 x 2 m of matter with K = 2.2 GPa and G = 2.2 kPa between walls,
/// in the standing shear wave v = (sin k x cos l y, -k / l cos k x sin l y),
/// which swings with the frequency c_s sqrt(k^2 + l^2).
class SwingingBlock
{
public:
  /// @param n cells in a metre
  /// @param damping see FluidViscosity::hourglass
  SwingingBlock(const unsigned int n, const double damping, const bool skewed)
  {
    SolidBar::Options options{solid_of(2.2e9, 2.2e3), {}, {}, {}};
    options.region.viscosity = {0.06, 1.2, damping};
    if (skewed)
      options.position = [](const dealii::Point<3> &x) {
        const double way =
          0.1 * std::sin(half_turn * x[0]) * std::sin(half_turn * x[1]);
        return dealii::Point<3>(x[0] + way, x[1] - way, x[2]);
      };
    bar_ = std::make_unique<SolidBar>(
      std::vector<unsigned int>{n, 2 * n, 1}, 1., options, mode);
    energy_ = bar_->energy();
  }

  static SolidBar::Vector mode(const dealii::Point<3> &x)
  {
    return SolidBar::Vector(
      {amplitude * std::sin(k * x[0]) * std::cos(l * x[1]),
       -amplitude * k / l * std::cos(k * x[0]) * std::sin(l * x[1]),
       0.});
  }

  /// Continues to a part of the period.
  void run(const double part)
  {
    bar_->run(part * 2. * half_turn / std::sqrt(2.2 * (k * k + l * l)));
  }

  /// Parts of the velocities, 1 at the start: along the mode, and across it.
  std::pair<double, double> parts() const
  {
    const auto start = bar_->space.positions(node_width);
    double product = 0., norm = 0., square = 0.;
    for (std::size_t n = 0; n < bar_->space.n_nodes(); ++n)
    {
      const double *x = &start[node_width * n];
      const auto v = bar_->velocity(n), m = mode({x[0], x[1], x[2]});
      const double mass = 1. / bar_->state.velocity[node_width * n + 3];
      product += mass * (v * m);
      norm += mass * (m * m);
      square += mass * (v * v);
    }
    const double part = product / norm;
    return {part, std::sqrt(std::max(0., square / norm - part * part))};
  }

  /// Missing, over that at the start.
  double missing_energy() const
  {
    return bar_->energy() / energy_ - 1.;
  }

private:
  static constexpr double k = half_turn, l = 0.5 * half_turn;
  static constexpr double amplitude = 1e-5;
  std::unique_ptr<SolidBar> bar_;
  double energy_;
};
} // namespace

// Matter that is a million times stiffer against compression than against shear
// swings as fast as it should, to the dispersion of twelve cells in a wave, in
// cells of any shape and for ten thousand steps.
TEST(ExtremeSolids, SwingInShearAMillionTimesSofter)
{
  for (const bool skewed : {false, true})
  {
    SwingingBlock block(6, 0., skewed);
    block.run(0.25);
    EXPECT_NEAR(block.parts().first, 0., skewed ? 0.041 : 0.033);
    EXPECT_LT(block.parts().second, skewed ? 8.8e-3 : 3e-4);
    block.run(0.5);
    EXPECT_NEAR(block.parts().first, -1., skewed ? 3.3e-3 : 2e-3);
    EXPECT_LT(block.parts().second, skewed ? 0.0183 : 7.7e-3);
    EXPECT_NEAR(block.missing_energy(), 0., 1e-13);
  }
}

// The damper on hourglass velocities, which goes with sound, takes a quarter of
// this wave in half a period.
TEST(ExtremeSolids, AreSlowedByTheDamperOnHourglassVelocities)
{
  SwingingBlock block(6, 0.1, true);
  block.run(0.5);
  EXPECT_NEAR(block.parts().first, -0.765, 0.02);
  EXPECT_LT(block.parts().second, 0.039);
  EXPECT_NEAR(block.missing_energy(), 0., 1e-13);
}

// With K = G / 100 (Poisson's ratio -0.96) a wave of compression goes at
// sqrt((K + 4 G / 3) / rho) = 1159.02 m/s, and is back after its period.
TEST(ExtremeSolids, ReturnAHundredTimesSofterInCompression)
{
  constexpr double shear = 1e9, bulk = 1e7;
  const double speed = std::sqrt((bulk + 4. / 3. * shear) / 1000.);
  const auto wave = [](const dealii::Point<3> &x) {
    return SolidBar::Vector({1e-3 * std::sin(half_turn * x[0]), 0., 0.});
  };
  SolidBar::Options options{solid_of(bulk, shear), {}, {}, {}};
  options.region.viscosity = {0., 0., 0.1};
  SolidBar bar({16, 2, 2}, 1., options, wave);
  const double energy = bar.energy();
  bar.run(2. / speed);
  for (std::size_t n = 0; n < bar.space.n_nodes(); ++n)
    EXPECT_LT((bar.velocity(n) - wave(bar.place(n))).norm(), 1e-5);
  EXPECT_NEAR(bar.energy(), energy, 1e-13 * energy);
}
