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
 * Carries maps over when leaves are halved and merged, such that no peak is
 * lost: a child's point takes the record of the parent's point around it; a
 * parent's point takes the largest peak, the earliest arrival and the mean
 * impulse of the children's points in its part of the leaf, and its positive
 * phase ends when the last of theirs does. Leaf values are [value][point].
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

  /// A point of a child in the part of the leaf of a parent's point.
  struct Contribution
  {
    unsigned int child;
    unsigned int point;
    double part; ///< of the volume of the parent's point [-]
  };

  Record merged(const std::vector<std::vector<float>> &children,
                const unsigned int point) const;

  unsigned int n_points_;
  /// The parent's point around a point of a child, [child][point].
  std::array<std::vector<unsigned int>, n_children> around_;
  /// What makes up each of the parent's points.
  std::vector<std::vector<Contribution>> contributions_;
};
} // namespace contrecoup::gas
