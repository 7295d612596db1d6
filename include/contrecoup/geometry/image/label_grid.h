// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <array>
#include <cstddef>
#include <vector>

namespace contrecoup
{
/// Part numbers of the cubic voxels of a regular grid; x runs fastest.
struct LabelGrid
{
  /// Label of voxels outside of all parts.
  static constexpr unsigned char outside = 255;

  dealii::Point<3> origin; ///< corner with the smallest coordinates [m]
  double spacing = 0.;     ///< edge length of a voxel [m]
  std::array<unsigned int, 3> size{{0, 0, 0}}; ///< voxels per direction
  std::vector<unsigned char> labels;

  std::size_t
  index(const unsigned int i, const unsigned int j, const unsigned int k) const
  {
    return i + size[0] * (j + static_cast<std::size_t>(size[1]) * k);
  }

  unsigned char
  at(const unsigned int i, const unsigned int j, const unsigned int k) const
  {
    return labels[index(i, j, k)];
  }

  /// Label of a voxel; `outside` beyond the grid.
  unsigned char label_or_outside(const int i, const int j, const int k) const;

  /// Centre of a voxel [m].
  dealii::Point<3> center(const unsigned int i,
                          const unsigned int j,
                          const unsigned int k) const;

  double volume() const
  {
    return spacing * spacing * spacing;
  }
};

/**
 * Creates an empty grid that covers a box with a margin of at least one voxel.
 * Voxel faces lie on the bottom of the box, and the grid is symmetric about
 * the centre of the box in x and y.
 * @throws InputError for more than @p most_cubes voxels
 */
LabelGrid make_grid(const dealii::BoundingBox<3> &box,
                    double spacing,
                    double most_cubes = 4e9);

/// Number of face-connected pieces of each label; entry LabelGrid::outside is
/// that of the whole body.
std::array<unsigned int, 256> count_components(const LabelGrid &grid);
} // namespace contrecoup
