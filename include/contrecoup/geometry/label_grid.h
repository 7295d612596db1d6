// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <array>
#include <cstddef>
#include <vector>

namespace contrecoup
{
/// A part number for each cube (voxel) of a regular grid; x runs fastest.
struct LabelGrid
{
  /// The label of what is outside of every part.
  static constexpr unsigned char nothing = 255;

  dealii::Point<3> origin; ///< the corner with the smallest coordinates [m]
  double spacing = 0.;     ///< length of an edge [m]
  std::array<unsigned int, 3> size{{0, 0, 0}}; ///< cubes by direction
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

  /// The label of a cube, also of one outside of the grid.
  unsigned char at_any(const int i, const int j, const int k) const;

  /// Centre of a cube [m].
  dealii::Point<3> center(const unsigned int i,
                          const unsigned int j,
                          const unsigned int k) const;

  double volume() const
  {
    return spacing * spacing * spacing;
  }
};

/**
 * An empty grid that covers a box with at least one cube to spare on every
 * side, placed so that faces of cubes lie on the bottom of the box, and that it
 * is symmetric about the middle of the box in x and y.
 * @throws InputError when it would have more than @p most_cubes
 */
LabelGrid make_grid(const dealii::BoundingBox<3> &box,
                    double spacing,
                    double most_cubes = 4e9);

/// Connected pieces of equal label (through faces), by label; the entry
/// LabelGrid::nothing has the pieces of the whole body.
std::array<unsigned int, 256> count_components(const LabelGrid &grid);
} // namespace contrecoup
