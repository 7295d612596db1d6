// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/element/spline_weights.h>

#include "all_schemes.h"
#include "particle_case.h"
#include <gtest/gtest.h>

#include <optional>

using namespace contrecoup;
using namespace contrecoup::mpm;

namespace
{
using Vector = dealii::Tensor<1, 3>;

/// A grid of cubes of 1 m without mirrors.
GridBox box_of(const unsigned int n)
{
  GridBox box;
  box.n_cells = {{n, n, n}};
  return box;
}

/// Whether a place is in a cube around (6, 6, 6), the middle of a tile.
bool in_cube(const dealii::Point<3> &x, const double edge)
{
  for (unsigned int d = 0; d < 3; ++d)
    if (std::abs(x[d] - 6.) > 0.5 * edge)
      return false;
  return true;
}

/// Angular momentum about the z axis through a point, and kinetic energy, both
/// with their affine parts on a grid of cubes of 1 m.
std::array<double, 2> spin_and_energy(const ParticleCase &one,
                                      const unsigned int degree,
                                      const double middle)
{
  const double inertia = spline_inertia(degree);
  double spin = 0., energy = 0.;
  one.for_each_particle([&](const ParticleBlock &block, const std::size_t p) {
    const auto at = [&](const unsigned int column) { return block[column][p]; };
    const double mass = at(column::mass), x = at(column::position) - middle,
                 y = at(column::position + 1) - middle;
    spin +=
      mass * (x * at(column::velocity + 1) - y * at(column::velocity) +
              inertia * (at(column::affine + 3) - at(column::affine + 1)));
    for (unsigned int d = 0; d < 3; ++d)
      energy +=
        0.5 * mass * at(column::velocity + d) * at(column::velocity + d);
    for (unsigned int k = 0; k < 9; ++k)
      energy +=
        0.5 * mass * inertia * at(column::affine + k) * at(column::affine + k);
  });
  return {{spin, energy}};
}

/// A block that is cut by the plane x = 0, 60 steps on; or its half for x > 0,
/// the plane a side that reflects. @param interface if any, of its two parts
ParticleCase mirror_case(const TransferScheme &scheme,
                         const bool is_half,
                         const std::optional<FieldInterface> &interface = {})
{
  ParticleMaterial rubber = elastic(1e4, 0.4, 1000.);
  rubber.is_smoothed = true;
  GridBox box = box_of(8);
  if (is_half)
    box.reflects[0] = true;
  else
  {
    box.lower[0] = -8.;
    box.n_cells[0] = 16;
  }
  std::vector<ParticleMaterial> materials(interface ? 2 : 1, rubber);
  materials.back().field = interface ? 1 : 0;
  ParticleCase one(box, scheme, materials, MPI_COMM_SELF);
  if (interface)
    one.step = ParticleStep(
      scheme,
      materials,
      FieldContact(scheme.degree, {0, 1}, *interface, 0.25, 0.125, 0.1));
  one.fill(
    [&](const auto &x) {
      if (std::abs(x[0]) > 2. || std::abs(x[1] - 4.) > 1. ||
          std::abs(x[2] - 5.) > 1.)
        return -1;
      return interface && x[1] > 4.1 + 0.2 * x[0] * x[0] ? 1 : 0;
    },
    [](const auto &x) {
      Vector v;
      v[0] = 0.05 * std::sin(x[0] + 0. * x[1]) * std::cos(x[1]);
      v[1] = 0.08 * std::cos(x[0]) * std::sin(x[2]);
      v[2] = 0.05 * std::cos(2. * x[0] * x[0]);
      return v;
    });
  one.advance(0.3 * one.step.signal_time(one.grid, one.particles), 60);
  return one;
}
} // namespace

