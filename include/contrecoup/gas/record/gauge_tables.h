// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/gas/state/exposure_record.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace contrecoup::gas
{
/// Blast wave at a gauge on the body, with its overpressure history.
struct GaugeBlast
{
  std::string place;
  BlastMeasures blast;
  double peak_time = 0.;             ///< [s]
  std::vector<double> overpressures; ///< at the times of the samples [Pa]
};

/// Arrival, peak, its time, positive impulse and positive phase at a gauge, as
/// BlastRecord defines them; not a number where no blast has arrived.
std::vector<NamedValue> gauge_values(const BlastMeasures &blast,
                                     const double peak_time);

/// CSV table of gauge_values(), one row per gauge, and 1 where the end of the
/// run, @p time [s], cuts the positive phase off.
std::string gauge_measures_table(const std::vector<GaugeBlast> &gauges,
                                 const double time);

/**
 * CSV table of injuries that the loads at the gauges would cause, one row per
 * measure and place, with unit and definition: chest wall velocity at "chest",
 * "back", "left upper arm" and "right upper arm" and the mean of these over the
 * "trunk" (of chest and back where there are no arms; before a plane of
 * symmetry one arm counts twice), lung exposure at "chest" and "back", eardrum
 * rupture at gauges whose last word is "ear"; see load_injury(). For a blast
 * test device, a cylinder of 0.305 m diameter and 0.762 m height (NATO AEP-55,
 * vol. 3, 2011) with the gauges "device front", "device back", "device left"
 * and "device right" at half its height, the chest wall velocity that Axelsson
 * and Yelverton (1996) define, the mean of the four, and their index of injury;
 * half a device has one of its sides, which counts twice. The last column is 1
 * where the value is a lower limit, as the run ends too early at one of the
 * gauges that it is of: before the wave or its peak comes, before the positive
 * phase of a lung exposure ends, or while a chest wall is at its fastest. Empty
 * without such gauges.
 *
 * @param times of the samples, increasing [s]
 * @param body_mass [kg]
 */
std::string gauge_injury_table(const std::vector<GaugeBlast> &gauges,
                               const std::vector<double> &times,
                               const double body_mass);

/// Blast wave at a place in the air, with what people there are exposed to.
struct AirBlast
{
  std::string place;
  BlastMeasures blast;
  double ambient = 0.; ///< pressure [Pa]
  ExposureRecord exposure;
  double total_impulse = 0.; ///< of all positive phases so far [Pa s]
  /// Whether the run ends before the positive phase does: injuries of lungs
  /// and the part of the impulse in this phase are then not known.
  bool is_cut = false;
};

/// Names and units of the measures of injury in the air, in the order of
/// air_injury_values().
extern const std::vector<std::pair<std::string, std::string>>
  air_injury_quantities;

/**
 * Measures of injury to a person who stands upright at a place in the air, as
 * if nobody but the run's body were there: air_injury() with the duration of
 * ExposureRecord; the largest velocity of the chest wall under the overpressure
 * at the place; and the part of the positive impulse that the first wave has
 * within the first positive phase, 1 in a simple wave, for which alone the lung
 * exposure is defined; among products, where later phases belong to the wave,
 * the part of this phase. Not a number where no blast has arrived and where
 * nobody stands, see ExposureRecord; of lungs and first phase, where the blast
 * is cut off, too.
 *
 * @param body_mass for the lung exposure [kg]
 */
std::array<double, 5> air_injury_values(const AirBlast &air,
                                        const double body_mass);

/**
 * air_injury_values() for maps: the probability of death is not a number, too,
 * where the first wave has at most 0.75 of the impulse, unless it exceeds 0.99.
 * Where it is unknown for this reason, or because the blast is cut off, it is
 * that of an endless phase if this is below 1e-3.
 */
std::array<double, 5> mapped_injury_values(const AirBlast &air,
                                           const double body_mass);

/// Whether lungs are not judged at a place where the ears are: next to the
/// products of an explosive, see ExposureRecord::durations().
bool lungs_are_unknown(const AirBlast &air, const double body_mass);

/// Says that and why.
/// @param places such as "probe 1" or "17 probes"
std::string words_of_unknown_lungs(const std::string &places);

/**
 * CSV table, as gauge_injury_table(), of air_injury_values() at each place.
 * Places are left out that no blast has reached, or whose ambient pressure is
 * out of the 45 to 115 kPa at which people live, see is_habitable(); empty
 * without others.
 *
 * The duration of the load on the lungs stands there where it is longer than
 * the first positive phase; the probability of death is mapped_injury_values()'
 * of a wave that is not simple where that is known.
 *
 * @param with_chest whether the motion of the chest was recorded; then the
 * table has the chest wall velocity where it is known, and the peak
 * overpressure, by which limits of training are given
 * @param body_mass [kg]
 */
std::string air_injury_table(const std::vector<AirBlast> &places,
                             const double body_mass,
                             const bool with_chest);
} // namespace contrecoup::gas
