// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/image/label_grid.h>

#include <cstdint>
#include <numeric>

namespace contrecoup
{
using dealii::Point;

unsigned char
LabelGrid::label_or_outside(const int i, const int j, const int k) const
{
  if (i < 0 || j < 0 || k < 0 || i >= static_cast<int>(size[0]) ||
      j >= static_cast<int>(size[1]) || k >= static_cast<int>(size[2]))
    return outside;
  return at(i, j, k);
}

Point<3> LabelGrid::center(const unsigned int i,
                           const unsigned int j,
                           const unsigned int k) const
{
  return Point<3>(origin[0] + (i + 0.5) * spacing,
                  origin[1] + (j + 0.5) * spacing,
                  origin[2] + (k + 0.5) * spacing);
}

LabelGrid make_grid(const dealii::BoundingBox<3> &box,
                    const double spacing,
                    const double most_cubes)
{
  const auto &[lower, upper] = box.get_boundary_points();
  LabelGrid grid;
  grid.spacing = spacing;
  double count = 1.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    // With an odd number of voxels, one is centred in the box.
    const bool is_odd = std::lround((upper[d] - lower[d]) / spacing) % 2 == 1;
    const double middle = 0.5 * (lower[d] + upper[d]);
    const double anchor =
      d == 2 ? lower[d] : middle - (is_odd ? 0.5 * spacing : 0.);
    // Round-off must not add a voxel.
    const double first = std::floor((lower[d] - anchor) / spacing + 1e-9) - 1.;
    const double last = std::ceil((upper[d] - anchor) / spacing - 1e-9) + 1.;
    grid.origin[d] = anchor + first * spacing;
    count *= last - first;
    if (!(count <= most_cubes))
      throw InputError(
        "elements of " + brief(spacing) + " m: the box around the body, " +
        brief(upper[0] - lower[0]) + " x " + brief(upper[1] - lower[1]) +
        " x " + brief(upper[2] - lower[2]) + " m, has more than " +
        brief(most_cubes) + " of them");
    grid.size[d] = static_cast<unsigned int>(last - first);
  }
  grid.labels.assign(static_cast<std::size_t>(count), LabelGrid::outside);
  return grid;
}

namespace
{
  /// Union-find structure for voxels.
  class DisjointSets
  {
  public:
    explicit DisjointSets(const std::size_t count)
      : parent_(count)
    {
      std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::uint32_t root(std::uint32_t i)
    {
      while (parent_[i] != i)
        i = parent_[i] = parent_[parent_[i]];
      return i;
    }

    void join(const std::uint32_t i, const std::uint32_t j)
    {
      const std::uint32_t a = root(i);
      const std::uint32_t b = root(j);
      parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
  };

  /// A run of voxels along x with one label, or of any part.
  struct Run
  {
    unsigned int begin;
    unsigned int end;
    unsigned char label;
  };

  std::vector<Run> runs_of_row(const LabelGrid &grid,
                               const unsigned int j,
                               const unsigned int k,
                               const bool whole)
  {
    std::vector<Run> runs;
    for (unsigned int i = 0; i < grid.size[0]; ++i)
    {
      unsigned char label = grid.at(i, j, k);
      if (label == LabelGrid::outside)
        continue;
      if (whole)
        label = 0;
      if (!runs.empty() && runs.back().end == i && runs.back().label == label)
        ++runs.back().end;
      else
        runs.push_back({i, i + 1, label});
    }
    return runs;
  }

  /// Joins touching runs of two adjacent rows.
  void join_rows(const std::vector<Run> &runs,
                 const std::size_t a_begin,
                 const std::size_t a_end,
                 const std::size_t b_begin,
                 const std::size_t b_end,
                 DisjointSets &sets)
  {
    std::size_t a = a_begin;
    std::size_t b = b_begin;
    while (a < a_end && b < b_end)
    {
      if (runs[a].begin < runs[b].end && runs[b].begin < runs[a].end &&
          runs[a].label == runs[b].label)
        sets.join(a, b);
      if (runs[a].end < runs[b].end)
        ++a;
      else
        ++b;
    }
  }

  /// Counts the connected pieces of each label.
  std::array<unsigned int, 256> count_pieces(const LabelGrid &grid,
                                             const bool whole)
  {
    std::vector<Run> runs;
    std::vector<std::size_t> starts;
    for (unsigned int k = 0; k < grid.size[2]; ++k)
      for (unsigned int j = 0; j < grid.size[1]; ++j)
      {
        starts.push_back(runs.size());
        const std::vector<Run> row = runs_of_row(grid, j, k, whole);
        runs.insert(runs.end(), row.begin(), row.end());
      }
    starts.push_back(runs.size());
    DisjointSets sets(runs.size());
    for (std::size_t row = 0; row + 1 < starts.size(); ++row)
    {
      if (row % grid.size[1] + 1 < grid.size[1])
        join_rows(runs,
                  starts[row],
                  starts[row + 1],
                  starts[row + 1],
                  starts[row + 2],
                  sets);
      if (row + grid.size[1] + 1 < starts.size())
        join_rows(runs,
                  starts[row],
                  starts[row + 1],
                  starts[row + grid.size[1]],
                  starts[row + grid.size[1] + 1],
                  sets);
    }
    std::array<unsigned int, 256> counts{};
    for (std::size_t run = 0; run < runs.size(); ++run)
      if (sets.root(run) == run)
        ++counts[runs[run].label];
    return counts;
  }
} // namespace

std::array<unsigned int, 256> count_components(const LabelGrid &grid)
{
  std::array<unsigned int, 256> counts = count_pieces(grid, false);
  counts[LabelGrid::outside] = count_pieces(grid, true)[0];
  return counts;
}
} // namespace contrecoup
