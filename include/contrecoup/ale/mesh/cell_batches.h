// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <contrecoup/ale/mesh/hex_space.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::ale
{
/**
 * The owned cells of a rank in batches of n cells of the same region, one cell
 * per SIMD lane. Unused lanes repeat the first cell of the batch with a weight
 * of zero.
 */
class CellBatches
{
public:
  using Lane = Lanes<double>;
  static constexpr unsigned int n = n_lanes<double>;

  /// The batches of one region.
  struct Range
  {
    unsigned int region;
    unsigned int begin;
    unsigned int end;
  };

  /// @param width numbers per node, for offsets()
  void reinit(const HexSpace &space, const unsigned int width);

  const std::vector<Range> &ranges() const
  {
    return ranges_;
  }

  unsigned int n_batches() const
  {
    return static_cast<unsigned int>(weights_.size());
  }

  /// Width times the node number of @p corner, for each lane.
  const unsigned int *offsets(const unsigned int batch,
                              const unsigned int corner) const
  {
    return &offsets_[(8 * batch + corner) * n];
  }

  /// The cells in the lanes of a batch.
  const unsigned int *cells(const unsigned int batch) const
  {
    return &cells_[batch * n];
  }

  /// 1 in lanes with a cell, 0 in unused lanes.
  const Lane &weight(const unsigned int batch) const
  {
    return weights_[batch];
  }

private:
  void add(const HexSpace &space,
           const std::vector<unsigned int> &cells,
           const unsigned int width);

  std::vector<Range> ranges_;
  std::vector<unsigned int> offsets_;
  std::vector<unsigned int> cells_;
  dealii::AlignedVector<Lane> weights_;
};
} // namespace contrecoup::ale
