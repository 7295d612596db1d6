// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/grid_distance.h>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// Margin of voxels on every side, so that the grid contains the surface.
  constexpr unsigned int padding = 2;

  /// Smooths with weights 1/4, 1/2, 1/4 along one direction; ends keep their
  /// values.
  void smooth_along(std::vector<float> &values,
                    const std::size_t stride,
                    const std::size_t n)
  {
    const std::vector<float> before = values;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const std::size_t location = i / stride % n;
      if (location > 0 && location + 1 < n)
        values[i] = 0.25F * before[i - stride] + 0.5F * before[i] +
                    0.25F * before[i + stride];
    }
  }
} // namespace


GridDistance::GridDistance(const VoxelMask &mask,
                           const Tensor<2, 3> &axes,
                           const Tensor<1, 3> &origin)
  : spacing_(mask.spacing)
{
  const VoxelMask padded = contrecoup::padded(mask, padding);
  size_ = padded.size;
  for (unsigned int row = 0; row < 3; ++row)
    for (unsigned int column = 0; column < 3; ++column)
      rotation_[row][column] = axes[row][column] / spacing_[column];
  origin_ = origin - axes * Point<3>(padding, padding, padding);
  const std::vector<float> to_inside = distance_to(padded);
  const std::vector<float> to_outside = distance_to(padded.complement());
  const double half = 0.5 * std::min({spacing_[0], spacing_[1], spacing_[2]});
  values_.resize(padded.inside.size());
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] = padded.inside[i] ? half - to_outside[i] : to_inside[i] - half;
  smooth(padded);
  limit_slope();

  std::vector<Point<3>> corners;
  for (std::size_t i = 0, z = 0; z < mask.size[2]; ++z)
    for (unsigned int y = 0; y < mask.size[1]; ++y)
      for (unsigned int x = 0; x < mask.size[0]; ++x, ++i)
        if (mask.inside[i])
          corners.emplace_back(origin + axes * Point<3>(x, y, z));
  // Up to the faces of voxels, whose centres are in the box so far.
  Tensor<1, 3> half_voxel;
  for (unsigned int row = 0; row < 3; ++row)
    for (unsigned int column = 0; column < 3; ++column)
      half_voxel[row] += 0.5 * std::abs(axes[row][column]);
  const auto [lower, upper] =
    dealii::BoundingBox<3>(corners).get_boundary_points();
  box_ = dealii::BoundingBox<3>(
    std::make_pair(lower - half_voxel, upper + half_voxel));
}

void GridDistance::smooth(const VoxelMask &padded)
{
  std::size_t stride = 1;
  for (unsigned int d = 0; d < 3; ++d)
  {
    smooth_along(values_, stride, size_[d]);
    stride *= size_[d];
  }
  // Preserve thin parts and narrow gaps.
  const float least = static_cast<float>(
    0.05 * std::min({spacing_[0], spacing_[1], spacing_[2]}));
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] = padded.inside[i] ? std::min(values_[i], -least)
                                  : std::max(values_[i], least);
}

void GridDistance::limit_slope()
{
  // A trilinear function has its largest slope at a corner of its cell.
  double largest = 1.;
  std::size_t i = 0;
  for (std::size_t z = 0; z < size_[2]; ++z)
    for (std::size_t y = 0; y < size_[1]; ++y)
      for (std::size_t x = 0; x < size_[0]; ++x, ++i)
      {
        const std::array<std::size_t, 3> location{{x, y, z}};
        double square = 0.;
        std::size_t stride = 1;
        for (unsigned int d = 0; d < 3; ++d)
        {
          double steepest = 0.;
          if (location[d] > 0)
            steepest = std::abs(values_[i] - values_[i - stride]);
          if (location[d] + 1 < size_[d])
            steepest = std::max<double>(
              steepest, std::abs(values_[i + stride] - values_[i]));
          square += std::pow(steepest / spacing_[d], 2);
          stride *= size_[d];
        }
        largest = std::max(largest, square);
      }
  const float factor = static_cast<float>(1. / std::sqrt(largest));
  for (float &value : values_)
    value *= factor;
}

GridDistance::GridLocation GridDistance::locate(const Point<3> &point) const
{
  const Tensor<1, 3> offset = transpose(rotation_) * (point - origin_);
  GridLocation location;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double last = (size_[d] - 1) * spacing_[d];
    const double inside = std::min(std::max(offset[d], 0.), last);
    location.beyond[d] = offset[d] - inside;
    const double index = inside / spacing_[d];
    location.cell[d] =
      std::min<std::size_t>(static_cast<std::size_t>(index), size_[d] - 2);
    location.fraction[d] = index - location.cell[d];
  }
  return location;
}

double GridDistance::corner(const GridLocation &location,
                            const unsigned int c) const
{
  const std::size_t x = location.cell[0] + (c & 1);
  const std::size_t y = location.cell[1] + ((c >> 1) & 1);
  const std::size_t z = location.cell[2] + ((c >> 2) & 1);
  return values_[x + size_[0] * (y + size_[1] * z)];
}

double GridDistance::interpolate(const GridLocation &location) const
{
  double sum = 0.;
  for (unsigned int c = 0; c < 8; ++c)
  {
    double weight = 1.;
    for (unsigned int d = 0; d < 3; ++d)
      weight *= (c >> d) & 1 ? location.fraction[d] : 1. - location.fraction[d];
    sum += weight * corner(location, c);
  }
  return sum;
}

Tensor<1, 3> GridDistance::slope(const GridLocation &location) const
{
  Tensor<1, 3> sum;
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int along = 0; along < 3; ++along)
    {
      double weight = ((c >> along) & 1 ? 1. : -1.) / spacing_[along];
      for (unsigned int d = 0; d < 3; ++d)
        if (d != along)
          weight *=
            (c >> d) & 1 ? location.fraction[d] : 1. - location.fraction[d];
      sum[along] += weight * corner(location, c);
    }
  return sum;
}

double GridDistance::value(const Point<3> &point) const
{
  const GridLocation location = locate(point);
  const double inner = interpolate(location);
  const double beyond = location.beyond.norm();
  // The body lies in the convex grid, so the two legs enclose an angle of at
  // least 90 degrees.
  return beyond > 0. ? std::hypot(inner, beyond) : inner;
}

Tensor<1, 3> GridDistance::gradient(const Point<3> &point) const
{
  const GridLocation location = locate(point);
  const double beyond = location.beyond.norm();
  Tensor<1, 3> inner = slope(location);
  if (beyond == 0.)
    return rotation_ * inner;
  // Beyond a side of the grid, only the outer leg varies normal to it.
  for (unsigned int d = 0; d < 3; ++d)
    if (location.beyond[d] != 0.)
      inner[d] = 0.;
  const double value = interpolate(location);
  return rotation_ *
         ((value * inner + location.beyond) / std::hypot(value, beyond));
}

dealii::BoundingBox<3> GridDistance::bounding_box() const
{
  return box_;
}
} // namespace contrecoup
