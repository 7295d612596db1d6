// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/finite_volume/hanging_schedule.h>
#include <contrecoup/gas/mapped/mapped_finite_volume_kernel.h>
#include <contrecoup/gas/mapped/mapped_hanging.h>
#include <contrecoup/gas/stage/gas_operator.h>

namespace contrecoup::gas
{
/// Finite volumes on leaves of any shape.
template <int dim, typename Gas, typename Real = double>
class MappedFiniteVolumeOperator : public GasOperator<dim, Real>
{
public:
  MappedFiniteVolumeOperator(const OperatorContext<dim> &context,
                             const Gas &gas)
    : GasOperator<dim, Real>(context)
    , primitives_(layout_, gas)
    , kernel_(context, gas)
    , hanging_kernel_(context, gas, primitives_)
  {}

  void reinit() override
  {
    schedule_.reinit(mesh_, layout_);
    hanging_.resize(mesh_.hanging_faces().size(), layout_);
    hanging_kernel_.reinit(mesh_, schedule_.groups());
    // Only hanging faces read them.
    primitives_.reinit(schedule_.groups().empty() ? 0
                                                  : mesh_.n_stored_batches());
  }

  void apply(const BasicStage<Real> &stage,
             QuietLeaves<dim> &quiet_leaves) override
  {
    quiet_leaves.begin_stage(stage.in);
    primitives_.begin_stage(stage.in);
    schedule_.begin_stage();
    const auto compute_group = [&](const unsigned int g,
                                   const HangingGroup<dim> &group) {
      hanging_kernel_.compute(g, group, stage, hanging_);
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

private:
  using GasOperator<dim, Real>::layout_;
  using GasOperator<dim, Real>::mesh_;

  PrimitiveField<dim, Gas, Real> primitives_;
  MappedFiniteVolumeKernel<dim, Gas, Real> kernel_;
  MappedHanging<dim, Gas, Real> hanging_kernel_;
  HangingSchedule<dim> schedule_;
  HangingData<dim, Real> hanging_;
};
} // namespace contrecoup::gas