// Whatever the scheme, what stresses do and what the transfer loses is known to
// round-off, and no momentum is lost.
TEST(ParticleConservation, energies_and_momenta_over_a_thousand_steps)
{
  const double speed = 0.02;
  for (const TransferScheme &scheme : all_schemes(1, 3))
  {
    SCOPED_TRACE(scheme_name(scheme));
    ParticleMaterial rubber = elastic(1e4, 0.45, 1000.);
    rubber.is_smoothed = true;
    ParticleCase cube(box_of(8), scheme, {rubber}, MPI_COMM_SELF);
    cube.fill([](const auto &x) { return in_cube(x, 2.) ? 0 : -1; },
              [&](const auto &x) {
                Vector v;
                for (unsigned int d = 0; d < 3; ++d)
                  v[d] = speed * std::sin(2. * x[d] + x[(d + 1) % 3]);
                return v;
              });
    const auto start = cube.totals();
    cube.advance(0.1 * cube.step.signal_time(cube.grid, cube.particles), 1000);
    const auto end = cube.totals();
    EXPECT_NEAR(cube.residual(start), 0., 1e-12 * start.kinetic_energy);
    EXPECT_GT(end.stored_energy, 0.);
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(
        end.momentum[d], start.momentum[d], 1e-12 * speed * start.mass);
    EXPECT_NEAR(end.mass, start.mass, 1e-14 * start.mass);
  }
}

// A disk of two cells' radius, 100 turns at 15 % of the speed of sound.
TEST(ParticleConservation, affine_disk_keeps_spinning)
{
  TransferScheme scheme;
  scheme.transfer = Transfer::affine;
  GridBox box = box_of(8);
  box.n_cells[2] = 1;
  box.reflects = {{false, false, false, false, true, true}};
  ParticleCase disk(box, scheme, {elastic(1e6, 0.3, 1000.)}, MPI_COMM_SELF);
  const double radius = 1.9, middle = 6.;
  const double rate =
    0.15 * disk.step.materials()[0].solid()->dilatational_speed() / radius;
  disk.fill(
    [&](const auto &x) {
      return std::hypot(x[0] - middle, x[1] - middle) < radius ? 0 : -1;
    },
    [&](const auto &x) {
      Vector v;
      v[0] = -rate * (x[1] - middle);
      v[1] = rate * (x[0] - middle);
      return v;
    },
    {{2, 2, 1}});
  disk.particles.for_each_block([&](unsigned int, ParticleBlock &block) {
    std::fill_n(block[column::affine + 1], block.size(), -rate);
    std::fill_n(block[column::affine + 3], block.size(), rate);
  });
  const auto start = spin_and_energy(disk, scheme.degree, middle);
  disk.run(100. * 2. * dealii::numbers::PI / rate, 0.4);
  const auto end = spin_and_energy(disk, scheme.degree, middle);
  EXPECT_NEAR(end[0], start[0], 1e-10 * start[0]);
  EXPECT_NEAR(end[1] + disk.totals().stored_energy, start[1], 0.01 * start[1]);
}

namespace
{
/// Half a body at a side that reflects moves as one half of the whole.
void expect_mirrors(const TransferScheme &scheme,
                    const std::optional<FieldInterface> &interface = {})
{
  const ParticleCase half = mirror_case(scheme, true, interface),
                     whole = mirror_case(scheme, false, interface);
  EXPECT_NEAR(2. * half.totals().kinetic_energy,
              whole.totals().kinetic_energy,
              1e-12 * whole.totals().kinetic_energy);
  const auto states = [](const ParticleCase &one) {
    std::vector<std::array<double, column::n_state_columns>> all;
    one.for_each_particle([&](const ParticleBlock &block, const std::size_t p) {
      if (block[column::position][p] > 0.)
        block.copy_state(p, all.emplace_back().data());
    });
    return all;
  };
  const auto a = states(half), b = states(whole);
  ASSERT_EQ(a.size(), b.size());
  double largest = 0.;
  for (std::size_t p = 0; p < a.size(); ++p)
    for (unsigned int c = 0; c < 6; ++c)
      largest = std::max(largest, std::abs(a[p][c] - b[p][c]));
  EXPECT_LT(largest, 1e-12);
}
} // namespace

TEST(ParticleConservation, sides_that_reflect_are_mirrors)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
    for (const auto transfer : {Transfer::flip, Transfer::affine})
    {
      TransferScheme scheme{degree, transfer, StressUpdate::modified_last, 1};
      if (transfer == Transfer::affine && degree == 1)
        continue;
      if (transfer == Transfer::flip)
        scheme.series_order = 2;
      SCOPED_TRACE(scheme_name(scheme));
      expect_mirrors(scheme);
    }
}

