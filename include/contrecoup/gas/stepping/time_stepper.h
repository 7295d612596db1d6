// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/ghost_exchange.h>
#include <contrecoup/gas/stage/gas_operator.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/quiet_leaves.h>

#include <deal.II/base/aligned_vector.h>

#include <optional>
#include <utility>
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
  /// Keeps references.
  TimeStepper(const LeafMesh<dim> &mesh,
              const Scheme &scheme,
              GasOperator<dim> &gas_operator,
              QuietLeaves<dim> &quiet_leaves);

  /// Renews what depends on the mesh and computes sensor and signal rate
  /// of the current state.
  void reinit(GasField &field);

  /// Computes sensor and signal rate of the current state, of which only
  /// gas with explosive products may have changed since the last step.
  void analyse(GasField &field);

  /// Brings the ghosts of the current state up to date. Collective.
  void update_ghosts(GasField &field)
  {
    visit_precision(field.layout().precision, [&](const auto real) {
      using Real = std::decay_t<decltype(real)>;
      exchange_.update(field.state<Real>(), field.sensors<Real>());
    });
  }

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
  Rates largest_rates(const std::vector<double> &size_ratios = {}) const;

  /// Largest stable step [s] from a state with the largest signal rate
  /// @p rate [1/s].
  double stable_step(const double rate) const
  {
    return scheme_.cfl * scheme_.stability_limit() / rate;
  }
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
  Result advance(GasField &field, const double time, const double step);

  /// Largest signal rate of a leaf, see StageResults::signal_rate [1/s].
  double signal_rate(const unsigned int leaf) const
  {
    return visit_precision(precision_, [&](const auto real) -> double {
      return signal_rates<std::decay_t<decltype(real)>>()[leaf];
    });
  }

private:
  template <typename Real>
  dealii::AlignedVector<Real> &signal_rates()
  {
    return std::get<dealii::AlignedVector<Real>>(signal_rates_);
  }
  template <typename Real>
  const dealii::AlignedVector<Real> &signal_rates() const
  {
    return std::get<dealii::AlignedVector<Real>>(signal_rates_);
  }
  void compute_sensors(GasField &field);
  /// @returns number of the stage copy that holds the result, or nothing
  /// when a state turned unphysical on any rank
  template <typename Real>
  std::optional<unsigned int> try_step(GasField &field,
                                       const double time,
                                       const double step,
                                       const bool bound_velocity_slopes);
  /// Whether the scheme has slopes that Stage::bound_velocity_slopes bounds.
  bool can_bound_velocity_slopes() const
  {
    return scheme_.kind == Scheme::Kind::finite_volume &&
           scheme_.linear_reconstruction;
  }

  const LeafMesh<dim> &mesh_;
  const Scheme &scheme_;
  GasOperator<dim> &operator_;
  GhostExchange<dim> exchange_;
  Precision precision_ = Precision::double_precision; ///< of the field
  std::tuple<dealii::AlignedVector<double>, dealii::AlignedVector<float>>
    signal_rates_;
  QuietLeaves<dim> &quiet_leaves_;
  unsigned int unphysical_leaf_ = no_leaf;
  std::array<double, 6> wall_force_; ///< see Result
};
} // namespace contrecoup::gas
