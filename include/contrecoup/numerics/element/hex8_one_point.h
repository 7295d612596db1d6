// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/assumed_strain.h>
#include <contrecoup/numerics/element/bulk_viscosity.h>
#include <contrecoup/numerics/element/hex8_geometry.h>
#include <contrecoup/numerics/element/hourglass.h>
#include <contrecoup/numerics/element/pressure_smoothing.h>

/**
 * @file
 * Hexahedron with one integration point, in the undeformed configuration. The
 * gradient operator is constant in time, rigid motions of any size have
 * neither strain nor hourglass modes, and forces derive from an energy.
 */

namespace contrecoup
{
/// History variables of an element.
template <typename Number>
struct HexState
{
  Number dilatation;           ///< after the last step
  Number viscous_pressure;     ///< of bulk viscosity, after the last step [Pa]
  Number smoothing_pressure{}; ///< q of PressureSmoothing, likewise [Pa]
  Number smooth_dilatation{};  ///< S of PressureSmoothing, for the next step
  Number nodal_average{};      ///< of S at the corners
  Number nodal_share{};        ///< added to the sum at each corner [m^3]
  Symmetric3<Number> relaxed;  ///< of the Prony branch, at the middle of a step
  /// Hourglass damping forces after the last step [N].
  std::array<Number, 12> damping;
};

/// Modal forces from a stress, and from hourglass forces on modes 4 to 7.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE HexVectors<Number>
mode_forces(const HexGeometry<Number> &g,
            Matrix3<Number> stress,
            const std::array<Vector3<Number>, 4> &hourglass)
{
  // Hourglass modes exclude the linear field of the mean gradient.
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
    {
      Number sum = hourglass[0][i] * g.warp[0][j];
      for (unsigned int m = 1; m < 4; ++m)
        sum += hourglass[m][i] * g.warp[m][j];
      stress[i][j] -= g.inverse_volume * sum;
    }
  HexVectors<Number> force;
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int m = 0; m < 6; ++m)
      force[m + 1][i] = stress[i][0] * g.volume_gradient[m][0] +
                        stress[i][1] * g.volume_gradient[m][1] +
                        stress[i][2] * g.volume_gradient[m][2];
    for (unsigned int m = 0; m < 3; ++m)
      force[m + 4][i] += hourglass[m][i];
    force[7][i] = hourglass[3][i];
  }
  return force;
}

/// Hourglass modes of a field with modes @p u and mean gradient @p h.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE std::array<Vector3<Number>, 4>
hourglass_modes(const HexGeometry<Number> &g,
                const HexVectors<Number> &u,
                const Matrix3<Number> &h)
{
  std::array<Vector3<Number>, 4> q;
  for (unsigned int m = 0; m < 4; ++m)
    for (unsigned int i = 0; i < 3; ++i)
      q[m][i] = u[m + 4][i] - h[i][0] * g.warp[m][0] - h[i][1] * g.warp[m][1] -
                h[i][2] * g.warp[m][2];
  return q;
}

/// Energy dissipated in a step; per volume from update_stress(), total from
/// one_point_forces() [J].
template <typename Number>
struct HexDissipation
{
  Number bulk_viscosity{};
  Number relaxation{};
  Number hourglass{};
  Number pressure_smoothing{};
};

/**
 * Shear stress [Pa] at the present; advances the relaxed strain from the last
 * step to the present.
 * @param dissipation energy dissipated in the last step [J/m^3]; unchanged
 * without viscoelasticity
 */
template <bool viscoelastic, typename Number>
inline DEAL_II_ALWAYS_INLINE Symmetric3<Number>
update_shear(const SolidLaw<Number> &law,
             const SolidStrain<Number> &strain,
             Symmetric3<Number> &relaxed,
             Number &dissipation)
{
  Symmetric3<Number> shear;
  for (unsigned int k = 0; k < 6; ++k)
    shear[k] = law.twice_shear * strain.shear_measure[k];
  if constexpr (viscoelastic)
  {
    const Symmetric3<Number> now =
      relax(relaxed, strain.shear_measure, law.decay_before);
    Symmetric3<Number> pull, away;
    for (unsigned int k = 0; k < 6; ++k)
    {
      shear[k] -= law.twice_relaxing * now[k];
      away[k] = strain.shear_measure[k] - relaxed[k];
      pull[k] =
        law.relaxing_fraction * (strain.total[k] - strain.shear_measure[k]) +
        law.lost_fraction * away[k];
    }
    dissipation = law.twice_relaxing * contract(pull, away);
    relaxed = relax(now, strain.shear_measure, law.decay_after);
  }
  return shear;
}

