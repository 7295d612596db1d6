// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/kernel/gas_operator.h>
#include <contrecoup/gas/octree/hanging_group.h>

#include <algorithm>
#include <vector>

namespace contrecoup::gas
{
/// Owned leaves at boundaries with a state of their own; see
/// QuietLeaves::reinit().
template <int dim>
std::vector<unsigned int>
leaves_at_driven_boundaries(const LeafMesh<dim> &mesh,
                            const Boundary<dim> &boundary)
{
  std::vector<unsigned int> result;
  for (unsigned int batch = 0; batch < mesh.n_batches(); ++batch)
    for (auto s = mesh.special_begin(batch); s != mesh.special_end(batch); ++s)
      if (s->kind == SpecialFace::Kind::boundary &&
          boundary.kind(s->index) != Boundary<dim>::Kind::wall &&
          boundary.kind(s->index) != Boundary<dim>::Kind::open)
        result.push_back(batch * mesh.width() + s->lane);
  return result;
}

/// Whether a batch that is active meets a face of the group.
template <int dim>
bool is_active(const HangingGroup<dim> &group,
               const QuietLeaves<dim> &quiet_leaves)
{
  return std::any_of(
    group.face.begin(),
    group.face.begin() + group.n_filled,
    [&](const unsigned int face) { return quiet_leaves.is_active_face(face); });
}

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
    , boundary_(boundary)
  {}

  void reinit() override
  {
    groups_ = group_hanging_faces(mesh_, layout_);
    hanging_.resize(mesh_.hanging_faces().size(), layout_);
  }

  void apply(const BasicStage<Real> &stage,
             QuietLeaves<dim> &quiet_leaves) override
  {
    quiet_leaves.begin_stage(stage.in);
    compute_hanging_faces(stage, quiet_leaves);
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
      if (quiet_leaves.is_active(batch))
      {
        kernel_.update(batch, stage, hanging_);
        quiet_leaves.find_woken_leaves(batch, stage.results.state);
      }
  }

  void analyse(const BasicStage<Real> &stage) override
  {
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
      kernel_.analyse(batch, stage);
  }

  std::vector<unsigned int> driven_leaves() const override
  {
    return leaves_at_driven_boundaries(mesh_, boundary_);
  }

protected:
  void compute_hanging_faces(const BasicStage<Real> &stage,
                             const QuietLeaves<dim> &quiet_leaves)
  {
    for (const auto &group : groups_)
      if (is_active(group, quiet_leaves))
        hanging_kernel_.compute(group, stage, hanging_);
  }

  const LeafMesh<dim> &mesh_;
  const LeafLayout layout_;
  Kernel kernel_;
  HangingKernel hanging_kernel_;
  std::vector<HangingGroup<dim>> groups_;
  HangingData<dim, Real> hanging_;

private:
  const Boundary<dim> &boundary_;
};
} // namespace contrecoup::gas
