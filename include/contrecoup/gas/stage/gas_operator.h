// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/boundary.h>
#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/octree/scheme.h>
#include <contrecoup/gas/stage/stage.h>
#include <contrecoup/gas/state/quiet_leaves.h>
#include <contrecoup/materials/gas_material.h>

#include <memory>

namespace contrecoup::gas
{
template <int dim>
class CutLeaves;

/**
 * The spatial discretisation of one scheme, for the leaves of this rank:
 * what the time stepping needs of it, without templates on scheme or
 * equation of state.
 */
template <int dim>
class GasOperator
{
public:
  GasOperator(const LeafMesh<dim> &mesh,
              const LeafLayout &layout,
              const Boundary<dim> &boundary)
    : mesh_(mesh)
    , layout_(layout)
    , boundary_(boundary)
  {}
  virtual ~GasOperator() = default;

  /// Renews what depends on the mesh. Call after LeafMesh::rebuild().
  virtual void reinit() = 0;

  /// Does one Runge-Kutta stage on all owned leaves but those of batches
  /// that the second argument says are not active. An operator works in the
  /// precision that it was made for; the other function must not be called.
  virtual void apply(const BasicStage<double> &, QuietLeaves<dim> &)
  {
    Assert(false, dealii::ExcInternalError());
  }
  virtual void apply(const BasicStage<float> &, QuietLeaves<dim> &)
  {
    Assert(false, dealii::ExcInternalError());
  }

  /// Whether stages end with redistribute(), on every rank alike.
  virtual bool redistributes() const
  {
    return false;
  }

  /// Completes what apply() began in cells that a body cuts: shares the
  /// change of small ones with their neighbours, conservatively. The ghosts
  /// of stage.results.state must be up to date.
  virtual void redistribute(const BasicStage<double> &, QuietLeaves<dim> &)
  {
    Assert(false, dealii::ExcInternalError());
  }
  virtual void redistribute(const BasicStage<float> &, QuietLeaves<dim> &)
  {
    Assert(false, dealii::ExcInternalError());
  }

  /// Batches that stages never touch, because they hold no gas.
  virtual std::vector<unsigned int> closed_batches() const
  {
    return {};
  }

  /// Computes stage.results.sensor and stage.results.signal_rate of
  /// stage.results.state.
  virtual void analyse(const BasicStage<double> &)
  {
    Assert(false, dealii::ExcInternalError());
  }
  virtual void analyse(const BasicStage<float> &)
  {
    Assert(false, dealii::ExcInternalError());
  }

  /// Owned leaves at boundaries with a state of their own; see
  /// QuietLeaves::reinit().
  std::vector<unsigned int> driven_leaves() const;

protected:
  const LeafMesh<dim> &mesh_;
  const LeafLayout layout_;
  const Boundary<dim> &boundary_;
};
} // namespace contrecoup::gas
