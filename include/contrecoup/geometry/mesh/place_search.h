// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/point.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace contrecoup
{
/// Finds the nearest of many places by deal.II's tree, which sources that
/// include this header need not compile.
class PlaceSearch
{
public:
  explicit PlaceSearch(const std::vector<dealii::Point<3>> &places);

  /// Indices of the @p n places nearest to @p point [m], fewer if there are
  /// fewer, in no order.
  std::vector<std::size_t> nearest(const dealii::Point<3> &point,
                                   unsigned int n) const;

private:
  struct Tree;

  std::shared_ptr<const Tree> tree_;
};
} // namespace contrecoup
