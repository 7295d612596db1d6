// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/gas_operator.h>
#include <contrecoup/gas/hanging_group.h>

#include <vector>

namespace contrecoup::gas
{
/// A gas operator made of a kernel for batches of leaves and one for
/// groups of hanging faces.
template <int dim,
          typename Gas,
          typename Kernel,
          typename HangingKernel,
          typename Real = double>
class LeafOperator : public GasOperator<dim>
{
public:
  using GasOperator<dim>::apply;
  using GasOperator<dim>::analyse;

  LeafOperator(const LeafMesh<dim> &mesh,
               const LeafLayout &layout,
               const Scheme &scheme,
               const Gas &gas,
               const Boundary<dim> &boundary)
    : mesh_(mesh)
    , layout_(layout)
    , kernel_(mesh, layout, scheme, gas, boundary)
    , hanging_kernel_(layout, scheme, gas)
  {}

  void reinit() override
  {
    groups_ = group_hanging_faces(mesh_, layout_);
    hanging_.resize(mesh_.hanging_faces().size(), layout_);
  }

  void apply(const BasicStage<Real> &stage) override
  {
    for (const auto &group : groups_)
      hanging_kernel_.compute(group, stage, hanging_);
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
      kernel_.update(batch, stage, hanging_);
  }

  void analyse(const BasicStage<Real> &stage) override
  {
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
      kernel_.analyse(batch, stage);
  }

private:
  const LeafMesh<dim> &mesh_;
  const LeafLayout layout_;
  Kernel kernel_;
  HangingKernel hanging_kernel_;
  std::vector<HangingGroup<dim>> groups_;
  HangingData<dim, Real> hanging_;
};
} // namespace contrecoup::gas
