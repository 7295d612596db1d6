// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/contact_kernels.h>

#include "all_schemes.h"
#include "particle_case.h"
#include "sign_changes.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::mpm;

namespace
{
/// A slab one cell thick that slides between mirrors along z.
GridBox slab_of(const unsigned int n_x, const unsigned int n_y)
{
  GridBox box;
  box.n_cells = {{n_x, n_y, 1}};
  box.reflects = {{false, false, false, false, true, true}};
  return box;
}

/// One particle on a grid of cubes of 1 m, ready for steps.
ParticleCase lone_particle(const TransferScheme &scheme,
                           const dealii::Point<3> &x,
                           const dealii::Tensor<1, 3> &v)
{
  GridBox box;
  box.n_cells = {{12, 12, 12}};
  ParticleCase one(box, scheme, {elastic(1e4, 0.3, 1000.)}, MPI_COMM_SELF);
  one.add(x, v, 125., 0.125);
  one.start();
  return one;
}

/// Motion of a gel in a box of mirrors.
struct Swing
{
  double frequency; ///< of its first quarter, over that of shear alone
  double returned;  ///< part of the motion that is back after a half period
  double residual;  ///< energy that is missing, over that of the start
};

/**
 * Swings a square of gel, n cells wide, in a mode without change of volume:
 * velocity along (sin kx cos ky, -cos kx sin ky), which slides along the
 * mirrors without shear there. Its angular frequency is sqrt(2 G / rho) k.
 */
Swing swing_of_gel(const TransferScheme &scheme,
                   const double bulk_over_shear,
                   const bool is_smoothed,
                   const unsigned int n)
{
  SolidMaterial gel;
  gel.density = gel.instantaneous_shear = 1000.;
  gel.bulk_modulus = bulk_over_shear * gel.instantaneous_shear;
  ParticleMaterial material;
  material.name = "gel";
  material.law = gel;
  material.is_smoothed = is_smoothed;
  GridBox box;
  box.n_cells = {{n, n, 1}};
  box.reflects.fill(true);
  ParticleCase one(box, scheme, {material}, MPI_COMM_SELF);
  const double k = dealii::numbers::PI / n,
               omega = std::sqrt(2.) * k * gel.shear_speed(),
               half_period = dealii::numbers::PI / omega;
  const auto mode = [&](const double x, const double y) {
    dealii::Tensor<1, 3> v;
    v[0] = std::sin(k * x) * std::cos(k * y);
    v[1] = -std::cos(k * x) * std::sin(k * y);
    return v;
  };
  one.fill([](const auto &) { return 0; },
           [&](const auto &x) { return 0.01 * omega * mode(x[0], x[1]); },
           {{2, 2, 1}});
  const auto part_of_mode = [&]() {
    return one.sum([&](const ParticleBlock &block, const std::size_t p) {
      const auto v =
        mode(block[column::position][p], block[column::position + 1][p]);
      return v[0] * block[column::velocity][p] +
             v[1] * block[column::velocity + 1][p];
    });
  };
  const auto totals = one.totals();
  const double start = part_of_mode();
  SignChanges changes(start);
  one.run(half_period, 0.5, [&]() { changes.add(one.time, part_of_mode()); });
  return {changes.times.empty() ? 0. : 0.5 * half_period / changes.times[0],
          -part_of_mode() / start,
          one.residual(totals) / totals.kinetic_energy};
}

/// Motion that a disk gave to another, over its own along the normal.
struct Meeting
{
  double along;    ///< the normal
  double across;   ///< it
  double momentum; ///< that is missing, over that of a disk
  double residual; ///< energy that is missing, over that of the start
};

/// Disks of four cells' radius, with 0.02 m/s towards each other along x, where
/// sound in a bar has 1 m/s; they meet after 100 s, and are apart again before
/// 180.
Meeting meet_at_45_degrees(const double friction)
{
  std::vector<ParticleMaterial> materials(2, elastic(1000., 0.3, 1000.));
  materials[1].field = 1;
  TransferScheme scheme;
  scheme.series_order = 2;
  ParticleCase two(slab_of(24, 24), scheme, materials, MPI_COMM_SELF);
  two.step = ParticleStep(
    scheme,
    materials,
    FieldContact(
      scheme.degree, {0, 1}, FieldInterface::contact, 0.25, 0.25, friction));
  const double radius = 4., half = radius * std::sqrt(0.5), speed = 0.01,
               apart = 1.;
  const std::array<dealii::Point<2>, 2> centres{
    {{12. - half - apart, 12. - half}, {12. + half + apart, 12. + half}}};
  const auto disk_at = [&](const auto &x) {
    for (int m = 0; m < 2; ++m)
      if (centres[m].distance({x[0], x[1]}) < radius)
        return m;
    return -1;
  };
  two.fill(
    disk_at,
    [&](const auto &x) {
      return dealii::Tensor<1, 3>({disk_at(x) == 0 ? speed : -speed, 0., 0.});
    },
    {{2, 2, 1}});
  const auto start = two.totals();
  two.run(180., 0.4);
  std::array<double, 3> momentum{};
  two.particles.for_each_block([&](const unsigned int m,
                                   const ParticleBlock &block) {
    for (std::size_t p = 0; m == 0 && p < block.size(); ++p)
      for (unsigned int d = 0; d < 3; ++d)
        momentum[d] += block[column::mass][p] * block[column::velocity + d][p];
  });
  const auto end = two.totals();
  const double all = 0.5 * start.mass * speed, given = all - momentum[0];
  const double contact_loss = two.step.ledger().contact_loss;
  return {0.5 * (given - momentum[1]) / all,
          0.5 * (given + momentum[1]) / all,
          std::hypot(end.momentum[0] - start.momentum[0],
                     end.momentum[1] - start.momentum[1]) /
            all,
          (two.residual(start) + contact_loss) / start.kinetic_energy};
}
} // namespace

