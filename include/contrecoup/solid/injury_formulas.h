// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <functional>
#include <vector>

/**
 * @file
 * Injury measures by the formulas of their authors. Constants that were not
 * read in the original are marked as recalled.
 */

namespace contrecoup::solid
{
/**
 * Head injury criterion (Versace 1971): the largest (t2 - t1) a^2.5, a the
 * mean acceleration in g between two times no more than @p window [s] apart.
 * @param times ascending [s]
 * @param speeds mean acceleration between times i and i + 1 is the change of
 *   the velocity vector between them over their distance [m/s]
 */
double head_injury_criterion(const std::vector<double> &times,
                             const std::vector<std::array<double, 3>> &speeds,
                             const double window);

/// Brain injury criterion (Takhounts et al. 2013) of the largest angular
/// velocities about the axes x, y, z [rad/s].
double brain_injury_criterion(const std::array<double, 3> &largest);

/**
 * Largest inward velocity of the chest wall [m/s] by the model of one mass of
 * Axelsson and Yelverton 1996: M x'' + J x' + K x = A (p + p_0 - p_0 (V / (V -
 * A x))^gamma) with A = 0.082 m^2, M = 2.03 kg, J = 696 N s/m, K = 989 N/m, V =
 * 1.82e-3 m^3, gamma = 1.2. Injuries begin near 3.6 m/s.
 * @param overpressure on the chest by time [Pa]
 * @param end last time [s]
 */
double chest_wall_velocity(const std::function<double(double)> &overpressure,
                           const double end);

/// Adjusted severity of injury index of a chest wall velocity [m/s]: (0.124 +
/// 0.117 v)^2.63 (recalled).
double adjusted_severity_index(const double velocity);

/// Overpressure that half of the men of this mass [kg] survive, by its
/// duration [s] (Bowen, Fletcher and Richmond 1968, fit: 61.5 psi (1 + 6.76
/// T^-1.064), T in ms for 70 kg; recalled) [Pa]. Injuries of the lung begin
/// near a fifth of it.
double half_lethal_overpressure(const double duration, const double mass);

/// Part of eardrums that break under a peak overpressure [Pa]: probit -12.6 +
/// 1.524 ln p (recalled).
double eardrum_rupture(const double peak);

/// The smallest value that at least this part of the volume does not exceed.
/// @param values and volumes of pieces
double volume_percentile(std::vector<std::pair<double, double>> values,
                         const double part);
} // namespace contrecoup::solid
