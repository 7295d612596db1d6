// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes.h>

#include <contrecoup/ale/mesh/hex_space.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::ale
{
/**
 * The own cells of a rank, as many side by side as the processor has lanes, all
 * of one region. Lanes that are left over repeat the first cell of their batch,
 * with a weight of zero.
 */
class CellBatches
{
public:
  using Lane = Lanes<double>;
  static constexpr unsigned int n = n_lanes<double>;

  /// Batches of one region.
  struct Range
  {
    unsigned int region;
    unsigned int begin;
    unsigned int end;
  };

  /// @param width numbers at each node, for the offsets
  void reinit(const HexSpace &space, const unsigned int width);

  const std::vector<Range> &ranges() const
  {
    return ranges_;
  }

  unsigned int n_batches() const
  {
    return static_cast<unsigned int>(weights_.size());
  }

  /// Width times the nodes, of a corner in all lanes.
  const unsigned int *offsets(const unsigned int batch,
                              const unsigned int corner) const
  {
    return &offsets_[(8 * batch + corner) * n];
  }

  /// The cells in the lanes.
  const unsigned int *cells(const unsigned int batch) const
  {
    return &cells_[batch * n];
  }

  /// One for cells, zero for lanes that are left over.
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
