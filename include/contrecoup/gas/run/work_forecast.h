// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/remaining_time.h>
#include <contrecoup/gas/adaptation/adaptation.h>
#include <contrecoup/gas/kernel/time_stepper.h>

#include <deal.II/base/point.h>

#include <functional>

namespace contrecoup::gas
{
/**
 * The work that steps of a gas run will take, from its present octree and
 * state. Two things change it: the front of the blast wakes leaves that are
 * quiet now and halves them as far as limits of size allow, and these limits
 * merge leaves at times that are known. Other leaves that are halved or merged
 * are taken to be equally many, and signals in leaves that are at work now to
 * be as fast as now.
 */
template <int dim>
class WorkForecaster
{
public:
  /// @param front expected distance of the front from @p centre at a time [m],
  /// NaN if it is not known
  /// @param sound_speed of the gas at rest [m/s]
  WorkForecaster(const LeafMesh<dim> &mesh,
                 const TimeStepper<dim> &stepper,
                 const QuietLeaves<dim> &quiet_leaves,
                 const Adaptation<dim> &adaptation,
                 const dealii::Point<dim> &centre,
                 std::function<double(double)> front,
                 const double sound_speed);

  /// From @p time to @p end_time [s]: leaves to be computed in a step, times
  /// the largest signal rate [1/s], all ranks together. Collective.
  WorkForecast forecast(const double time, const double end_time) const;

private:
  /// A leaf as the forecast sees it.
  struct Leaf
  {
    double reached_at = 0.; ///< distance of the front that reaches it [m]
    double diameter = 0.;   ///< [m]
    double rate = 0.;       ///< of signals, see Stage::signal_rate [1/s]
    bool is_active = false; ///< whether steps compute it
    unsigned int level = 0;
    unsigned int min_level = 0;  ///< that the body leaves it
    unsigned int merges_now = 0; ///< by which it is finer than it may be
  };

  /// Merges that limits of size ask of a leaf at time @p time [s].
  unsigned int merges(const unsigned int leaf, const double time) const;

  /// |u| + dim c behind a shock into air at rest that is as fast as the front
  /// at @p time, over dim c_0 [-]; one if it is not known.
  double signal_factor(const double time) const;

  const LeafMesh<dim> &mesh_;
  const Adaptation<dim> &adaptation_;
  std::function<double(double)> front_;
  double sound_speed_;
  std::vector<Leaf> leaves_;
};
} // namespace contrecoup::gas
