// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/injury/injury_measure.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

/**
 * @file
 * Head injury measures and their thresholds, for all solvers.
 */

namespace contrecoup::solid
{
/// Pressure below which fluid may cavitate [Pa].
constexpr double cavitation_pressure = -100e3;

/// Extreme values that one element or particle of the brain over time.
struct BrainSample
{
  std::uint32_t cell = 0; ///< number in the whole mesh
  /// Whether the last strain is the largest, the last pressure the highest, the
  /// least one, and below cavitation_pressure.
  bool strain_grows = false;
  bool pressure_rises = false;
  bool pressure_falls = false;
  bool is_tense = false;
  double volume = 0.; ///< [m^3]
  double peak_strain = 0.;
  double peak_pressure = 0.;
  double lowest_pressure = 0.;

  /// Updates the extreme strain: the largest of all times up to now.
  void record_strain(const double largest)
  {
    strain_grows = largest > peak_strain;
    peak_strain = std::max(peak_strain, largest);
  }

  /// Updates the extreme pressures.
  void record_pressure(const double pressure)
  {
    pressure_rises = pressure > peak_pressure;
    pressure_falls = pressure < lowest_pressure;
    is_tense = pressure < cavitation_pressure;
    peak_pressure = std::max(peak_pressure, pressure);
    lowest_pressure = std::min(lowest_pressure, pressure);
  }
};

/// Integrals over the brain's volume and over time, of this rank.
struct BrainSums
{
  /// volume times time below cavitation_pressure [m^3 s]
  double cavitation_dose = 0.;
  /// Integrals of (p - average)^2 and of average^2 over volume and time [Pa^2
  /// m^3 s]; zero without averaging.
  double fluctuation_square = 0.;
  double average_square = 0.;
};

/**
 * Records the pressures of a time interval.
 * @param span length of the interval [s]
 * @param pressures of the elements or particles [Pa]
 * @param averages of the pressures over neighbours [Pa]
 * @param averaged whether extreme values use the averages
 */
void record_pressures(const double span,
                      const std::vector<double> &pressures,
                      const std::vector<double> &averages,
                      const bool averaged,
                      std::vector<BrainSample> &samples,
                      BrainSums &sums);

/**
 * Injury measures from the samples of all ranks; empty without samples.
 * Collective. Those of strain are lower limits where the strain of more than a
 * twentieth of the brain still grows, extreme pressures where they are the last
 * ones, and fraction and time at low pressure where the least pressure is a
 * lower limit or some pressure is low at the end.
 * @param tension_grows whether the least pressure is a lower limit anyway
 */
std::vector<InjuryMeasure>
brain_measures(const std::vector<BrainSample> &samples,
               const BrainSums &sums,
               const MPI_Comm communicator,
               const bool tension_grows = false);

/// Rigid motion of the head over time.
struct HeadMotion
{
  std::vector<double> times;                     ///< [s]
  std::vector<std::array<double, 3>> velocities; ///< of its centre [m/s]
  std::vector<std::array<double, 3>> angular_velocities; ///< [rad/s]

  void add(const double time,
           const dealii::Tensor<1, 3> &velocity,
           const dealii::Tensor<1, 3> &angular_velocity);
};

/**
 * Head injury criterion (HIC) and brain injury criterion (BrIC) of the motion
 * after the filter of channel frequency class 1000 (SAE J211/1), each with the
 * probabilities of injury that follow; empty for less than two times. Lower
 * limits are those whose interval or largest value, unless it is round-off, is
 * at the end.
 * @param moving describes what moves, for the report
 */
std::vector<InjuryMeasure> head_motion_measures(const HeadMotion &motion,
                                                const std::string &moving);

/// Marks brain strain and head motion as lower limits where a run under a blast
/// ends, at @p end [s], before the largest strains that the front causes, after
/// some 10 ms.
void mark_lower_limits(double end, std::vector<InjuryMeasure> &list);

/// The measures as a table for injury.csv.
std::string to_csv(const std::vector<InjuryMeasure> &measures);
} // namespace contrecoup::solid
