// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/memory.h>
#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Primitive quantities of all stored leaves in the state that a stage reads,
 * as [batch][point][component][lane]: the components of a point share a few
 * cache lines, where those of the state, [component][point][lane], lie a
 * multiple of 4096 bytes apart and displace each other from the cache. A batch
 * is converted when it is first asked for in a stage: each subcell once,
 * although the neighbours read it too (a leaf of 4^3 subcells reads 192 of its
 * neighbours').
 */
template <int dim, typename Gas, typename Real>
class PrimitiveField
{
public:
  static constexpr unsigned int nc = n_conserved<dim, Gas>;

  /// Index of a value in its batch, of lane 0.
  static constexpr std::size_t index(const unsigned int component,
                                     const unsigned int point)
  {
    return std::size_t(point * nc + component) * n_lanes<Real>;
  }

  PrimitiveField(const LeafLayout &layout, const Gas &gas)
    : layout_(layout)
    , gas_(gas)
  {}

  void reinit(const unsigned int n_stored_batches)
  {
    resize_in_large_pages(values_, n_stored_batches * layout_.batch_size());
    stage_of_.assign(n_stored_batches, 0);
    stage_ = 0;
  }

  /// Forgets the last state; @p state must hold its values until the next
  /// call.
  void begin_stage(const Real *state)
  {
    state_ = state;
    ++stage_;
  }

  /// Values of the batch; see index().
  const Real *batch(const unsigned int batch)
  {
    if (stage_of_[batch] != stage_)
    {
      stage_of_[batch] = stage_;
      convert(batch * layout_.batch_size());
    }
    return values_.data() + batch * layout_.batch_size();
  }

  /// Values of all batches that were asked for in this stage.
  const Real *data() const
  {
    return values_.data();
  }

private:
  void convert(const std::size_t first)
  {
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      std::array<Lanes<Real>, nc> u;
      for (unsigned int c = 0; c < nc; ++c)
        u[c].load(state_ + first + layout_.value(c, q));
      const auto p = to_primitive<dim>(gas_, u);
      for (unsigned int c = 0; c < nc; ++c)
        p[c].store(values_.data() + first + index(c, q));
    }
  }

  const LeafLayout layout_;
  const Gas gas_;
  const Real *state_ = nullptr;
  dealii::AlignedVector<Real> values_;
  std::vector<unsigned int> stage_of_; ///< in which a batch was converted
  unsigned int stage_ = 0;
};
} // namespace contrecoup::gas
