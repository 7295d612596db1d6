// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

namespace contrecoup
{
/// Ellipsoids around the origin, one in the other, to be filled with hexahedra.
struct LayeredBall
{
  /// Semi-axes of the outer surface of the core and of each layer around it,
  /// the core first [m].
  std::vector<std::array<double, 3>> semi_axes;
  /// Cells across each layer, the core's between its inner cube and its surface
  /// first.
  std::vector<unsigned int> cells_across;
  /// Cells along an edge of the inner cube, even.
  unsigned int cells_along_cube = 8;
  /// Directions, x to z, in which only the half of positive coordinates is
  /// made.
  std::array<bool, 3> is_halved{{false, false, false}};
};

/**
 * A conforming mesh of a cube in the core and six blocks around it that go
 * through all layers. Material ids are 0 for the core and count the layers;
 * boundary id 0 is the outer surface, 1, 2, 3 are the planes x, y, z = 0 where
 * the ball is halved.
 * @throws InputError for axes that do not grow, or numbers of cells that are
 * not above 0
 */
void make_layered_ball(const LayeredBall &ball, dealii::Triangulation<3> &mesh);
} // namespace contrecoup
