// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <vector>

namespace contrecoup::gas
{
/// Fraction of each point's volume that is gas, where a rigid body cuts or
/// covers leaves.
class OpenFractions
{
public:
  /// Marks all points of @p n_leaves leaves, with @p n_points points each, as
  /// open.
  void reinit(const unsigned int n_leaves, const unsigned int n_points);

  /// Marks a leaf as closed: it has no gas.
  void close(const unsigned int leaf)
  {
    place_[leaf] = closed;
  }

  /// Sets the open fractions of the points of a leaf, from 0 to 1.
  void set(const unsigned int leaf, const std::vector<double> &fractions);

  /// Open fraction of a point's volume [-].
  double operator()(const unsigned int leaf, const unsigned int point) const
  {
    const int place = place_[leaf];
    return place >= 0 ? fractions_[std::size_t(place) * n_points_ + point]
                      : (place == open ? 1. : 0.);
  }

  /// Whether all points of the leaf are completely gas.
  bool is_open(const unsigned int leaf) const
  {
    return place_[leaf] == open;
  }
  /// Whether the leaf has no gas at all.
  bool is_closed(const unsigned int leaf) const
  {
    return place_[leaf] == closed;
  }

private:
  static constexpr int open = -1;
  static constexpr int closed = -2;

  unsigned int n_points_ = 1;
  std::vector<int> place_; ///< per leaf: row of fractions_, open or closed
  std::vector<double> fractions_;
};
} // namespace contrecoup::gas
