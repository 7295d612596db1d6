// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/hanging_group.h>
#include <contrecoup/gas/state/quiet_leaves.h>

#include <vector>

namespace contrecoup::gas
{
/// Groups of hanging faces, each of which a stage computes just before the
/// first batch that reads its fluxes: data that the group reads are still in
/// the cache when the batches next to it are computed.
template <int dim>
class HangingSchedule
{
public:
  void reinit(const LeafMesh<dim> &mesh, const LeafLayout &layout)
  {
    groups_ = group_hanging_faces(mesh, layout);
  }

  const std::vector<HangingGroup<dim>> &groups() const
  {
    return groups_;
  }

  void begin_stage()
  {
    next_ = 0;
  }

  /// Calls compute(g, groups()[g]) for each active group that @p batch or a
  /// batch before it reads first, and that this stage has not visited yet. Call
  /// with batches in ascending order.
  template <typename Compute>
  void compute_before(const unsigned int batch,
                      const QuietLeaves<dim> &quiet_leaves,
                      const Compute &compute)
  {
    for (; next_ < groups_.size() && groups_[next_].first_batch <= batch;
         ++next_)
      if (quiet_leaves.is_active_group(groups_[next_]))
        compute(next_, groups_[next_]);
  }

private:
  std::vector<HangingGroup<dim>> groups_; ///< ascending by first_batch
  unsigned int next_ = 0;                 ///< the next group of this stage
};
} // namespace contrecoup::gas
