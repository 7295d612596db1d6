// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

namespace contrecoup
{
/// Concentric ellipsoids around the origin, for a hexahedral mesh.
struct LayeredBall
{
  /// Semi-axes of the outer surface of the core and of each layer, from the
  /// inside outwards [m].
  std::vector<std::array<double, 3>> semi_axes;
  /// Number of cells across each layer; the first entry counts the cells of
  /// the core between its inner cube and its surface.
  std::vector<unsigned int> cells_across;
  /// Number of cells along an edge of the inner cube; even.
  unsigned int cells_along_cube = 8;
  /// Directions x to z in which only the half with positive coordinates is
  /// meshed.
  std::array<bool, 3> is_halved{{false, false, false}};
  /// Axis (0 to 2) of a wedge one cell thick; 3: no wedge. A wedge requires
  /// halving in the two other directions.
  unsigned int wedge_axis = 3;
  /// of the sides of the wedge against its mid-plane [-]
  double wedge_slope = 0.;

  /// Directions across the axis of a wedge: in its mid-plane, and normal to
  /// its mid-plane.
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
 * Builds a conforming mesh of a cube in the core and six blocks around it,
 * which pass through all layers. Material ids are layer numbers, 0 for the
 * core. Boundary id 0 is the outer surface; 1, 2, 3 are the planes x, y, z = 0
 * of a halved ball.
 *
 * A wedge consists of the cells along a half plane through its axis, with the
 * nodes rotated by half the wedge angle to both sides. A thin prism around the
 * axis, a hundredth of a cell in radius, is left out. The two sides have the
 * boundary id of the plane that contains the wedge's mid-plane; the prism at
 * the axis has that of the other plane through the axis.
 * @throws InputError for semi-axes that do not grow, for numbers of cells that
 * are not positive, and for a wedge of ellipsoids that are not axisymmetric
 */
void make_layered_ball(const LayeredBall &ball, dealii::Triangulation<3> &mesh);
} // namespace contrecoup
