// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/stage/operator_context.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/quiet_leaves.h>
#include <contrecoup/materials/gas_material.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace contrecoup::gas
{
/**
 * Strong-stability-preserving Runge-Kutta steps of a gas field. A step with an
 * unphysical result is undone and repeated with bounded velocity slopes (finite
 * volumes with linear reconstruction), then at half the size.
 */
template <int dim>
class TimeStepper
{
public:
  virtual ~TimeStepper() = default;

  /// Renews what depends on the mesh and computes sensor and signal rate
  /// of the current state.
  virtual void reinit(GasField &field) = 0;

  /// Computes sensor and signal rate of the current state, of which only
  /// gas with explosive products may have changed since the last step.
  virtual void analyse(GasField &field) = 0;

  /// Brings the ghosts of the current state up to date. Collective.
  virtual void update_ghosts(GasField &field) = 0;

  /// Largest signal rates of the current state [1/s].
  struct Rates
  {
    double all = 0.; ///< of all leaves
    /// Largest product of a leaf's rate and its LeafLevels::size_ratios();
    /// divided by `all`, the travel of a front in a step, for AdaptationPace.
    double front_rate = 0.;
  };

  /// Collective.
  /// @param size_ratios see LeafLevels; empty: all are one
  virtual Rates
  largest_rates(const std::vector<double> &size_ratios = {}) const = 0;

  /// Largest signal rate of a leaf, see StageResults::signal_rate [1/s].
  virtual double signal_rate(const unsigned int leaf) const = 0;

  /// Largest stable step [s] from a state with the largest signal rate
  /// @p rate [1/s].
  virtual double stable_step(const double rate) const = 0;
  /// The same from the current state. Collective.
  double stable_step() const
  {
    return stable_step(largest_rates().all);
  }

  struct Result
  {
    double step = 0.;                   ///< taken [s]
    unsigned int retries = 0;           ///< times that the step was halved
    bool bound_velocity_slopes = false; ///< see Stage
    /// On the rank where no step size helped, a leaf that turned
    /// unphysical; its state is in stage 0 of the field.
    std::optional<unsigned int> unphysical_leaf;
    bool failed = false; ///< on any rank
    /// Mean of StageResults::wall_force over the step, on this rank.
    std::array<double, 6> wall_force = {};
  };

  /// Goes ahead by @p step [s] or, after retries, by less. Collective.
  virtual Result
  advance(GasField &field, const double time, const double step) = 0;
};

/// The stepper with the operator that scheme, precision and @p material ask
/// for: finite volumes on boxes go around the body of the context. The
/// arguments must outlive it.
template <int dim>
std::unique_ptr<TimeStepper<dim>>
make_time_stepper(const OperatorContext<dim> &context,
                  const GasMaterial &material,
                  QuietLeaves<dim> &quiet_leaves);
} // namespace contrecoup::gas
