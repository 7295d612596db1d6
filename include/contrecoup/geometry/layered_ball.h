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
  /// Axis of revolution about which a wedge one cell thick is made, 0 to 2; 3:
  /// there is none. The ball must then be halved in the two directions across.
  unsigned int wedge_axis = 3;
  double wedge_slope = 0.; ///< of the sides of the wedge to its middle [-]

  /// The directions across the axis of a wedge: the one that its middle holds,
  /// and the one that its middle is normal to.
  unsigned int across_middle() const
  {
    return (wedge_axis + 1) % 3;
  }
  unsigned int normal_to_middle() const
  {
    return (wedge_axis + 2) % 3;
  }
};

/**
 * A conforming mesh of a cube in the core and six blocks around it that go
 * through all layers. Material ids are 0 for the core and count the layers;
 * boundary id 0 is the outer surface, 1, 2, 3 are the planes x, y, z = 0 where
 * the ball is halved.
 *
 * A wedge has the cells that meet the half plane through its axis, turned by
 * half its angle to either side; what lies within a hundredth of a cell of the
 * axis is left out. Its two sides have the id of the plane that its middle is
 * in, and the thin prism at its axis that of the other plane through the axis.
 * @throws InputError for axes that do not grow, numbers of cells that are not
 * above 0, and a wedge of ellipsoids that are not round about its axis
 */
void make_layered_ball(const LayeredBall &ball, dealii::Triangulation<3> &mesh);
} // namespace contrecoup
