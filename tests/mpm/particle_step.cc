// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "particle_case.h"
#include "sign_changes.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::mpm;

namespace
{
/// A bar along x, held at x = 0 and free at its end, in its first mode: length
/// 25, by default E = 100 and density 1, hence a period of 10.
ParticleCase vibrating_bar(const TransferScheme &scheme,
                           const unsigned int n,
                           ParticleMaterial bar = elastic(100., 0., 1.))
{
  GridBox box;
  box.cell_size = 25. / n;
  box.n_cells = {{n + 4, 1, 1}};
  box.reflects = {{true, false, true, true, true, true}};
  bar.kinematics = SolidKinematics::small_strain;
  ParticleCase result(box, scheme, {bar});
  result.fill([](const dealii::Point<3> &x) { return x[0] < 25. ? 0 : -1; },
              [](const dealii::Point<3> &x) {
                dealii::Tensor<1, 3> v;
                v[0] = 0.1 * std::sin(0.5 * dealii::numbers::PI * x[0] / 25.);
                return v;
              },
              {{2, 1, 1}});
  return result;
}

/// The last time before 25 at which the bar's momentum changes its sign: 22.5.
double last_crossing(ParticleCase &bar)
{
  SignChanges changes(bar.totals().momentum[0]);
  bar.run(25., 0.25, [&] { changes.add(bar.time, bar.totals().momentum[0]); });
  return changes.times.empty() ? 0. : changes.times.back();
}
} // namespace

// Energies add up with every basis, series and update; the bar keeps its
// period to 0.4 % with 16 cells, the better the longer the series.
TEST(ParticleStep, bar_vibrates_with_its_period_and_keeps_its_energy)
{
  for (const unsigned int degree : {1, 2, 3})
    for (const auto update :
         {StressUpdate::first, StressUpdate::last, StressUpdate::modified_last})
    {
      double lumped = 0.;
      for (const unsigned int order : {1, 4})
      {
        SCOPED_TRACE(std::to_string(degree) + " " + std::to_string(order));
        TransferScheme scheme;
        scheme.degree = degree;
        scheme.series_order = order;
        scheme.update = update;
        auto bar = vibrating_bar(scheme, 16);
        const auto start = bar.totals();
        const double error = std::abs(last_crossing(bar) - 22.5);
        EXPECT_LT(error, order == 1 ? 0.1 : 0.04);
        EXPECT_NEAR(bar.residual(start), 0., 1e-13 * start.kinetic_energy);
        const auto end = bar.totals();
        EXPECT_NEAR(end.kinetic_energy + end.stored_energy,
                    start.kinetic_energy,
                    0.02 * start.kinetic_energy);
        EXPECT_NEAR(end.mass, start.mass, 1e-14 * start.mass);
        if (order == 1)
          lumped = error;
        else if (degree > 1)
        {
          EXPECT_LT(error, 0.5 * lumped);
        }
      }
    }
}

// A branch that relaxes within a step, or at once, leaves the elastic rest.
TEST(ParticleStep, tiny_relaxation_times_leave_the_relaxed_material)
{
  const TransferScheme scheme;
  auto relaxed = vibrating_bar(scheme, 16, elastic(100., 0., 1.));
  relaxed.advance(0.02, 200);
  const auto expected = relaxed.sorted_states();
  for (const double time : {1e-12, 1e-300, 0.})
  {
    ParticleMaterial material = elastic(100., 0., 1.);
    auto &solid = std::get<SolidMaterial>(material.law);
    solid.relaxing_shear = 2. * solid.instantaneous_shear;
    solid.instantaneous_shear += solid.relaxing_shear;
    solid.relaxation_time = time;
    auto bar = vibrating_bar(scheme, 16, material);
    bar.advance(0.02, 200);
    EXPECT_LT(largest_difference(bar.sorted_states(), expected), 1e-12) << time;
  }
}
