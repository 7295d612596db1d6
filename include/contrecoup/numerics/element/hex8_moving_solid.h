// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/hex8_fluid.h>

/**
 * @file
 * Hexahedron of a solid in an ALE mesh with fluids. As in hex8_fluid.h, all
 * forces are corner forces whose work is the change of energy. As in
 * hex8_one_point.h, strains derive from displacements of the undeformed body.
 * Bulk viscosity depends on velocities, so that forces are available at any
 * time within a step.
 */

namespace contrecoup
{
/// Constants of all elements of a solid.
template <typename Number>
struct MovingSolidModel
{
  SolidLaw<Number> law;
  double density = 0.;          ///< undeformed [kg/m^3]
  double sound_speed = 0.;      ///< P-wave speed, undeformed [m/s]
  double linear_viscosity = 0.; ///< bulk viscosity, as of a fluid [-]
  double quadratic_viscosity = 0.;
  /// Hourglass stiffness and damping, see Hourglass.
  double hourglass_spring = 0., hourglass_damper = 0.;
  HexWedge wedge; ///< with elements in the wedge if its slope is positive
};

/// History of a solid element, and results of moving_solid_forces().
template <typename Number>
struct MovingSolid
{
  /// Strain of the relaxing branch at the start of the step; receives that at
  /// its end.
  Symmetric3<Number> relaxed;

  Symmetric3<Number> strain; ///< in the undeformed body [-]
  Number dilatation;         ///< volume ratio minus 1 [-]
  Number pressure;           ///< without bulk viscosity [Pa]
  Number signal_rate;        ///< inverse of the stable step [1/s]
};

/// Rate of the volume ratio [1/s].
/// @param rate velocity gradient with respect to the undeformed body
template <SolidKinematics kinematics, typename Number>
inline DEAL_II_ALWAYS_INLINE Number
dilatation_rate(const Matrix3<Number> &h,
                const Matrix3<Number> &cofactors,
                const Matrix3<Number> &rate)
{
  if constexpr (kinematics == SolidKinematics::small_strain)
    return rate[0][0] + rate[1][1] + rate[2][2];
  const Matrix3<Number> c = deformed_cofactor(h, cofactors);
  Number sum{};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      sum += c[i][j] * rate[i][j];
  return sum;
}

/// Hourglass forces from stiffness and damping.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE std::array<Vector3<Number>, 4>
hourglass_resistance(const MovingSolidModel<Number> &model,
                     const HexGeometry<Number> &g,
                     const std::array<Vector3<Number>, 4> &of_displacement,
                     const std::array<Vector3<Number>, 4> &of_velocity)
{
  const Number spring = Number(model.hourglass_spring) * g.stiffness_length();
  const Number damper = Number(model.hourglass_damper) * g.damping_area();
  std::array<Vector3<Number>, 4> force;
  for (unsigned int m = 0; m < 4; ++m)
    for (unsigned int i = 0; i < 3; ++i)
      force[m][i] = spring * of_displacement[m][i] + damper * of_velocity[m][i];
  model.wedge.restrict_modes(force);
  return force;
}

/**
 * Corner forces of an element [N].
 * @param undeformed corner positions in the undeformed body [m]
 * @param x_corners present positions [m]
 * @param v_corners velocities [m/s]
 */
template <SolidKinematics kinematics, bool viscoelastic, typename Number>
inline DEAL_II_ALWAYS_INLINE HexVectors<Number>
moving_solid_forces(const MovingSolidModel<Number> &model,
                    const HexVectors<Number> &undeformed,
                    const HexVectors<Number> &x_corners,
                    const HexVectors<Number> &v_corners,
                    MovingSolid<Number> &element)
{
  using std::min;
  HexVectors<Number> displacement;
  for (unsigned int i = 0; i < 8; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      displacement[i][d] = x_corners[i][d] - undeformed[i][d];
  const HexVectors<Number> u = to_modes(displacement), v = to_modes(v_corners);
  HexGeometry<Number> g = hex_geometry(to_modes(undeformed));
  model.wedge.restrict_lengths(g);
  const Matrix3<Number> h = mean_gradient(g, u), rate = mean_gradient(g, v);
  Matrix3<Number> cofactors{};
  if constexpr (kinematics != SolidKinematics::small_strain)
    cofactors = cofactor(h);
  const SolidStrain<Number> strain = solid_strain<kinematics>(h, cofactors);

  const Number length = g.wave_length();
  const Number compression =
    min(Number(), dilatation_rate<kinematics>(h, cofactors, rate));
  const Number viscosity =
    Number(model.density) * length *
    (Number(model.linear_viscosity * model.sound_speed) -
     Number(model.quadratic_viscosity) * length * compression);

  const Number elastic = model.law.bulk * strain.dilatation;
  Number heat;
  const Symmetric3<Number> shear =
    update_shear<viscoelastic>(model.law, strain, element.relaxed, heat);
  const Matrix3<Number> stress = piola_stress<kinematics>(
    h, cofactors, elastic + viscosity * compression, shear);
  const auto resistance = hourglass_resistance(
    model, g, hourglass_modes(g, u, h), hourglass_modes(g, v, rate));

  element.strain = strain.total;
  element.dilatation = strain.dilatation;
  element.pressure = Number() - elastic;
  element.signal_rate = (Number(model.sound_speed) +
                         Number(2. / model.density) * viscosity / length) /
                        length;
  return to_corners(mode_forces(g, stress, resistance));
}
} // namespace contrecoup
