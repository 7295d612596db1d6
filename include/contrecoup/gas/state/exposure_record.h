// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/gas/state/wave_peaks.h>
#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/chest_wall.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace contrecoup::gas
{
/**
 * Exposure of a person who would stand at one position, updated once
 * per step from the arrival of the blast on: load_in_flow(), its largest value
 * and its impulse, and the motion of the chest wall under the overpressure
 * there. Replaces the histories that measures of injury would need otherwise.
 * Where matter passes that is denser than densest_air, within a charge or
 * next to it, nobody stands: nothing is known there, not a number.
 */
struct ExposureRecord
{
  static constexpr unsigned int n_values = 18;

  /// Density that no shock in air reaches [kg/m^3].
  static constexpr double densest_air = 100.;

  double load = 0.; ///< largest so far [Pa]
  double last = 0.; ///< overpressure at the end of the last step [Pa]
  ChestWall chest;
  double load_impulse = 0.;  ///< [Pa s]
  double products = 0.;      ///< largest mass fraction so far [-]
  double phase_impulse = 0.; ///< since the load last began to matter [Pa s]
  double elapsed = 0.;       ///< since the arrival [s]
  double lasting = 0.;       ///< end of the last notable phase so far [s]
  double pressing = 0.;      ///< end of the last large phase so far [s]
  WavePeaks waves;           ///< of the overpressure

  /// Adds overpressure and dynamic pressure [Pa] and the mass fraction of
  /// products at the end of a step [s].
  void add_load(const double overpressure,
                const double dynamic,
                const double ambient,
                const double fraction,
                const double step)
  {
    const double now = load_in_flow(overpressure, dynamic, ambient);
    load = std::max(load, now);
    load_impulse += now * step;
    products = std::max(products, fraction);
    elapsed += step;
    // In parts of the ambient pressure; by less nobody is injured.
    constexpr double harmless = 0.05;
    phase_impulse = now > harmless * ambient ? phase_impulse + now * step : 0.;
    if (presses_on())
      lasting = elapsed;
    constexpr double large = 0.03;
    if (phase_impulse > large * load_impulse)
      pressing = elapsed;
  }

  /**
   * Least and largest duration of the load for Bowen's curves [s]. Away from
   * the products of an explosive both are the @p positive_phase of the
   * overpressure. Among products, which overexpand, the overpressure soon falls
   * below zero and rises again: its first phase lasts the shorter the nearer
   * the charge, and by it people next to the charge would live. There the load
   * lasts to the end of its last phase that has a large or at least a notable
   * part of its impulse. Then the probability of death falls with the distance
   * (computed for six explosives with and without afterburn). Where the gas was
   * at most a mixture of products and air, of which numerical diffusion
   * decides, each of these durations is possible.
   */
  std::pair<double, double> durations(const double positive_phase) const
  {
    if (!is_among_products())
      return {positive_phase, positive_phase};
    constexpr double mixture = 0.98; // largest mass fraction
    return {products > mixture ? std::max(positive_phase, pressing)
                               : positive_phase,
            std::max(positive_phase, lasting)};
  }

  /// Whether the present phase of the load has a notable part of its impulse.
  bool presses_on() const
  {
    constexpr double notable = 0.003;
    return phase_impulse > notable * load_impulse;
  }

  /// Whether a trace of the products of an explosive has reached the place.
  bool is_among_products() const
  {
    return products > 1e-4;
  }

  /// Whether the duration among products is not known yet.
  bool goes_on() const
  {
    return is_among_products() && presses_on();
  }

  /// Follows the chest through a step [s] that ends with @p overpressure [Pa].
  void
  add_chest(const double overpressure, const double step, const double ambient)
  {
    chest.advance(last, overpressure, step, ambient);
    last = overpressure;
  }

  /// Continues where a simple wave of a known @p record has been recorded
  /// without this: the load is standing_load(), and the motion of the chest
  /// stays unknown, not a number.
  void continue_after(const BlastRecord<double> &record, const double ambient)
  {
    load = standing_load(record.peak, ambient);
    load_impulse = record.running;
    chest.largest_velocity = std::numeric_limits<double>::quiet_NaN();
  }

  /// Forgets all: the place is not one for people.
  void give_up()
  {
    load = chest.largest_velocity = std::numeric_limits<double>::quiet_NaN();
  }
};
} // namespace contrecoup::gas
