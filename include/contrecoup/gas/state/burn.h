// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lane_math.h>
#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/numerics/wave_speeds.h>

#include <algorithm>

namespace contrecoup::gas
{
/**
 * Explosive that a detonation has not passed yet, as kernels see it. The
 * energy of the explosive is in the gas from the beginning. What is missing
 * before the detonation is its push: a point of which the fraction F has
 * burned exerts the pressure F p + (1 - F) p_ambient, p being that of the
 * burned gas of this density and energy. So the unburned charge rests in the
 * air around it, and no energy is ever added. See Detonation.
 *
 * Explosive that something else compresses before must not be dust: from a
 * compression of a few hundredths on it pushes back with at least
 * F = (1 - V) / (1 - V_CJ) - 0.3, V being rho_0 / rho, and loses that again
 * where it expands. Behind the front of a steady detonation F is larger than
 * this; where detonations converge, or another blast comes first, it keeps
 * the gas above its cold curve.
 */
struct Burn
{
  /// Time when a point begins to burn [s], laid out as LeafLayout says for
  /// one component; where nothing is to burn, long before all others.
  const double *start = nullptr;
  /// Part of a point that burns in a second, per stored leaf [1/s].
  const double *rate = nullptr;
  /// Whether any point of a stored leaf is to burn.
  const unsigned char *burns = nullptr;
  LeafLayout layout;            ///< of start
  double speed = 0.;            ///< of the detonation, D [m/s]
  double ambient_pressure = 0.; ///< [Pa]
  double density = 1.;          ///< of the explosive, rho_0 [kg/m^3]
  double stiffness = 0.;        ///< 1 / (1 - V_CJ) [-]

  /// Fraction of a point that the detonation has burned.
  double progress(const unsigned int leaf,
                  const unsigned int point,
                  const double time) const
  {
    const double begin = start[layout.offset(leaf) + layout.value(0, point)];
    return std::min(std::max((time - begin) * rate[leaf], 0.), 1.);
  }

  /// Burned fraction F of explosive of this density [kg/m^3], of which the
  /// detonation has burned @p progress.
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

  /// The pressure that gas of pressure @p burned, of which @p fraction has
  /// burned, exerts [Pa]; exact for fractions 0 and 1.
  template <typename Number>
  DEAL_II_ALWAYS_INLINE Number pressure(const Number &burned,
                                        const Number &fraction) const
  {
    return burned * fraction +
           (Number(1.) - fraction) * Number(ambient_pressure);
  }

  /// Takes from a face state what has not burned. The detonation itself is
  /// the fastest wave there.
  template <int dim, typename Number>
  DEAL_II_ALWAYS_INLINE void hold_back(const Number &progress,
                                       FaceState<dim, Number> &state) const
  {
    const Number burned = fraction(progress, state.density);
    state.pressure = pressure(state.pressure, burned);
    state.sound_speed =
      std::max(state.sound_speed, Number((Number(1.) - burned) * speed));
  }
};
} // namespace contrecoup::gas
