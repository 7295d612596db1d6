// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/recorders.h>
#include <contrecoup/gas/run/gas_core.h>
#include <contrecoup/gas/run/modelling_plan.h>

namespace contrecoup::gas
{
/// Makes the ModellingPlan of a run: from its scene and initial state before
/// it, and from what was measured after it.
template <int dim>
class RunPlan
{
public:
  /// Keeps a reference to the core.
  explicit RunPlan(const GasCore<dim> &core)
    : core_(core)
  {}

  /// Takes a blast of @p energy in full space [J] that the initial state does
  /// not show, or no longer.
  /// @param non_ideal_fraction see ModellingPlan
  void expect_blast(const double energy,
                    const dealii::Point<dim> &centre,
                    const double non_ideal_fraction);

  /// Collective. @param probes where nothing may come back from open sides
  std::vector<Assumption> plan(const std::vector<dealii::Point<dim>> &probes);

  /// Collective.
  std::vector<Assumption> audit(Recorders<dim> &recorders) const;

  /// What plan() found.
  const ModellingPlan<dim> &found() const
  {
    return plan_;
  }

  /// The blast, for checkpoints.
  void save(std::ostream &stream) const
  {
    plan_.save(stream);
  }
  void load(std::istream &stream)
  {
    plan_.load(stream);
  }

private:
  /// Looks for a blast in the initial state, unless it is known.
  void find_blast();
  /// Energy of the domain, chemical energy and afterburn to come included,
  /// above that of gas that nothing happened to [J].
  double excess_energy() const;
  /// See ModellingPlan; NaN without products, or with less than half of them
  /// everywhere.
  double non_ideal_fraction() const;
  /// Shortest edge of a subcell [m].
  double finest_edge() const;

  const GasCore<dim> &core_;
  ModellingPlan<dim> plan_;
};
} // namespace contrecoup::gas
