// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/small_matrix.h>
#include <contrecoup/materials/solid_law.h>

#include <string>

/**
 * @file
 * Elastic-plastic metals, with kernels for a number or lanes. An isochoric
 * neo-Hookean solid in terms of the elastic left Cauchy-Green tensor; radial
 * return where the von Mises stress exceeds the yield strength (J. C. Simo, T.
 * J. R. Hughes, Computational Inelasticity, 1998, box 9.1). All stresses are
 * Kirchhoff stresses.
 */

namespace contrecoup
{
/**
 * Johnson-Cook strength (A + B e^n) (1 + C ln(max(1, e' / e'_0))) (1 - T*^m),
 * with plastic strain e, its rate e' and T* = (T - T_r) / (T_m - T_r); plastic
 * work raises the temperature T. Defaults are OFHC copper: G. R. Johnson, W.
 * H. Cook, Proc. 7th Int. Symp. Ballistics, The Hague, 1983, 541-547.
 */
struct JohnsonCook
{
  double yield_stress = 90e6;          ///< A [Pa]
  double hardening = 292e6;            ///< B [Pa]
  double hardening_exponent = 0.31;    ///< n [-]
  double rate_coefficient = 0.025;     ///< C [-]
  double reference_rate = 1.;          ///< e'_0 [1/s]
  double softening_exponent = 1.09;    ///< m [-]
  double melting_temperature = 1356.;  ///< T_m [K]
  double reference_temperature = 298.; ///< T_r, also the initial one [K]
  double heat_capacity = 8960. * 383.; ///< per undeformed volume [J/(m^3 K)]
  double heating_fraction = 0.9;       ///< heat fraction of plastic work [-]

  /// Temperature [K] after adiabatic plastic work [J/m^3].
  double temperature(double plastic_work) const;

  /// Yield strength [Pa] for a plastic strain [-], its rate [1/s] and plastic
  /// work [J/m^3].
  double
  strength(double plastic_strain, double rate, double plastic_work) const;

  /**
   * Plastic strain increment of a step [-].
   * @param stress von Mises stress of the elastic trial state [Pa]
   * @param stiffness decrease of this stress per plastic strain [Pa]
   * @param plastic_strain before the step [-]
   * @param plastic_work before the step [J/m^3]
   * @param step [s]
   */
  double plastic_increment(double stress,
                           double stiffness,
                           double plastic_strain,
                           double plastic_work,
                           double step) const;

