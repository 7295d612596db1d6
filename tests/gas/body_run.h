// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include "gas_run.h"
#include <gtest/gtest.h>

#include <sstream>

namespace contrecoup::gas
{
using Lines = std::vector<std::string>;

inline constexpr double degree = 0.017453292519943295;

template <int dim>
GasState<dim> still_air()
{
  GasState<dim> state;
  state.density = 1.4;
  state.pressure = 1.;
  return state;
}


/// Gas of sound speed 1 behind a shock of this Mach number along a direction.
template <int dim>
GasState<dim> shocked_air(const double mach,
                          const dealii::Tensor<1, dim> &direction)
{
  const double gamma = 1.4;
  GasState<dim> state;
  state.pressure = 1. + 2. * gamma / (gamma + 1.) * (mach * mach - 1.);
  state.density =
    1.4 * (gamma + 1.) * mach * mach / ((gamma - 1.) * mach * mach + 2.);
  state.velocity = direction * (2. / (gamma + 1.) * (mach - 1. / mach));
  return state;
}


/// Calls function(leaf, point, place, open part) for all points with gas.
template <int dim, typename Function>
void for_each_gas_point(const GasRun<dim> &run, const Function &function)
{
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    const auto box = leaf_box(run.mesh, leaf);
    for (unsigned int q = 0; q < run.layout.n_points; ++q)
    {
      const auto index = run.points.indices(q);
      dealii::Point<dim> place = box.origin;
      for (unsigned int d = 0; d < dim; ++d)
        place[d] += box.extents[d] * run.points.position(index[d]);
      const double part = run.field.open_fraction(leaf, q);
      if (part > 0.)
        function(leaf, q, place, part);
    }
  }
}


template <int dim>
GasState<dim> state_at(const GasRun<dim> &run,
                       const unsigned int leaf,
                       const unsigned int point)
{
  std::vector<double> u(run.layout.n_components);
  for (unsigned int c = 0; c < u.size(); ++c)
    u[c] = run.field.value(leaf, c, point);
  return primitive_state<dim>(u.data(), run.material);
}


/// Text that reads back as the same number.
inline std::string exactly(const double x)
{
  std::ostringstream text;
  text.precision(17);
  text << x;
  return text.str();
}


/// Mass and energy of the gas in a closed box stay while a strong wave from
/// where a coordinate is less than a quarter meets the body.
template <int dim>
void check_conservation(const Lines &lines, const unsigned int direction = 0)
{
  GasRun<dim> run(lines);
  run.set_state([&](const dealii::Point<dim> &p) {
    GasState<dim> state = still_air<dim>();
    if (p[direction] < 0.25)
    {
      state.pressure = 20.;
      state.density = 5.;
    }
    return state;
  });
  const auto before = run.totals();
  run.steps(120);
  auto after = run.totals();
  EXPECT_GT(after["kinetic_energy"], 0.05 * before.at("energy"));
  for (const std::string name : {"mass", "energy"})
    EXPECT_NEAR(after[name], before.at(name), 1e-12 * before.at(name)) << name;
}


/// A strong wave, from where @p is_driven, meets the body alike to the last bit
/// on one rank and on all of them.
template <int dim>
void check_ranks(
  const Lines &lines,
  const std::function<bool(const dealii::Point<dim> &)> &is_driven)
{
  GasRun<dim> shared(lines);
  GasRun<dim> alone(lines, MPI_COMM_SELF);
  for (auto *run : {&shared, &alone})
  {
    run->set_state([&](const dealii::Point<dim> &p) {
      GasState<dim> state = still_air<dim>();
      if (is_driven(p))
        state.pressure = 10.;
      return state;
    });
    run->steps(30);
  }
  const auto all = alone.leaves();
  for (const auto &[name, values] : shared.leaves())
    for (unsigned int i = 0; i < values.size(); ++i)
      ASSERT_EQ(values[i], all.at(name)[i]) << name << ' ' << i;
}


/// Gas at rest around the body keeps every bit.
template <int dim>
void check_rest(const Lines &lines)
{
  GasRun<dim> run(lines + Lines{"Method/Skip quiet leaves=false"});
  const auto rest = still_air<dim>();
  run.set_state([&](const dealii::Point<dim> &) { return rest; });
  const auto before = run.leaves();
  run.steps(20);
  EXPECT_EQ(run.leaves(), before);
}


/// Gas that flows along planes at several angles to the mesh stays as it is.
/// @param change its largest relative change, of lines and velocity
template <typename Function>
void check_oblique_planes(const Function &change)
{
  for (const double angle : {0., 17., 30., 45., 71.})
  {
    dealii::Tensor<1, 2> along;
    along[0] = -1.3 * std::sin(angle * degree);
    along[1] = 1.3 * std::cos(angle * degree);
    const Lines plane = {
      "Rigid body/Kind=half space",
      "Rigid body/Half space/Rotation=0, 0, " + std::to_string(angle),
      "Rigid body/Half space/Shift=0.513, 0.507, 0",
      "Initial state/Background/Density=1.4",
      "Initial state/Background/Pressure=1",
      "Initial state/Background/Velocity=" + exactly(along[0]) + ", " +
        exactly(along[1])};
    EXPECT_LT(change(plane, along), 1e-11) << angle;
  }
}


/// The same of planes in space with the normal (1, 1, 1), so that cells are cut
/// at their corners.
template <typename Function>
void check_planes_in_space(const Function &change)
{
  const double tilt = std::atan(std::sqrt(0.5)) / degree;
  dealii::Tensor<1, 3> along;
  along[0] = 0.9;
  along[1] = -1.1;
  along[2] = 0.2;
  for (const std::string shift : {"0.5, 0.5, 0.5", "0.513, 0.507, 0.53"})
    EXPECT_LT(
      change(
        finite_volume(4) +
          Lines{"Rigid body/Kind=half space",
                "Rigid body/Half space/Rotation=0, " + exactly(-tilt) + ", 45",
                "Rigid body/Half space/Shift=" + shift,
                "Initial state/Background/Density=1.4",
                "Initial state/Background/Pressure=1",
                "Initial state/Background/Velocity=0.9, -1.1, 0.2"},
        along),
      1e-10)
      << shift;
}


/// Largest relative difference of the gas at any point from @p state.
template <int dim>
double largest_change(const GasRun<dim> &run, const GasState<dim> &state)
{
  double largest = 0.;
  for_each_gas_point(
    run,
    [&](const unsigned int leaf, const unsigned int q, const auto &, double) {
      const auto now = state_at(run, leaf, q);
      largest = std::max(
        {largest,
         std::abs(now.pressure / state.pressure - 1.),
         std::abs(now.density / state.density - 1.),
         (now.velocity - state.velocity).norm() / state.velocity.norm()});
    });
  return largest;
}
} // namespace contrecoup::gas
