// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/image/label_grid.h>
#include <contrecoup/geometry/image/part_thickness.h>

#include <algorithm>
#include <limits>

namespace contrecoup
{
namespace
{
  /// Bounds the thickness at each voxel by the row of its part along an axis.
  /// @param size number of voxels along the axis
  /// @param stride from one of them to the next
  /// @param spacing [m]
  void bound_by_rows(const std::vector<unsigned char> &parts,
                     const std::size_t size,
                     const std::size_t stride,
                     const double spacing,
                     std::vector<float> &thickness)
  {
    for (std::size_t first = 0; first < parts.size(); ++first)
    {
      const std::size_t place = first / stride % size;
      if (parts[first] == LabelGrid::outside ||
          (place > 0 && parts[first - stride] == parts[first]))
        continue;
      std::size_t length = 1;
      while (place + length < size &&
             parts[first + length * stride] == parts[first])
        ++length;
      for (std::size_t i = 0; i < length; ++i)
      {
        float &known = thickness[first + i * stride];
        known = std::min(known, static_cast<float>(length * spacing));
      }
    }
  }
} // namespace


std::vector<double> part_thicknesses(const std::array<unsigned int, 3> &size,
                                     const std::array<double, 3> &spacing,
                                     const std::vector<unsigned char> &parts,
                                     const unsigned int n_parts)
{
  std::vector<float> thickness(parts.size(), std::numeric_limits<float>::max());
  std::size_t stride = 1;
  for (unsigned int d = 0; d < 3; ++d)
  {
    bound_by_rows(parts, size[d], stride, spacing[d], thickness);
    stride *= size[d];
  }
  std::vector<std::vector<float>> of_part(n_parts);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i] != LabelGrid::outside)
      of_part[parts[i]].push_back(thickness[i]);
  std::vector<double> medians;
  for (std::vector<float> &values : of_part)
  {
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    medians.push_back(values.empty() ? 0. : *middle);
  }
  return medians;
}
} // namespace contrecoup