  /// @throws InputError, naming @p name, unless T_m exceeds T_r
  void check(const std::string &name) const;
};

/// The same for each lane.
template <typename Scalar, std::size_t width>
inline LaneGroup<Scalar, width>
plastic_increment(const JohnsonCook &law,
                  const LaneGroup<Scalar, width> &stress,
                  const LaneGroup<Scalar, width> &stiffness,
                  const LaneGroup<Scalar, width> &plastic_strain,
                  const LaneGroup<Scalar, width> &plastic_work,
                  const double step)
{
  LaneGroup<Scalar, width> result;
  for (std::size_t lane = 0; lane < width; ++lane)
    result[lane] =
      static_cast<Scalar>(law.plastic_increment(stress[lane],
                                                stiffness[lane],
                                                plastic_strain[lane],
                                                plastic_work[lane],
                                                step));
  return result;
}

inline double plastic_increment(const JohnsonCook &law,
                                const double stress,
                                const double stiffness,
                                const double plastic_strain,
                                const double plastic_work,
                                const double step)
{
  return law.plastic_increment(
    stress, stiffness, plastic_strain, plastic_work, step);
}

/// History variables of a metal; initially zero.
template <typename Number>
struct MetalState
{
  /// Isochoric elastic left Cauchy-Green tensor minus the identity [-].
  Symmetric3<Number> elastic{};
  Number plastic_strain{}; ///< von Mises equivalent [-]
  Number plastic_work{};   ///< per undeformed volume [J/m^3]
};

/// A third of the trace of b - 1 for the symmetric tensor b with deviator @p d
/// and determinant 1.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number
isochoric_third_of_trace(const Symmetric3<Number> &d)
{
  const Number j2 = Number(0.5) * contract(d, d);
  const Number j3 = d[0] * (d[1] * d[2] - d[4] * d[4]) -
                    d[3] * (d[3] * d[2] - d[4] * d[5]) +
                    d[5] * (d[3] * d[4] - d[1] * d[5]);
  // Newton's method converges monotonically from an upper bound to the largest
  // root of (1 + x)^3 - j2 (1 + x) + j3 = 1.
  Number x = std::sqrt(Number(4. / 3.) * j2);
  for (unsigned int i = 0; i < 8; ++i)
  {
    const Number one = Number(1.) + x;
    const Number value =
      x * (Number(3.) + Number(3.) * x + x * x - j2) - j2 + j3;
    x -= value / (Number(3.) * one * one - j2);
  }
  return x;
}

/// Deviator of f b f^T det(f)^(-2/3) for f = 1 + @p g and b = 1 + @p e.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Symmetric3<Number>
strained_deviator(const Matrix3<Number> &g, const Symmetric3<Number> &e)
{
  constexpr unsigned int entry[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  Matrix3<Number> product;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      product[i][j] = g[i][j] + g[i][0] * e[entry[0][j]] +
                      g[i][1] * e[entry[1][j]] + g[i][2] * e[entry[2][j]];
  Symmetric3<Number> d;
  for (unsigned int k = 0; k < 6; ++k)
  {
    const unsigned int i = k % 3, j = k < 3 ? i : (i + 1) % 3;
    d[k] = e[k] + product[i][j] + product[j][i] + product[i][0] * g[j][0] +
           product[i][1] * g[j][1] + product[i][2] * g[j][2];
  }
  const Number third = Number(1. / 3.) * (d[0] + d[1] + d[2]);
  const Number root =
    inverse_cube_root(Number(1.) + finite_dilatation(g, cofactor(g)));
  for (unsigned int k = 0; k < 6; ++k)
    d[k] = root * root * (k < 3 ? d[k] - third : d[k]);
  return d;
}

/**
 * Elastic-plastic stress update of a step. Returns the deviatoric stress [Pa].
 * @param shear modulus [Pa]
 * @param increment displacement gradient of the step with respect to the
 * position before the step
 * @param step [s]; 0: no plastic flow
 */
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Symmetric3<Number>
strain_metal(const JohnsonCook &law,
             const double shear,
             const Matrix3<Number> &increment,
             const double step,
             MetalState<Number> &state)
{
  auto deviator = strained_deviator(increment, state.elastic);
  Number third = isochoric_third_of_trace(deviator);
  if (step > 0.)
  {
    const Number stress =
      Number(shear) * std::sqrt(Number(1.5) * contract(deviator, deviator));
    const Number stiffness = Number(3. * shear) * (Number(1.) + third);
    const Number added = plastic_increment(
      law, stress, stiffness, state.plastic_strain, state.plastic_work, step);
    const Number left = stress - stiffness * added;
    const Number part =
      select_less(Number(0.), added, left / stress, Number(1.));
    for (Number &component : deviator)
      component *= part;
    third = isochoric_third_of_trace(deviator);
    state.plastic_strain += added;
    state.plastic_work += left * added;
  }
  Symmetric3<Number> result;
  for (unsigned int k = 0; k < 6; ++k)
  {
    state.elastic[k] = k < 3 ? deviator[k] + third : deviator[k];
    result[k] = Number(shear) * deviator[k];
  }
  return result;
}

/// Shear energy stored in a metal [J/m^3].
template <typename Number>
inline Number metal_shear_energy(const double shear,
                                 const Symmetric3<Number> &elastic)
{
  return Number(0.5 * shear) * (elastic[0] + elastic[1] + elastic[2]);
}
} // namespace contrecoup
