// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/numerics/scheme/wave_speeds.h>

#include <algorithm>

namespace contrecoup::gas
{
/**
 * Programmed burn of explosive that the detonation has not yet passed, as the
 * kernels see it. The gas holds the energy of the explosive from the
 * beginning; only the pressure is reduced before the detonation. A point with
 * burned fraction F exerts the pressure F p + (1 - F) p_ambient, with p the
 * pressure of the burned gas at this density and energy. The unburned charge
 * is therefore in equilibrium with the air around it, and no energy is added.
 * See Detonation.
 *
 * Unburned explosive that is compressed by another wave must resist: from a
 * compression of a few hundredths on, F is at least (V_0 - V) / (1 - V_CJ)
 * with V = rho_0 / rho and the offset V_0 = 0.92; F falls again on expansion.
 * Behind a steady detonation front F exceeds this bound. Where detonations
 * converge or another blast arrives first, the bound keeps the gas above its
 * cold curve.
 */
struct Burn
{
  /// Ignition time of each point [s], laid out by LeafLayout with one
  /// component; where there is no explosive, earlier than all others.
  const double *start = nullptr;
  /// Burn rate: fraction of a point that burns per second, per stored leaf
  /// [1/s].
  const double *rate = nullptr;
  /// Whether a stored leaf has a point that still has to burn.
  const unsigned char *burns = nullptr;
  LeafLayout layout;            ///< of start
  double speed = 0.;            ///< detonation speed D [m/s]
  double ambient_pressure = 0.; ///< [Pa]
  double density = 1.;          ///< density rho_0 of the explosive [kg/m^3]
  double stiffness = 0.;        ///< 1 / (1 - V_CJ) [-]

  /// Fraction of a point that the detonation has burned at @p time [s].
  double progress(const unsigned int leaf,
                  const unsigned int point,
                  const double time) const
  {
    const double begin = start[layout.offset(leaf) + layout.value(0, point)];
    return std::min(std::max((time - begin) * rate[leaf], 0.), 1.);
  }

  /// Burned fraction F of explosive with density @p rho [kg/m^3], of which the
  /// detonation has burned the fraction @p progress.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number fraction(const Number &progress,
                                        const Number &rho) const
  {
    // 0.92 is 1 - 0.3 (1 - V_CJ) for common explosives: the largest offset
    // with which an implosion stays above the cold curve.
    const Number compression =
      (Number(0.92) - Number(density) / rho) * Number(stiffness);
    return std::max(progress, std::min(compression, Number(1.)));
  }

  /// Exerted pressure [Pa] of gas whose pressure after burning is @p burned
  /// and whose burned fraction is @p fraction; exact for fractions 0 and 1.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number pressure(const Number &burned,
                                        const Number &fraction) const
  {
    return burned * fraction +
           (Number(1.) - fraction) * Number(ambient_pressure);
  }

  /// Applies the burned fraction to the pressure of a face state. The sound
  /// speed there is at least that of the detonation, (1 - F) D.
  template <int dim, typename Number>
  DEAL_II_ALWAYS_INLINE void
  apply_burn_pressure(const Number &progress,
                      FaceState<dim, Number> &state) const
  {
    const Number burned = fraction(progress, state.density);
    state.pressure = pressure(state.pressure, burned);
    state.sound_speed =
      std::max(state.sound_speed, Number((Number(1.) - burned) * speed));
  }
};
} // namespace contrecoup::gas
