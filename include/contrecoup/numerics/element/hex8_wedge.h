// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/hex8_geometry.h>

namespace contrecoup
{
/**
 * A wedge one cell thick about an axis, for axisymmetric problems. Its
 * mid-plane contains the axis and the direction `out`; its sides are at |side|
 * = slope * out. Nodes move along the sides, so that cells have the gradients
 * of cells of revolution for any slope; radial motion has 1 + slope^2 times
 * its kinetic energy. The second direction of each cell leads from one side to
 * the other.
 */
struct HexWedge
{
  unsigned int axis = 2; ///< 0 to 2
  double slope = 0.;     ///< 0: no wedge [-]

  bool active() const
  {
    return slope > 0.;
  }
  unsigned int out() const
  {
    return (axis + 1) % 3;
  }
  unsigned int side() const
  {
    return (axis + 2) % 3;
  }

  /// Keeps only the hourglass mode within the meridional section; the others
  /// represent rotations of the section.
  template <typename Number>
  void restrict_modes(std::array<Vector3<Number>, 4> &modes) const
  {
    if (active())
      modes[0] = modes[2] = modes[3] =
        Vector3<Number>{{Number(), Number(), Number()}};
  }

  /// Computes lengths from motion along the sides, excluding the width.
  template <typename Number>
  void restrict_lengths(HexGeometry<Number> &g) const
  {
    if (!active())
      return;
    const auto &v = g.volume_gradient;
    const Number tangent(slope);
    // Motion along `out` also moves corners along `side`.
    const std::array<Number, 4> radial{{tangent * v[1][side()],
                                        v[0][out()] + tangent * v[5][side()],
                                        v[2][out()] + tangent * v[3][side()],
                                        v[4][out()]}};
    Number sum = v[0][axis] * v[0][axis] + v[2][axis] * v[2][axis] +
                 v[4][axis] * v[4][axis];
    for (const Number &part : radial)
      sum += part * part;
    g.gradient_square = Number(8.) * sum;
  }
};
} // namespace contrecoup