// So do two parts that slide or rub along an interface which is curved there.
TEST(ParticleConservation, sides_that_reflect_mirror_velocity_fields)
{
  for (const auto interface : {FieldInterface::slip, FieldInterface::contact})
  {
    SCOPED_TRACE(field_interfaces[static_cast<int>(interface)].name);
    expect_mirrors({3, Transfer::flip, StressUpdate::modified_last, 2},
                   interface);
  }
}

namespace
{
/// A block without stresses that fills x < 2 and, unless it is @p half, x > -2,
/// one step on, whose velocities are odd functions of x; x = 0 is held.
ParticleCase held_case(const TransferScheme &scheme, const bool is_half)
{
  GridBox box = box_of(8);
  box.reflects[0] = box.is_no_slip[0] = is_half;
  if (!is_half)
  {
    box.lower[0] = -8.;
    box.n_cells[0] = 16;
  }
  ParticleCase one(box, scheme, {elastic(1e4, 0.4, 1000.)}, MPI_COMM_SELF);
  one.fill(
    [](const auto &x) {
      return std::abs(x[0]) < 2. && std::abs(x[1] - 4.) < 1. &&
                 std::abs(x[2] - 5.) < 1.
               ? 0
               : -1;
    },
    [](const auto &x) {
      return Vector({0.05 * std::sin(x[0]) * std::cos(x[1]),
                     0.08 * x[0] * std::sin(x[2]),
                     0.05 * std::sin(2. * x[0] + x[0] * x[1] * x[1])});
    });
  one.advance(1e-3);
  return one;
}
} // namespace

// A held body moves as half of one twice as long whose other half moves the
// other way: its velocities and their gradients agree, in each direction.
TEST(ParticleConservation, sides_that_hold_are_odd_mirrors)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
    for (const auto transfer : {Transfer::fmpm, Transfer::affine})
    {
      if (transfer == Transfer::affine && degree == 1)
        continue;
      const TransferScheme scheme{degree,
                                  transfer,
                                  StressUpdate::modified_last,
                                  transfer == Transfer::fmpm ? 3u : 1u};
      SCOPED_TRACE(scheme_name(scheme));
      const ParticleCase half = held_case(scheme, true),
                         whole = held_case(scheme, false);
      std::array<std::vector<double>, 2> found;
      for (const ParticleCase *const one : {&half, &whole})
        one->for_each_particle(
          [&](const ParticleBlock &block, const std::size_t p) {
            if (block[column::position][p] > 0.)
              for (unsigned int c = 0; c < column::affine + 9; ++c)
                if (c < column::energy || c >= column::affine)
                  found[one == &whole].push_back(block[c][p]);
          });
      ASSERT_EQ(found[0].size(), found[1].size());
      ASSERT_GT(found[0].size(), 0u);
      double largest = 0.;
      for (std::size_t i = 0; i < found[0].size(); ++i)
        largest = std::max(largest,
                           std::abs(found[0][i] - found[1][i]) /
                             std::max(1., std::abs(found[1][i])));
      EXPECT_LT(largest, 1e-12);
    }
}

// A cantilever in a corner of two sides, one of which holds it while the other
// reflects: the wall takes momentum in all directions, and no energy.
TEST(ParticleConservation, sides_that_hold_take_momentum_and_no_energy)
{
  for (const TransferScheme &scheme : all_schemes(1, 3))
  {
    SCOPED_TRACE(scheme_name(scheme));
    GridBox box = box_of(12);
    box.reflects[0] = box.is_no_slip[0] = box.reflects[4] = true;
    ParticleMaterial rubber = elastic(1e4, 0.45, 1000.);
    rubber.is_smoothed = true;
    ParticleCase bar(box, scheme, {rubber}, MPI_COMM_SELF);
    bar.fill(
      [](const auto &x) {
        return x[0] < 4. && std::abs(x[1] - 6.) < 1. && x[2] < 2. ? 0 : -1;
      },
      [](const auto &x) {
        return Vector({0.02 * std::sin(x[0] + x[1]), 0.02 * x[0], 0.});
      });
    const auto start = bar.totals();
    bar.run(15., 0.2);
    const auto end = bar.totals();
    EXPECT_NEAR(bar.residual(start), 0., 1e-12 * start.kinetic_energy);
    EXPECT_LT(end.momentum[1], 0.3 * start.momentum[1]);
    const double moved =
      bar.sum([&](const ParticleBlock &block, const std::size_t p) {
        return block[column::position][p] < 0.5
                 ? block[column::position + 1][p] - 6.
                 : 0.;
      });
    EXPECT_LT(std::abs(moved), 16 * 0.02);
  }
}

