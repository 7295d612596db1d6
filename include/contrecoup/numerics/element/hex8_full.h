// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/hex8_one_point.h>

/**
 * @file
 * Hexahedron with 2 x 2 x 2 Gauss points and one dilatation (selective
 * integration, Hughes, Int. J. Numer. Meth. Engng. 15 (1980) 1413). Full
 * integration of shear avoids hourglass modes; the mean dilatation of the
 * element avoids locking of nearly incompressible matter. As with one-point
 * integration, strains are functions of displacement gradients with respect to
 * the undeformed body, and forces derive from an energy. Bricks are too stiff
 * in bending, due to parasitic shear.
 */

namespace contrecoup
{
/// Gauss point @p i of the reference cube [-1, 1]^3, 0 <= i < 8.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Vector3<Number> gauss_point(const unsigned int i)
{
  const double gauss = 0.577350269189625764509;
  return {{Number((i & 1) != 0 ? gauss : -gauss),
           Number((i & 2) != 0 ? gauss : -gauss),
           Number((i & 4) != 0 ? gauss : -gauss)}};
}

/// Gradient with respect to reference coordinates at @p p of a field with the
/// modes @p u; entry [i][k] is the derivative of component i along coordinate
/// k.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Matrix3<Number>
reference_gradient(const HexVectors<Number> &u, const Vector3<Number> &p)
{
  const Number eighth(1. / 8.);
  Matrix3<Number> result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int k = 0; k < 3; ++k)
    {
      const unsigned int l = (k + 1) % 3, m = (k + 2) % 3;
      result[i][k] = eighth * (u[1 + k][i] + u[4 + l][i] * p[m] +
                               u[4 + m][i] * p[l] + u[7][i] * p[l] * p[m]);
    }
  return result;
}

/// Transpose of reference_gradient(): adds the modal forces that are conjugate
/// to @p force on the derivatives.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE void
add_reference_force(const Matrix3<Number> &force,
                    const Vector3<Number> &p,
                    HexVectors<Number> &mode)
{
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int k = 0; k < 3; ++k)
    {
      const unsigned int l = (k + 1) % 3, m = (k + 2) % 3;
      const Number f = Number(1. / 8.) * force[i][k];
      mode[1 + k][i] += f;
      mode[4 + l][i] += f * p[m];
      mode[4 + m][i] += f * p[l];
      mode[7][i] += f * p[l] * p[m];
    }
}

/// Data at a Gauss point.
template <typename Number>
struct HexPoint
{
  Vector3<Number> place;     ///< in the reference cube
  Matrix3<Number> cofactors; ///< of d x / d place
  Number volume;             ///< integration weight times Jacobian [m^3]
  Matrix3<Number> h;         ///< displacement gradient
};

/// Gauss point @p i of a hexahedron with the position modes @p x and
/// displacement modes @p u.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE HexPoint<Number>
hex_point(const HexVectors<Number> &x,
          const HexVectors<Number> &u,
          const unsigned int i)
{
  HexPoint<Number> point;
  point.place = gauss_point<Number>(i);
  const Matrix3<Number> j = reference_gradient(x, point.place),
                        g = reference_gradient(u, point.place);
  point.cofactors = cofactor(j);
  point.volume = dot(j[0], point.cofactors[0]);
  const Number inverse = Number(1.) / point.volume;
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b)
      point.h[a][b] = inverse * dot(g[a], point.cofactors[b]);
  return point;
}

/// The volumetric part of a law.
template <typename Number>
inline SolidLaw<Number> volume_law(SolidLaw<Number> law)
{
  law.twice_shear = Number(0.);
  law.twice_relaxing = Number(0.);
  return law;
}

/// The deviatoric part of a law.
template <typename Number>
inline SolidLaw<Number> shear_law(SolidLaw<Number> law)
{
  law.bulk = Number(0.);
  law.gas = GasFilling();
  law.largest_tension = Number(no_cavitation);
  law.vapour_dilatation = Number(no_cavitation);
  return law;
}

/**
 * Internal forces on the corners of an element [N].
 * @param x_corners corner positions in the undeformed body [m]
 * @param u_corners corner displacements [m]
 * @param state history variables; advanced from the last step to the present
 * @param relaxed strains of the Prony branch at the points; advanced as well
 * @param dissipation energy dissipated in the last step [J]
 */
template <SolidKinematics kinematics, bool viscoelastic, typename Number>
inline HexVectors<Number>
full_forces(const HexModel<Number> &model,
            const HexVectors<Number> &x_corners,
            const HexVectors<Number> &u_corners,
            HexState<Number> &state,
            std::array<Symmetric3<Number>, 8> &relaxed,
            HexDissipation<Number> &dissipation)
{
  const HexVectors<Number> x = to_modes(x_corners), u = to_modes(u_corners);
  const HexGeometry<Number> g = hex_geometry(x);
  const Matrix3<Number> pressure = update_stress<kinematics, false>(
    model, volume_law(model.law), mean_gradient(g, u), g, state, dissipation);
  HexVectors<Number> force = mode_forces(g, pressure, {});
  for (unsigned int i = 0; i < 8; ++i)
  {
    const HexPoint<Number> point = hex_point(x, u, i);
    Matrix3<Number> cofactors{};
    if constexpr (kinematics != SolidKinematics::small_strain)
      cofactors = cofactor(point.h);
    const SolidStrain<Number> strain =
      solid_strain<kinematics>(point.h, cofactors);
    Number loss{};
    const Symmetric3<Number> shear =
      update_shear<viscoelastic>(model.law, strain, relaxed[i], loss);
    dissipation.relaxation += point.volume * loss;
    const Matrix3<Number> stress =
      piola_stress<kinematics>(point.h, cofactors, Number(), shear);
    Matrix3<Number> reference;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int k = 0; k < 3; ++k)
        reference[a][k] = stress[a][0] * point.cofactors[0][k] +
                          stress[a][1] * point.cofactors[1][k] +
                          stress[a][2] * point.cofactors[2][k];
    add_reference_force(reference, point.place, force);
  }
  return to_corners(force);
}
} // namespace contrecoup