// A body of 24 particles that vibrates while it flies over 20 cells, a hundred
// thousand steps.
TEST(ParticleExtremes, a_hundred_thousand_steps_lose_nothing)
{
  TransferScheme scheme;
  scheme.series_order = 2;
  ParticleMaterial rubber = elastic(1e4, 0.45, 1000.);
  rubber.is_smoothed = true;
  ParticleCase body(slab_of(28, 16), scheme, {rubber}, MPI_COMM_SELF);
  const double speed =
    1e-3 * body.step.materials()[0].solid()->dilatational_speed();
  body.fill(
    [](const auto &x) {
      return std::abs(x[0] - 3.5) < 1.5 && std::abs(x[1] - 3.) < 1. ? 0 : -1;
    },
    [&](const auto &x) {
      return dealii::Tensor<1, 3>({speed * (1. + 0.5 * std::sin(2. * x[0])),
                                   speed * (0.5 + 0.5 * std::sin(2. * x[1])),
                                   0.});
    },
    {{2, 2, 1}});
  ASSERT_EQ(body.particles.size(), 24u);
  const auto start = body.totals();
  const double size = 0.2 * body.step.signal_time(body.grid, body.particles);
  constexpr unsigned int n_steps = 100000;
  body.advance(size, n_steps);
  const auto end = body.totals();
  EXPECT_GT(n_steps * size * end.momentum[0] / end.mass, 20.);
  EXPECT_NEAR(body.residual(start), 0., 1e-11 * start.kinetic_energy);
  EXPECT_NEAR(end.kinetic_energy + end.stored_energy,
              start.kinetic_energy,
              0.022 * start.kinetic_energy);
  for (unsigned int d = 0; d < 3; ++d)
    EXPECT_NEAR(end.momentum[d], start.momentum[d], 1e-13 * speed * start.mass);
  EXPECT_NEAR(end.mass, start.mass, 1e-14 * start.mass);
}

// A particle alone that starts exactly at a face, an edge or a node of cells,
// and goes aslant or along it, keeps its velocity, also with linear splines,
// whose slopes reach there for nodes that have no mass but a trace of its own.
TEST(ParticleExtremes, a_particle_alone_starts_at_faces_edges_and_nodes)
{
  const std::vector<dealii::Point<3>> places{
    {4., 4.3, 4.6}, {4., 5., 4.3}, {4., 4., 4.}, {5., 6., 7.}};
  const std::vector<dealii::Tensor<1, 3>> velocities{
    dealii::Tensor<1, 3>({0.1, -0.03, 0.07}),
    dealii::Tensor<1, 3>({0.1, 0., 0.})};
  for (const TransferScheme &scheme : all_schemes(2, 2))
    for (const auto &x : places)
      for (const auto &v : velocities)
      {
        // Light nodes make the stresses of other updates grow.
        if (scheme.degree == 1 && scheme.update != StressUpdate::modified_last)
          continue;
        SCOPED_TRACE(scheme_name(scheme) + " from " + std::to_string(x[2]) +
                     " by " + std::to_string(v[2]));
        ParticleCase one = lone_particle(scheme, x, v);
        one.advance(0.1, 60);
        ASSERT_EQ(one.particles.size(), 1u);
        const ParticleState now = one.sorted_states()[0];
        for (unsigned int d = 0; d < 3; ++d)
        {
          EXPECT_NEAR(now[1 + d], x[d] + 6. * v[d], 1e-12);
          EXPECT_NEAR(now[4 + d], v[d], 1e-14);
        }
      }
}

