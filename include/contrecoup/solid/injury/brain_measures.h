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
 * Measures of injury of the head that solvers share, with their thresholds.
 */

namespace contrecoup::solid
{
/// Pressure below which fluid may cavitate [Pa].
constexpr double cavitation_pressure = -100e3;

/// What a part of the brain went through.
struct BrainPiece
{
  std::uint32_t cell = 0; ///< in the whole mesh
  double volume = 0.;     ///< [m^3]
  double peak_strain = 0.;
  double peak_pressure = 0.;
  double lowest_pressure = 0.;

  /// Raises and lowers the extrema.
  void take_pressure(const double pressure)
  {
    peak_pressure = std::max(peak_pressure, pressure);
    lowest_pressure = std::min(lowest_pressure, pressure);
  }
};

/// Sums over the brain and the time, of this rank.
struct BrainSums
{
  double cavitation_dose = 0.; ///< volume times time [m^3 s]
  /// Squares of pressures less their averages, and of the latter, by volume
  /// and time [Pa^2 m^3 s]; zero where nothing is averaged.
  double rough = 0.;
  double smooth = 0.;
};

/**
 * Notes pressures that pieces have had for so long.
 * @param span [s]
 * @param pressures of the pieces [Pa]
 * @param averages of these over neighbours [Pa]
 * @param averaged whether extrema are those of the averages
 */
void take_pressures(const double span,
                    const std::vector<double> &pressures,
                    const std::vector<double> &averages,
                    const bool averaged,
                    std::vector<BrainPiece> &pieces,
                    BrainSums &sums);

/// Of all ranks' pieces; none without any. Collective.
std::vector<InjuryMeasure> brain_measures(const std::vector<BrainPiece> &pieces,
                                          const BrainSums &sums,
                                          const MPI_Comm communicator);

/// The head injury criterion of velocities [m/s] at these times [s].
/// @param motion of what, in a few words
InjuryMeasure
head_motion_measure(const std::vector<double> &times,
                    const std::vector<std::array<double, 3>> &velocities,
                    const std::string &motion);

/// Raises the largest angular velocities about the axes [rad/s].
void raise_spin(std::array<double, 3> &largest,
                const dealii::Tensor<1, 3> &turning);

/// The brain injury criterion of the largest angular velocities [rad/s].
/// @param turning of what, in a few words
InjuryMeasure head_turning_measure(const std::array<double, 3> &largest,
                                   const std::string &turning);

/// A table of measures, for injury.csv.
std::string to_csv(const std::vector<InjuryMeasure> &measures);
} // namespace contrecoup::solid
