// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <memory>
#include <vector>

namespace contrecoup
{
/// Tells whether triangles stand between two places.
class LineOfSight
{
public:
  using Triangle = std::array<dealii::Point<3>, 3>;

  explicit LineOfSight(std::vector<Triangle> triangles);

  /// Whether a triangle meets the segment between two places [m].
  bool is_blocked(const dealii::Point<3> &from,
                  const dealii::Point<3> &to) const;

private:
  struct Search;

  std::vector<Triangle> triangles_;
  std::shared_ptr<const Search> search_;
};
} // namespace contrecoup
