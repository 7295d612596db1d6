// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/small_matrix.h>
#include <contrecoup/materials/solid_material.h>
#include <contrecoup/materials/volumetric_law.h>

/**
 * @file
 * Stresses of solids as functions of the displacement gradient in the
 * reference configuration, for a number or lanes. Strains are computed from
 * the displacement gradient H, never from F = I + H, to avoid cancellation at
 * small strains in single precision.
 */

namespace contrecoup
{
/// Strain measures of the stress.
template <typename Number>
struct SolidStrain
{
  Number dilatation;                ///< tr H or det F - 1
  Symmetric3<Number> total;         ///< sym H, or Green-Lagrange strain E
  Symmetric3<Number> shear_measure; ///< shear stress over 2 G_0
};

/// sym H, plus H^T H / 2 unless strains are small.
template <bool finite, typename Number>
inline DEAL_II_ALWAYS_INLINE Symmetric3<Number>
green_strain(const Matrix3<Number> &h)
{
  Symmetric3<Number> e{{h[0][0],
                        h[1][1],
                        h[2][2],
                        Number(0.5) * (h[0][1] + h[1][0]),
                        Number(0.5) * (h[1][2] + h[2][1]),
                        Number(0.5) * (h[2][0] + h[0][2])}};
  if constexpr (finite)
  {
    constexpr unsigned int row[] = {0, 1, 2, 0, 1, 2};
    constexpr unsigned int column[] = {0, 1, 2, 1, 2, 0};
    for (unsigned int k = 0; k < 6; ++k)
      e[k] += Number(0.5) *
              (h[0][row[k]] * h[0][column[k]] + h[1][row[k]] * h[1][column[k]] +
               h[2][row[k]] * h[2][column[k]]);
  }
  return e;
}

/// det(I + H) - 1, without cancellation.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number
finite_dilatation(const Matrix3<Number> &h, const Matrix3<Number> &cofactors)
{
  return h[0][0] + h[1][1] + h[2][2] +
         (cofactors[0][0] + cofactors[1][1] + cofactors[2][2]) +
         (h[0][0] * cofactors[0][0] + h[0][1] * cofactors[0][1] +
          h[0][2] * cofactors[0][2]);
}

/// Cofactors of F = I + H.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Matrix3<Number>
deformed_cofactor(const Matrix3<Number> &h, const Matrix3<Number> &cofactors)
{
  const Number one_and_trace = Number(1.) + h[0][0] + h[1][1] + h[2][2];
  Matrix3<Number> c;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      c[i][j] = cofactors[i][j] - h[j][i];
  for (unsigned int i = 0; i < 3; ++i)
    c[i][i] += one_and_trace;
  return c;
}

/// J^(-2/3) C^-1 E' with the deviator E' of Green-Lagrange strain: second
/// Piola-Kirchhoff stress of the isochoric neo-Hookean solid over 2 G.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Symmetric3<Number>
neo_hookean_measure(const Symmetric3<Number> &e,
                    const Symmetric3<Number> &deviator,
                    const Number &dilatation)
{
  // The adjugate of C = I + 2 E.
  const Number one(1.), two(2.);
  const Number cx = one + two * e[0], cy = one + two * e[1],
               cz = one + two * e[2];
  const Number xy = two * e[3], yz = two * e[4], zx = two * e[5];
  const Symmetric3<Number> a{{cy * cz - yz * yz,
                              cz * cx - zx * zx,
                              cx * cy - xy * xy,
                              zx * yz - xy * cz,
                              xy * zx - yz * cx,
                              xy * yz - zx * cy}};
  const Number j = one + dilatation;
  const Number root = inverse_cube_root(j);
  const Number factor = root * root / (j * j);
  const Symmetric3<Number> &d = deviator;
  // The factors commute, so the product is symmetric.
  return {{factor * (a[0] * d[0] + a[3] * d[3] + a[5] * d[5]),
           factor * (a[3] * d[3] + a[1] * d[1] + a[4] * d[4]),
           factor * (a[5] * d[5] + a[4] * d[4] + a[2] * d[2]),
           factor * (a[0] * d[3] + a[3] * d[1] + a[5] * d[4]),
           factor * (a[3] * d[5] + a[1] * d[4] + a[4] * d[2]),
           factor * (a[5] * d[0] + a[4] * d[3] + a[2] * d[5])}};
}

/// Strain of a displacement gradient. @param cofactors of H; not used for
/// small strains
template <SolidKinematics kinematics, typename Number>
inline DEAL_II_ALWAYS_INLINE SolidStrain<Number>
solid_strain(const Matrix3<Number> &h, const Matrix3<Number> &cofactors)
{
  constexpr bool finite = kinematics != SolidKinematics::small_strain;
  SolidStrain<Number> strain;
  strain.total = green_strain<finite>(h);
  const Number trace = strain.total[0] + strain.total[1] + strain.total[2];
  strain.shear_measure = strain.total;
  for (unsigned int i = 0; i < 3; ++i)
    strain.shear_measure[i] -= Number(1. / 3.) * trace;
  if constexpr (finite)
    strain.dilatation = finite_dilatation(h, cofactors);
  else
    strain.dilatation = trace;
  if constexpr (kinematics == SolidKinematics::neo_hookean)
    strain.shear_measure = neo_hookean_measure(
      strain.total, strain.shear_measure, strain.dilatation);
  return strain;
}

/// Advances the relaxed strain from the middle of the last step to the
/// present, for a constant strain measure: second order, and exact for step
/// changes of strain.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Symmetric3<Number>
relax(const Symmetric3<Number> &relaxed,
      const Symmetric3<Number> &measure,
      const Number &decay)
{
  Symmetric3<Number> result;
  for (unsigned int k = 0; k < 6; ++k)
    result[k] = measure[k] + decay * (relaxed[k] - measure[k]);
  return result;
}

/**
 * First Piola-Kirchhoff stress [Pa].
 * @param volumetric volumetric stress, minus the bulk viscosity pressure
 * @param shear 2 G_0 measure - 2 G_1 relaxed
 */
template <SolidKinematics kinematics, typename Number>
inline DEAL_II_ALWAYS_INLINE Matrix3<Number>
piola_stress(const Matrix3<Number> &h,
             const Matrix3<Number> &cofactors,
             const Number &volumetric,
             const Symmetric3<Number> &shear)
{
  const Matrix3<Number> s{{{{shear[0], shear[3], shear[5]}},
                           {{shear[3], shear[1], shear[4]}},
                           {{shear[5], shear[4], shear[2]}}}};
  Matrix3<Number> p = s;
  if constexpr (kinematics == SolidKinematics::small_strain)
  {
    for (unsigned int i = 0; i < 3; ++i)
      p[i][i] += volumetric;
  }
  else
  {
    const Matrix3<Number> c = deformed_cofactor(h, cofactors);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        p[i][j] += volumetric * c[i][j] + h[i][0] * s[0][j] +
                   h[i][1] * s[1][j] + h[i][2] * s[2][j];
  }
  return p;
}

/// Strain energy density with the relaxed strain @p relaxed [J/m^3].
template <SolidKinematics kinematics, typename Number>
inline Number stored_energy(const SolidLaw<Number> &law,
                            const SolidStrain<Number> &strain,
                            const Symmetric3<Number> &relaxed)
{
  Number shear =
    Number(0.5) * contract(strain.shear_measure, strain.shear_measure);
  if constexpr (kinematics == SolidKinematics::neo_hookean)
  {
    const Number trace = strain.total[0] + strain.total[1] + strain.total[2];
    const Number root = inverse_cube_root(Number(1.) + strain.dilatation);
    shear = Number(0.25) *
            (root * root * (Number(3.) + Number(2.) * trace) - Number(3.));
  }
  return volumetric_energy(law, strain.dilatation) + law.twice_shear * shear +
         law.twice_relaxing * (Number(0.5) * contract(relaxed, relaxed) -
                               contract(strain.total, relaxed));
}
} // namespace contrecoup
