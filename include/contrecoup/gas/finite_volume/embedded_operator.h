// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/state_redistribution.h>
#include <contrecoup/gas/finite_volume/embedded_kernel.h>
#include <contrecoup/gas/finite_volume/finite_volume_operator.h>

namespace contrecoup::gas
{
/// Finite volumes around a rigid body: the plain kernel where leaves are open,
/// another where they are cut, nothing where there is no gas.
///
/// Cut leaves stand in Morton order like all others, not in batches of their
/// own: batches with a cut leaf take 4 % of the time of the quickstart's blast.
template <int dim, typename Gas, typename Real = double>
class EmbeddedOperator : public FiniteVolumeOperator<dim, Gas, Real>
{
public:
  using Base = FiniteVolumeOperator<dim, Gas, Real>;

  EmbeddedOperator(const OperatorContext<dim> &context, const Gas &gas)
    : Base(context, gas)
    , cut_leaves_(*context.cut_leaves)
    , embedded_kernel_(context, gas, Base::primitives_)
  {}

  void reinit() override
  {
    Base::reinit();
    embedded_kernel_.reinit();
    reinit_openings();
    redistribution_.reinit(cut_leaves_, mesh_, layout_);
  }

  void apply(const BasicStage<Real> &stage,
             QuietLeaves<dim> &quiet_leaves) override
  {
    Base::begin_stage(stage, quiet_leaves);
    const auto compute_group = [&](const unsigned int g,
                                   const HangingGroup<dim> &group) {
      const int openings = openings_of_group_[g];
      hanging_kernel_.compute(
        group, stage, hanging_, openings < 0 ? nullptr : &openings_[openings]);
    };
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
    {
      schedule_.compute_before(batch, quiet_leaves, compute_group);
      if (quiet_leaves.is_active(batch) && !cut_leaves_.is_closed(batch))
      {
        if (cut_leaves_.is_cut(batch))
          embedded_kernel_.update(batch, stage, hanging_);
        else
        {
          kernel_.update(batch, stage, hanging_);
          quiet_leaves.find_woken_leaves(batch, stage.results.state);
        }
      }
    }
  }

  bool redistributes() const override
  {
    return true;
  }

  void redistribute(const BasicStage<Real> &stage,
                    QuietLeaves<dim> &quiet_leaves) override
  {
    redistribution_.apply(stage.results.state);
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
      if (quiet_leaves.is_active(batch) && cut_leaves_.is_cut(batch))
      {
        embedded_kernel_.conclude(batch, stage);
        quiet_leaves.find_woken_leaves(batch, stage.results.state);
      }
  }

  std::vector<unsigned int> closed_batches() const override
  {
    std::vector<unsigned int> result;
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
      if (cut_leaves_.is_closed(batch))
        result.push_back(batch);
    return result;
  }

  void analyse(const BasicStage<Real> &stage) override
  {
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
      if (cut_leaves_.is_cut(batch))
        embedded_kernel_.analyse(batch, stage);
      else if (!cut_leaves_.is_closed(batch))
        kernel_.analyse(batch, stage);
      else
        for (unsigned int lane = 0; lane < mesh_.width(); ++lane)
        {
          stage.results.signal_rate[batch * mesh_.width() + lane] = 0.;
          stage.results.sensor[batch * mesh_.width() + lane] = 0.;
        }
  }

private:
  using Base::hanging_;
  using Base::hanging_kernel_;
  using Base::kernel_;
  using Base::layout_;
  using Base::mesh_;
  using Base::schedule_;

  void reinit_openings()
  {
    openings_.clear();
    openings_of_group_.clear();
    for (const auto &group : schedule_.groups())
    {
      const bool is_cut = std::any_of(
        group.face.begin(),
        group.face.begin() + group.n_filled,
        [&](const unsigned int face) { return cut_leaves_.is_cut_face(face); });
      openings_of_group_.push_back(is_cut ? int(openings_.size()) : -1);
      if (is_cut)
      {
        openings_.emplace_back();
        openings_.back().reinit(group, mesh_, layout_, cut_leaves_);
      }
    }
  }

  const CutLeaves<dim> &cut_leaves_;
  std::vector<int> openings_of_group_; ///< index, or -1
  std::vector<HangingOpenings<dim, Real>> openings_;
  EmbeddedKernel<dim, Gas, Real> embedded_kernel_;
  StateRedistribution<dim> redistribution_;
};
} // namespace contrecoup::gas
