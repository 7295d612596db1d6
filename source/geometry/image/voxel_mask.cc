// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/image/voxel_mask.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup
{
namespace
{
  constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Work space for one line of voxels.
  struct Line
  {
    std::vector<double> values;
    std::vector<double> result;
    std::vector<std::size_t> vertices;
    std::vector<double> borders;
  };

  /// Replaces squared distances along a line by min_j (values_j + (i - j)^2
  /// spacing^2).
  void transform(Line &line, const double spacing)
  {
    const std::size_t n = line.values.size();
    line.vertices.clear();
    line.borders.clear();
    const auto crossing = [&](const std::size_t a, const std::size_t b) {
      const double xa = a * spacing;
      const double xb = b * spacing;
      return 0.5 * (line.values[b] - line.values[a] + xb * xb - xa * xa) /
             (xb - xa);
    };
    for (std::size_t i = 0; i < n; ++i)
    {
      if (line.values[i] == infinity)
        continue;
      while (!line.vertices.empty() &&
             crossing(line.vertices.back(), i) <= line.borders.back())
      {
        line.vertices.pop_back();
        line.borders.pop_back();
      }
      line.borders.push_back(
        line.vertices.empty() ? -infinity : crossing(line.vertices.back(), i));
      line.vertices.push_back(i);
    }
    line.result.assign(n, infinity);
    if (line.vertices.empty())
      return;
    for (std::size_t i = 0, piece = 0; i < n; ++i)
    {
      while (piece + 1 < line.vertices.size() &&
             line.borders[piece + 1] < i * spacing)
        ++piece;
      const std::size_t vertex = line.vertices[piece];
      const double way = (static_cast<double>(i) - vertex) * spacing;
      line.result[i] = line.values[vertex] + way * way;
    }
  }

  /// Calls @p visit for the six neighbours of a voxel.
  template <typename Visit>
  void visit_neighbors(const std::array<unsigned int, 3> &size,
                       const std::size_t voxel,
                       const Visit &visit)
  {
    std::size_t stride = 1;
    std::size_t rest = voxel;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const std::size_t i = rest % size[d];
      if (i > 0)
        visit(voxel - stride);
      if (i + 1 < size[d])
        visit(voxel + stride);
      rest /= size[d];
      stride *= size[d];
    }
  }

  /// Adds to @p found all voxels of @p mask that are connected to @p front.
  std::size_t flood(const VoxelMask &mask,
                    std::vector<std::size_t> front,
                    std::vector<unsigned char> &found)
  {
    for (const std::size_t voxel : front)
      found[voxel] = 1;
    std::size_t count = 0;
    while (!front.empty())
    {
      const std::size_t voxel = front.back();
      front.pop_back();
      ++count;
      visit_neighbors(mask.size, voxel, [&](const std::size_t other) {
        if (mask.inside[other] && !found[other])
        {
          found[other] = 1;
          front.push_back(other);
        }
      });
    }
    return count;
  }

  /// Calls @p visit with the number of each voxel, and with its number in the
  /// padded grid.
  template <typename Visit>
  void for_each_padded(const VoxelMask &mask,
                       const std::size_t layers,
                       const Visit &visit)
  {
    const std::size_t row = mask.size[0] + 2 * layers;
    const std::size_t sheet = row * (mask.size[1] + 2 * layers);
    std::size_t i = 0;
    for (std::size_t z = 0; z < mask.size[2]; ++z)
      for (std::size_t y = 0; y < mask.size[1]; ++y)
        for (std::size_t x = 0; x < mask.size[0]; ++x, ++i)
          visit(i, x + layers + row * (y + layers) + sheet * (z + layers));
  }
} // namespace


std::size_t VoxelMask::count() const
{
  return std::count(inside.begin(), inside.end(), 1);
}

VoxelMask VoxelMask::complement() const
{
  VoxelMask other = *this;
  for (unsigned char &voxel : other.inside)
    voxel = 1 - voxel;
  return other;
}

std::vector<float> distance_to(const VoxelMask &mask)
{
  std::vector<float> squares(mask.inside.size());
  for (std::size_t i = 0; i < squares.size(); ++i)
    squares[i] = mask.inside[i] ? 0.F : std::numeric_limits<float>::infinity();
  Line line;
  std::size_t stride = 1;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const std::size_t n = mask.size[d];
    line.values.resize(n);
    for (std::size_t first = 0; first < squares.size(); ++first)
    {
      // Only voxels with index 0 in this direction start a line.
      if (first / stride % n != 0)
        continue;
      for (std::size_t i = 0; i < n; ++i)
        line.values[i] = squares[first + i * stride];
      transform(line, mask.spacing[d]);
      for (std::size_t i = 0; i < n; ++i)
        squares[first + i * stride] = static_cast<float>(line.result[i]);
    }
    stride *= n;
  }
  for (float &value : squares)
    value = std::sqrt(value);
  return squares;
}

VoxelMask grown(const VoxelMask &mask, const double distance)
{
  VoxelMask result = mask;
  const std::vector<float> distances = distance_to(mask);
  for (std::size_t i = 0; i < distances.size(); ++i)
    result.inside[i] = distances[i] <= distance * (1. + 1e-6);
  return result;
}

VoxelMask padded(const VoxelMask &mask, const unsigned int layers)
{
  VoxelMask result{mask.size, mask.spacing, {}};
  for (unsigned int &n : result.size)
    n += 2 * layers;
  result.inside.assign(
    std::size_t(result.size[0]) * result.size[1] * result.size[2], 0);
  for_each_padded(mask, layers, [&](const std::size_t i, const std::size_t j) {
    result.inside[j] = mask.inside[i];
  });
  return result;
}

VoxelMask closed(const VoxelMask &mask, const double distance)
{
  const double finest =
    std::min({mask.spacing[0], mask.spacing[1], mask.spacing[2]});
  const auto layers = static_cast<unsigned int>(distance / finest) + 1;
  const VoxelMask dilated = grown(padded(mask, layers), distance);
  const VoxelMask outside = grown(dilated.complement(), distance);
  VoxelMask result = mask;
  for_each_padded(mask, layers, [&](const std::size_t i, const std::size_t j) {
    result.inside[i] = 1 - outside.inside[j];
  });
  return result;
}

VoxelMask largest_piece(const VoxelMask &mask)
{
  std::vector<unsigned char> found(mask.inside.size(), 0);
  std::size_t most = 0;
  std::size_t seed = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (mask.inside[i] && !found[i])
    {
      const std::size_t count = flood(mask, {i}, found);
      if (count > most)
      {
        most = count;
        seed = i;
      }
    }
  VoxelMask best = mask;
  std::fill(best.inside.begin(), best.inside.end(), 0);
  if (most > 0)
    flood(mask, {seed}, best.inside);
  return best;
}

VoxelMask with_filled_holes(const VoxelMask &mask)
{
  const VoxelMask outside = mask.complement();
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < outside.inside.size(); ++i)
  {
    const std::size_t x = i % mask.size[0];
    const std::size_t y = i / mask.size[0] % mask.size[1];
    const std::size_t z = i / mask.size[0] / mask.size[1];
    const bool is_at_side = x == 0 || x + 1 == mask.size[0] || y == 0 ||
                            y + 1 == mask.size[1] || z + 1 == mask.size[2];
    if (is_at_side && outside.inside[i])
      front.push_back(i);
  }
  VoxelMask reached = mask;
  std::fill(reached.inside.begin(), reached.inside.end(), 0);
  flood(outside, front, reached.inside);
  return reached.complement();
}
} // namespace contrecoup
