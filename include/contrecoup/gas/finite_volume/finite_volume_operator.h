// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/finite_volume/finite_volume_hanging.h>
#include <contrecoup/gas/finite_volume/finite_volume_kernel.h>
#include <contrecoup/gas/finite_volume/hanging_schedule.h>
#include <contrecoup/gas/stage/gas_operator.h>

namespace contrecoup::gas
{
/// Finite volumes on axis-aligned leaves without a body.
template <int dim, typename Gas, typename Real = double>
class FiniteVolumeOperator : public GasOperator<dim, Real>
{
public:
  FiniteVolumeOperator(const OperatorContext<dim> &context, const Gas &gas)
    : GasOperator<dim, Real>(context)
    , primitives_(layout_, gas)
    , kernel_(context, gas, primitives_)
    , hanging_kernel_(context, gas, primitives_)
  {}

  void reinit() override
  {
    primitives_.reinit(mesh_.n_stored_batches());
    schedule_.reinit(mesh_, layout_);
    hanging_.resize(mesh_.hanging_faces().size(), layout_);
  }

  void apply(const BasicStage<Real> &stage,
             QuietLeaves<dim> &quiet_leaves) override
  {
    begin_stage(stage, quiet_leaves);
    const auto compute_group = [&](const unsigned int,
                                   const HangingGroup<dim> &group) {
      hanging_kernel_.compute(group, stage, hanging_);
    };
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
    {
      schedule_.compute_before(batch, quiet_leaves, compute_group);
      if (quiet_leaves.is_active(batch))
      {
        kernel_.update(batch, stage, hanging_);
        quiet_leaves.find_woken_leaves(batch, stage.results.state);
      }
    }
  }

  void analyse(const BasicStage<Real> &stage) override
  {
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
      kernel_.analyse(batch, stage);
  }

protected:
  using GasOperator<dim, Real>::layout_;
  using GasOperator<dim, Real>::mesh_;

  void begin_stage(const BasicStage<Real> &stage,
                   QuietLeaves<dim> &quiet_leaves)
  {
    quiet_leaves.begin_stage(stage.in);
    primitives_.begin_stage(stage.in);
    schedule_.begin_stage();
  }

  PrimitiveField<dim, Gas, Real> primitives_;
  FiniteVolumeKernel<dim, Gas, Real> kernel_;
  FiniteVolumeHanging<dim, Gas, Real> hanging_kernel_;
  HangingSchedule<dim> schedule_;
  HangingData<dim, Real> hanging_;
};
} // namespace contrecoup::gas
