// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/stage/operator_context.h>
#include <contrecoup/gas/stage/stage.h>
#include <contrecoup/gas/state/quiet_leaves.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * The spatial discretisation of one scheme in one precision, for the leaves of
 * this rank: what the time stepping needs of it, without templates on scheme or
 * equation of state.
 */
template <int dim, typename Real>
class GasOperator
{
public:
  explicit GasOperator(const OperatorContext<dim> &context)
    : mesh_(context.mesh)
    , layout_(context.layout)
    , boundary_(context.boundary)
  {}
  virtual ~GasOperator() = default;

  /// Renews what depends on the mesh. Call after LeafMesh::rebuild().
  virtual void reinit() = 0;

  /// Does one Runge-Kutta stage on all owned leaves but those of batches
  /// that the second argument says are not active.
  virtual void apply(const BasicStage<Real> &stage,
                     QuietLeaves<dim> &quiet_leaves) = 0;

  /// Whether stages end with redistribute(), on every rank alike.
  virtual bool redistributes() const
  {
    return false;
  }

  /// Completes what apply() began in cells that a body cuts: shares the
  /// change of small ones with their neighbours, conservatively. The ghosts
  /// of stage.results.state must be up to date.
  virtual void redistribute(const BasicStage<Real> & /*stage*/,
                            QuietLeaves<dim> & /*quiet_leaves*/)
  {}

  /// Batches that stages never touch, because they hold no gas.
  virtual std::vector<unsigned int> closed_batches() const
  {
    return {};
  }

  /// Computes stage.results.sensor and stage.results.signal_rate of
  /// stage.results.state.
  virtual void analyse(const BasicStage<Real> &stage) = 0;

  /// Owned leaves at boundaries with a state of their own; see
  /// QuietLeaves::reinit().
  std::vector<unsigned int> driven_leaves() const;

protected:
  const LeafMesh<dim> &mesh_;
  const LeafLayout layout_;
  const Boundary<dim> &boundary_;
};
} // namespace contrecoup::gas