// Linear splines: in a bar whose particles lie on edges of cells, each has the
// strain rate of the cell above, that at its free end none.
TEST(ParticleExtremes, a_bar_on_edges_of_cells_is_strained_evenly)
{
  GridBox box;
  box.n_cells = {{12, 12, 12}};
  TransferScheme scheme;
  scheme.degree = 1;
  ParticleCase bar(box, scheme, {elastic(1e4, 0.3, 1000.)}, MPI_COMM_SELF);
  constexpr double rate = 0.02, step = 1e-3;
  for (unsigned int x = 2; x < 10; ++x)
    bar.add(dealii::Point<3>(x, 5., 5.),
            dealii::Tensor<1, 3>({3. + rate * x, 1., 0.}),
            1000.,
            1.);
  bar.start();
  bar.advance(step);
  bar.for_each_particle([&](const ParticleBlock &block, const std::size_t p) {
    const double v = block[column::velocity][p],
                 start = block[column::position][p] - step * v;
    EXPECT_NEAR(v, 3. + rate * start, 1e-13);
    for (unsigned int k = 0; k < 9; ++k)
      EXPECT_NEAR(block[column::gradient + k][p],
                  k == 0 && start < 8.5 ? step * rate : 0.,
                  1e-15);
  });
}

// A gel that is a million times as stiff in volume as in shear, with six cells
// in half a wave: it swings as shear has it, where its pressure is smoothed;
// else it locks, linear splines most.
TEST(ParticleExtremes, gels_swing_with_shear_alone_where_smoothed)
{
  TransferScheme scheme;
  scheme.series_order = 2;
  for (scheme.degree = 1; scheme.degree <= 3; ++scheme.degree)
    for (const bool is_smoothed : {true, false})
    {
      const Swing swing = swing_of_gel(scheme, 1e6, is_smoothed, 6);
      SCOPED_TRACE(std::string(bases[scheme.degree - 1].name) +
                   (is_smoothed ? " smoothed" : ""));
      EXPECT_NEAR(swing.residual, 0., 1e-13);
      if (scheme.degree == 1)
        EXPECT_GT(swing.frequency, is_smoothed ? 1.4 : 80.);
      else if (is_smoothed)
      {
        EXPECT_NEAR(swing.frequency, 1., 0.031);
        EXPECT_GT(swing.returned, 0.995);
      }
      else
        EXPECT_GT(swing.frequency, scheme.degree == 2 ? 2.3 : 1.2);
    }
}

// Round-off puts a particle that is in a corner of its tile outside of it: it
// is where the corner is for velocity fields, too.
TEST(ParticleExtremes, surfaces_of_particles_in_corners_of_tiles)
{
  const WindowGeometry corner{{{0.08, 0.08, 0.08}}, 0.02};
  const auto surfaces = [&](const unsigned int degree, const double x) {
    ParticleBlock block;
    const std::size_t p = block.append();
    for (unsigned int d = 0; d < 3; ++d)
      block[column::position + d][p] = x;
    block[column::mass][p] = block[column::volume][p] = 1.;
    std::vector<double> normals(3 * window_stride, 0.),
      extents(window_stride, -1.);
    std::fill_n(normals.begin(), window_stride, 1.);
    update_extents(
      degree, block, corner, 1., {0.005, 1.}, normals.data(), extents.data());
    return extents;
  };
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    SCOPED_TRACE(degree);
    const auto at = surfaces(degree, 0.08),
               before = surfaces(degree, std::nextafter(0.08, 0.));
    double largest = 0.;
    for (unsigned int node = 0; node < window_stride; ++node)
      largest = std::max(largest, std::abs(at[node] - before[node]));
    EXPECT_LT(largest, 1e-16);
  }
}

// Two disks that move against each other along x and meet at 45 degrees to the
// grid. They give one another what they have along the normal, less what nodes
// in contact lose, and no momentum is lost. Their normals, of gradients of
// mass, hold them across it as a coefficient of friction of 0.12 would; with
// one of 0.1 by 0.08 more.
TEST(ParticleExtremes, contact_at_45_degrees)
{
  const Meeting slip = meet_at_45_degrees(0.), rub = meet_at_45_degrees(0.1);
  for (const Meeting &meeting : {slip, rub})
  {
    EXPECT_NEAR(meeting.momentum, 0., 1e-13);
    EXPECT_NEAR(meeting.residual, 0., 1e-12);
    EXPECT_GT(meeting.along, 0.67);
    EXPECT_LT(meeting.along, 1.);
  }
  EXPECT_NEAR(slip.across, 0., 0.1);
  EXPECT_NEAR(rub.across - slip.across, 0.1 * rub.along, 0.0165);
}
