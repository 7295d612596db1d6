// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <vector>

namespace contrecoup
{
/**
 * Motion of the chest wall of chest_wall_response(), followed in time. Held by
 * the records of many places, and so without anything that it can do without.
 */
struct ChestWall
{
  double displacement = 0.;         ///< inward [m]
  double velocity = 0.;             ///< inward [m/s]
  double largest_displacement = 0.; ///< so far [m]
  double largest_velocity = 0.;     ///< so far [m/s]

  /**
   * Advances by @p duration [s] under an overpressure that changes linearly
   * from @p first to @p last [Pa], in steps of the classical Runge-Kutta method
   * of at most 1e-5 s, smaller where the lung is stiff.
   */
  void advance(const double first,
               const double last,
               const double duration,
               const double ambient_pressure);

  /// Whether the largest velocity is that of now, a lower limit of what comes;
  /// also before any load.
  bool is_fastest_now() const
  {
    return velocity >= largest_velocity;
  }
};

/// Largest motion and pressure of a chest under a blast.
struct ChestWallResponse
{
  double velocity = 0.;      ///< largest, inward [m/s]
  double displacement = 0.;  ///< largest, inward [m]
  double lung_pressure = 0.; ///< largest, above ambient [Pa]
  /// Whether the history ends before the velocity falls.
  bool is_cut = false;
};

/**
 * Response of the chest wall of a 70 kg man, a mass on a spring and a damper
 * in front of a gas-filled lung:
 *
 *   M x'' + J x' + K x = A (p(t) + p0 - p0 (V / (V - A x))^gamma)
 *
 * with inward displacement x, overpressure p on the chest, M = 2.03 kg, J =
 * 696 kg/s, K = 989 N/m, A = 0.082 m^2, V = 1.82e-3 m^3, gamma = 1.2 (H.
 * Axelsson and J. T. Yelverton, J. Trauma 40 (1996) S31-S37; their model has
 * one such wall for each of the loads on four sides of a trunk).
 *
 * @param times increasing [s]
 * @param overpressures at these times, linear in between [Pa]
 * @param ambient_pressure p0 [Pa]
 * @throws InputError for times that do not increase, or when numbers of times
 * and overpressures differ
 */
ChestWallResponse chest_wall_response(const std::vector<double> &times,
                                      const std::vector<double> &overpressures,
                                      const double ambient_pressure);

/**
 * Adjusted severity of injury index (ASII) of the thorax [-], (0.124 + 0.117
 * v)^2.63, where v is the largest inward chest wall velocity [m/s], the mean of
 * the four gauges of a blast test device (Axelsson and Yelverton 1996; fitted
 * to sheep). The levels of injury by v are the criterion "chest_wall_mean" of
 * injury_criterion(); one gauge alone has none.
 */
double thorax_injury_index(const double chest_wall_velocity);
} // namespace contrecoup