// With velocities that are linear functions of place, those of the consistent
// mass matrix are the particles' own; the series comes closer term by term.
TEST(ParticleConservation, mass_series_finds_the_consistent_velocities)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    std::vector<double> errors;
    for (const unsigned int order : {1, 2, 4, 8, 16, 32})
    {
      ParticleCase cube(
        box_of(8),
        {degree, Transfer::fmpm, StressUpdate::modified_last, order},
        {elastic(1e-6, 0.3, 1000.)},
        MPI_COMM_SELF);
      const auto velocity = [](const auto &x) {
        return Vector({0.3 * x[1] - 0.1, 0.2 * x[0] + 0.1 * x[2], -0.2 * x[2]});
      };
      cube.fill([](const auto &x) { return in_cube(x, 3.) ? 0 : -1; },
                velocity);
      cube.advance(1e-9);
      const double square =
        cube.sum([&](const ParticleBlock &block, const std::size_t p) {
          Vector v = velocity(dealii::Point<3>(block[column::position][p],
                                               block[column::position + 1][p],
                                               block[column::position + 2][p]));
          for (unsigned int d = 0; d < 3; ++d)
            v[d] -= block[column::velocity + d][p];
          return v.norm_square();
        });
      errors.push_back(std::sqrt(square / cube.particles.size()));
    }
    SCOPED_TRACE(degree);
    for (std::size_t i = 1; i < errors.size(); ++i)
      EXPECT_LT(errors[i], errors[i - 1]);
    EXPECT_LT(errors.back(), 0.025 * errors[0]);
  }
}

// A particle alone flies straight on, over edges of cells and tiles, with the
// velocity it has. On edges themselves linear splines have a slope, but no
// mass.
TEST(ParticleConservation, a_particle_alone_flies_straight_on)
{
  for (const TransferScheme &scheme : all_schemes(1, 3))
    for (const double first : {4., 4.25, 4.5})
    {
      if (scheme.degree == 1 || scheme.update != StressUpdate::modified_last)
        continue;
      SCOPED_TRACE(scheme_name(scheme) + " from " + std::to_string(first));
      ParticleCase one(
        box_of(12), scheme, {elastic(1e4, 0.3, 1000.)}, MPI_COMM_SELF);
      const dealii::Point<3> x(first, first + 0.5, first);
      const Vector v({0.1, -0.03, 0.07});
      one.add(x, v, 125., 0.125);
      one.start();
      one.advance(0.1, 400);
      ASSERT_EQ(one.particles.size(), 1u);
      const ParticleState now = one.sorted_states()[0];
      for (unsigned int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(now[1 + d], x[d] + 40. * v[d], 1e-12);
        EXPECT_NEAR(now[4 + d], v[d], 1e-13);
      }
    }
}

// One particle a cell, and a body in two parts with empty cells between.
TEST(ParticleConservation, few_particles_and_empty_cells)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    SCOPED_TRACE(degree);
    TransferScheme scheme;
    scheme.degree = degree;
    ParticleCase two(
      box_of(12), scheme, {elastic(1e4, 0.3, 1000.)}, MPI_COMM_SELF);
    two.fill(
      [](const auto &x) {
        const bool inside =
          std::abs(x[1] - 6.) < 1. && std::abs(x[2] - 6.) < 1.;
        return inside && std::abs(std::abs(x[0] - 6.) - 4.) < 1. ? 0 : -1;
      },
      [](const auto &x) {
        return Vector(
          {x[0] < 6. ? 0.01 : -0.01, 0.01 * std::sin(3. * x[0]), 0.});
      },
      {{1, 1, 1}});
    ASSERT_EQ(two.particles.size(), 16u);
    const auto start = two.totals();
    two.run(30., 0.2);
    const auto end = two.totals();
    EXPECT_NEAR(two.residual(start), 0., 1e-13 * start.kinetic_energy);
    EXPECT_LT(end.kinetic_energy + end.stored_energy,
              1.05 * start.kinetic_energy);
    EXPECT_GT(end.kinetic_energy + end.stored_energy,
              0.5 * start.kinetic_energy);
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(end.momentum[d], start.momentum[d], 1e-14 * start.mass);
  }
}
