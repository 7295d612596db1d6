// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/hourglass.h>

namespace contrecoup
{
/**
 * Hourglass forces on the hourglass modes @p q in the axes of a brick, from
 * assumed strains after Belytschko and Bindeman 1993 (quintessential bending):
 * isochoric bending and torsion. Bending along an edge has the modulus 3 G
 * (Young's modulus of an incompressible solid), torsion is shear by sums of
 * two modes, and neither has parasitic shear.
 * @param shear G times the coefficient [Pa]
 * @param half half edge lengths [m]
 */
template <typename Number>
inline DEAL_II_ALWAYS_INLINE std::array<Vector3<Number>, 4>
brick_forces(const Number &shear,
             const Vector3<Number> &half,
             const std::array<Vector3<Number>, 4> &q)
{
  const Number volume = Number(8.) * half[0] * half[1] * half[2];
  // Means of eta^2 and (eta zeta)^2, and the factor 8 of modes twice.
  const Number third = volume * shear * Number(1. / 3. / 64.);
  Vector3<Number> inverse;
  for (unsigned int d = 0; d < 3; ++d)
    inverse[d] = Number(1.) / half[d];
  std::array<Vector3<Number>, 4> force;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
    const Number stretch = Number(3.) * third * inverse[d] * inverse[d];
    // Component d bends in the modes of the two planes that contain edge d.
    force[e][d] = stretch * q[e][d];
    force[f][d] = stretch * q[f][d];
    force[3][d] = Number(1. / 3.) * stretch * q[3][d];
  }
  Vector3<Number> twist; // from the shears in planes (d, e), along edge f
  for (unsigned int d = 0; d < 3; ++d)
  {
    const unsigned int e = (d + 1) % 3;
    twist[d] = third * (inverse[e] * q[d][d] + inverse[d] * q[e][e]);
  }
  for (unsigned int d = 0; d < 3; ++d)
  {
    const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
    force[d][d] = inverse[e] * twist[d] + inverse[f] * twist[f];
  }
  return force;
}

/// Axes along the edges of the brick that best fits a hexahedron, as rows, and
/// half edge lengths [m].
template <typename Number>
struct HexFrame
{
  Matrix3<Number> axes;
  Vector3<Number> half;
};

/// Frame of a hexahedron with corner modes @p x.
template <typename Number>
inline HexFrame<Number> hex_frame(const HexVectors<Number> &x)
{
  using std::sqrt;
  HexFrame<Number> frame;
  const auto length = [](const Vector3<Number> &a) { return sqrt(dot(a, a)); };
  for (unsigned int d = 0; d < 3; ++d)
    frame.half[d] = Number(1. / 8.) * length(x[d + 1]);
  const auto scaled = [](Vector3<Number> a, const Number &factor) {
    for (Number &component : a)
      component *= factor;
    return a;
  };
  frame.axes[0] = scaled(x[1], Number(1.) / length(x[1]));
  const Vector3<Number> normal = cross(x[1], x[2]);
  frame.axes[2] = scaled(normal, Number(1.) / length(normal));
  frame.axes[1] = cross(frame.axes[2], frame.axes[0]);
  return frame;
}

/**
 * Hourglass forces by assumed strains on the hourglass modes @p q of the
 * deformed body, which F = I + @p h pulls back into the frame. Adds the
 * derivative of the energy with respect to F to @p stress, and returns the
 * energy [J].
 */
template <typename Number>
inline std::array<Vector3<Number>, 4>
assumed_strain_forces(const Number &shear,
                      const HexFrame<Number> &frame,
                      const HexGeometry<Number> &g,
                      const std::array<Vector3<Number>, 4> &q,
                      const Matrix3<Number> *h,
                      Matrix3<Number> &stress,
                      Number &energy)
{
  std::array<Vector3<Number>, 4> local;
  const auto pulled = [&](const Vector3<Number> &a) {
    Vector3<Number> b = a;
    if (h != nullptr)
      for (unsigned int j = 0; j < 3; ++j)
        b[j] += (*h)[0][j] * a[0] + (*h)[1][j] * a[1] + (*h)[2][j] * a[2];
    return b;
  };
  for (unsigned int m = 0; m < 4; ++m)
  {
    const Vector3<Number> back = pulled(q[m]);
    for (unsigned int d = 0; d < 3; ++d)
      local[m][d] = dot(frame.axes[d], back);
  }
  const auto local_force = brick_forces(shear, frame.half, local);
  energy = half_work(local_force, local);
  std::array<Vector3<Number>, 4> force;
  for (unsigned int m = 0; m < 4; ++m)
  {
    Vector3<Number> reference;
    for (unsigned int i = 0; i < 3; ++i)
      reference[i] = frame.axes[0][i] * local_force[m][0] +
                     frame.axes[1][i] * local_force[m][1] +
                     frame.axes[2][i] * local_force[m][2];
    force[m] = reference;
    if (h != nullptr)
      for (unsigned int i = 0; i < 3; ++i)
      {
        force[m][i] += dot((*h)[i], reference);
        for (unsigned int j = 0; j < 3; ++j)
          stress[i][j] += g.inverse_volume * q[m][i] * reference[j];
      }
  }
  return force;
}
} // namespace contrecoup
