// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/recorders.h>
#include <contrecoup/gas/run/gas_core.h>
#include <contrecoup/gas/run/modelling_plan.h>

namespace contrecoup::gas
{
/// Computes the values of the ModellingPlan of a run: estimates from scene and
/// initial state, measured values from state and recorders.
template <int dim>
class RunPlan
{
public:
  /// Keeps a reference to the core.
  explicit RunPlan(const GasCore<dim> &core)
    : core_(core)
  {}

  /// Reads the planes of symmetry from subsection "Boundaries".
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Sets a blast that the initial state does not (or no longer) show.
  /// @param energy in full space [J]
  /// @param non_ideal_fraction see ModellingPlan
  void expect_blast(const double energy,
                    const dealii::Point<dim> &centre,
                    const double non_ideal_fraction);

  /// Plan before the run. Collective.
  std::vector<Assumption> plan(const Recorders<dim> &recorders);

  /// The plan with measured values. Collective.
  std::vector<Assumption> audit(Recorders<dim> &recorders) const;

  /// The ModellingPlan of the last call of plan().
  const ModellingPlan<dim> &found() const
  {
    return plan_;
  }

  /// Writes and reads the blast, for checkpoints.
  void save(std::ostream &stream) const
  {
    plan_.save(stream);
  }
  void load(std::istream &stream)
  {
    plan_.load(stream);
  }

private:
  /// Determines the blast from the initial state, unless it is known.
  void find_blast();
  /// Energy of the gas in the domain above that of ambient gas [J], including
  /// chemical energy and afterburn not yet released.
  double excess_energy() const;
  /// See ModellingPlan::non_ideal_fraction; NaN if the mass fraction of
  /// products is below one half everywhere.
  double non_ideal_fraction() const;
  /// Shortest edge of a subcell [m].
  double finest_edge() const;

  const GasCore<dim> &core_;
  ModellingPlan<dim> plan_;
};
} // namespace contrecoup::gas
