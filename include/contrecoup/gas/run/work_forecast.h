// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/remaining_time.h>
#include <contrecoup/gas/adaptation/adaptation.h>
#include <contrecoup/gas/stepping/time_stepper.h>

#include <deal.II/base/point.h>

#include <functional>

namespace contrecoup::gas
{
/**
 * Forecast of the work of the remaining time steps, from the present octree and
 * state. Two changes are considered: the blast front activates quiet leaves and
 * refines them to the largest level that the size limits allow, and size limits
 * coarsen leaves at known times. All other refinement and coarsening is assumed
 * to balance, and signal rates in active leaves are assumed to stay as they
 * are.
 */
template <int dim>
class WorkForecaster
{
public:
  /// @param front expected distance of the blast front from @p centre [m] as a
  /// function of time [s]; NaN if unknown
  /// @param sound_speed of the ambient gas [m/s]
  WorkForecaster(const LeafMesh<dim> &mesh,
                 const TimeStepper<dim> &stepper,
                 const QuietLeaves<dim> &quiet_leaves,
                 const Adaptation<dim> &adaptation,
                 const dealii::Point<dim> &centre,
                 std::function<double(double)> front,
                 const double sound_speed);

  /// Work from @p time to @p end_time [s]: number of leaves to be computed per
  /// step times the largest signal rate [1/s], over all ranks. Collective.
  WorkForecast forecast(const double time, const double end_time) const;

private:
  /// Data of a leaf for the forecast.
  struct Leaf
  {
    double reached_at = 0.; ///< front distance at arrival [m]
    double diameter = 0.;   ///< [m]
    double rate = 0.; ///< signal rate, see StageResults::signal_rate [1/s]
    bool is_active = false; ///< whether it is computed now
    unsigned int level = 0;
    unsigned int min_level = 0;  ///< smallest level near the body
    unsigned int merges_now = 0; ///< levels above the limit at present
  };

  /// Number of levels by which size limits coarsen a leaf at @p time [s].
  unsigned int merges(const unsigned int leaf, const double time) const;

  /// Ratio of |u| + dim c behind the front at @p time [s], a shock in air at
  /// rest, to dim c_0 [-]; 1 if the front is unknown.
  double signal_factor(const double time) const;

  const LeafMesh<dim> &mesh_;
  const Adaptation<dim> &adaptation_;
  std::function<double(double)> front_;
  double sound_speed_;
  std::vector<Leaf> leaves_;
};
} // namespace contrecoup::gas
