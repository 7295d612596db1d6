// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <vector>

namespace contrecoup::gas
{
/// How much of each point's volume is gas, where a rigid body takes up room.
class OpenFractions
{
public:
  /// Every point of @p n_leaves leaves, of @p n_points points each, is open.
  void reinit(const unsigned int n_leaves, const unsigned int n_points);

  /// Says that a leaf has no gas.
  void close(const unsigned int leaf)
  {
    place_[leaf] = closed;
  }

  /// Sets the fractions of a leaf's points, from 0 to 1.
  void set(const unsigned int leaf, const std::vector<double> &fractions);

  /// The open part of a point's volume [-].
  double operator()(const unsigned int leaf, const unsigned int point) const
  {
    const int place = place_[leaf];
    return place >= 0 ? fractions_[std::size_t(place) * n_points_ + point]
                      : (place == open ? 1. : 0.);
  }

  /// Whether all points of the leaf are gas throughout.
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