/// Constants of all elements of one material.
template <typename Number>
struct HexModel
{
  SolidLaw<Number> law;
  BulkViscosity<Number> viscosity;
  Hourglass<Number> hourglass;
  PressureSmoothing<Number> smoothing;
  Number step{}; ///< size of the last step [s]
};

/**
 * First Piola-Kirchhoff stress of an element at the present [Pa]; advances @p
 * state from the last step to the present.
 */
template <SolidKinematics kinematics, bool viscoelastic, typename Number>
inline DEAL_II_ALWAYS_INLINE Matrix3<Number>
update_stress(const HexModel<Number> &model,
              const SolidLaw<Number> &law,
              const Matrix3<Number> &h,
              const HexGeometry<Number> &g,
              HexState<Number> &state,
              HexDissipation<Number> &dissipation)
{
  Matrix3<Number> cofactors{};
  if constexpr (kinematics != SolidKinematics::small_strain)
    cofactors = cofactor(h);
  const SolidStrain<Number> strain = solid_strain<kinematics>(h, cofactors);
  const Number change = strain.dilatation - state.dilatation;
  const Number length = g.wave_length();
  Number q = model.viscosity.pressure(change, length);
  dissipation.bulk_viscosity =
    Number(-0.5) * g.volume * change * (q + state.viscous_pressure);
  state.viscous_pressure = q;
  if (model.smoothing.active)
  {
    const Number rough =
      model.smoothing.pressure(state.smooth_dilatation, state.nodal_average);
    dissipation.pressure_smoothing =
      Number(-0.5) * g.volume * change * (rough + state.smoothing_pressure);
    state.smoothing_pressure = rough;
    state.smooth_dilatation = PressureSmoothing<Number>::advance(
      state.smooth_dilatation, strain.dilatation);
    state.nodal_share = g.volume * state.smooth_dilatation;
    q += rough;
  }
  state.dilatation = strain.dilatation;

  const Symmetric3<Number> shear = update_shear<viscoelastic>(
    law, strain, state.relaxed, dissipation.relaxation);
  return piola_stress<kinematics>(
    h,
    cofactors,
    bounded_tension(law, law.bulk * strain.dilatation) - q,
    shear);
}

/**
 * Internal forces on the corners of an element [N].
 * @param x_corners corner positions in the undeformed body [m]
 * @param u_corners corner displacements [m]
 * @param velocities returns corner velocities [m/s]; called with damping only
 * @param state advanced from the last step to the present
 * @param dissipation energy dissipated in the last step [J]
 */
template <SolidKinematics kinematics,
          bool viscoelastic,
          typename Number,
          typename Velocities>
inline DEAL_II_ALWAYS_INLINE HexVectors<Number>
one_point_forces(const HexModel<Number> &model,
                 const HexVectors<Number> &x_corners,
                 const HexVectors<Number> &u_corners,
                 const Velocities &velocities,
                 HexState<Number> &state,
                 HexDissipation<Number> &dissipation)
{
  const HexVectors<Number> x = to_modes(x_corners), u = to_modes(u_corners);
  const HexGeometry<Number> g = hex_geometry(x);
  const Matrix3<Number> h = mean_gradient(g, u);
  Matrix3<Number> stress = update_stress<kinematics, viscoelastic>(
    model, model.law, h, g, state, dissipation);
  if constexpr (viscoelastic)
    dissipation.relaxation *= g.volume;

  const std::array<Vector3<Number>, 4> q = hourglass_modes(g, u, h);
  std::array<Vector3<Number>, 4> resistance;
  const Hourglass<Number> &control = model.hourglass;
  if (control.kind == HourglassKind::assumed_strain)
  {
    Number energy;
    constexpr bool finite = kinematics != SolidKinematics::small_strain;
    resistance = assumed_strain_forces(control.stiffness,
                                       hex_frame(x),
                                       g,
                                       q,
                                       finite ? &h : nullptr,
                                       stress,
                                       energy);
  }
  else
  {
    resistance = spring_forces(control.stiffness * g.stiffness_length(), q);
  }
  if (control.has_damper())
  {
    const HexVectors<Number> v = to_modes(velocities());
    dissipation.hourglass =
      add_damping(control.viscosity * g.damping_area(),
                  hourglass_modes(g, v, mean_gradient(g, v)),
                  Number(0.5) * model.step,
                  state.damping,
                  resistance);
  }
  return to_corners(mode_forces(g, stress, resistance));
}
} // namespace contrecoup
