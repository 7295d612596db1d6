// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/finite_volume/batch_sweep.h>
#include <contrecoup/gas/finite_volume/state_analysis.h>

namespace contrecoup::gas
{
/**
 * One stage of the finite-volume scheme on one batch of axis-aligned leaves
 * that are open throughout, in plane or curvilinear geometry. Reads two layers
 * of the neighbours; writes its own leaves only.
 */
template <int dim, typename Gas, typename Real = double>
class FiniteVolumeKernel
{
public:
  using Sweep = BatchSweep<dim, Gas, Real>;
  using Number = typename Sweep::Number;
  using Values = typename Sweep::Values;

  /// @param primitives of the state that stages read
  FiniteVolumeKernel(const OperatorContext<dim> &context,
                     const Gas &gas,
                     PrimitiveField<dim, Gas, Real> &primitives);

  /// Does @p stage on the leaves of @p batch.
  void update(const unsigned int batch,
              const BasicStage<Real> &stage,
              const HangingData<dim, Real> &hanging);

  /// Computes only sensor and signal rate of the state stage.results.state.
  void analyse(const unsigned int batch, const BasicStage<Real> &stage);

private:
  void sweep(const unsigned int batch,
             const unsigned int direction,
             const HangingData<dim, Real> &hanging);
  void write(const unsigned int batch, const BasicStage<Real> &stage);
  /// One, as all faces are open; see StateAnalysis::analyse().
  static Number is_open(const unsigned int, const unsigned int)
  {
    return Number(1.);
  }

  const LeafMesh<dim> &mesh_;
  const LeafLayout layout_;
  const Gas gas_;
  RadialWeights radial_;
  Sweep sweep_;
  StateAnalysis<dim, Gas, Real> state_analysis_;
};
} // namespace contrecoup::gas
