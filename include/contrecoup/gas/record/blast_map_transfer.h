// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/record/blast_maps.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/**
 * Interpolates and restricts maps when leaves are refined and coarsened, such
 * that no peak is lost. A child's point takes the record of the parent's point
 * around it. A parent's point takes the largest peak, the earliest arrival and
 * the mean impulse of the children's points in its volume; its positive phase
 * ends when the last of theirs does. Leaf values are [value][point].
 */
template <int dim>
class BlastMapTransfer
{
public:
  static constexpr unsigned int n_children = 1U << dim;

  explicit BlastMapTransfer(const LeafPoints<dim> &points);

  std::vector<std::vector<float>>
  to_children(const std::vector<float> &parent) const;

  std::vector<float>
  from_children(const std::vector<std::vector<float>> &children) const;

private:
  using Record = BlastRecord<float>;

  /// Point of a child that overlaps a point of the parent.
  struct Contribution
  {
    unsigned int child;
    unsigned int point;
    double fraction; ///< fraction of the parent's point's volume [-]
  };

  Record merged(const std::vector<std::vector<float>> &children,
                const unsigned int point) const;

  unsigned int n_points_;
  /// Point of the parent around a point of a child, [child][point].
  std::array<std::vector<unsigned int>, n_children> around_;
  /// Points of children in each point of the parent.
  std::vector<std::vector<Contribution>> contributions_;
};
} // namespace contrecoup::gas
