// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/injury/injury_measure.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <vector>

namespace contrecoup::solid
{
/**
 * Records the pressure on the chest and computes injury of chest wall and lung
 * by models that do not depend on the mesh, unless "Chest load" is false. Also
 * records the inward velocity of the mesh's chest wall. Subsection "Injury".
 */
class ChestInjury
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @param phantom_mass of the body [kg]; NaN: it is no phantom
  void parse_parameters(dealii::ParameterHandler &prm, double phantom_mass);

  /// Point at which the chest pressure is read [m].
  const dealii::Point<3> &place() const
  {
    return place_;
  }

  /// Radius around place() for the mean velocity of the chest wall [m].
  double radius() const
  {
    return radius_;
  }

  /// Whether injuries by the load on the chest are reported.
  bool reports_load() const
  {
    return reports_load_;
  }

  /// Mass of the person, with which limits of lungs scale [kg].
  double body_mass() const
  {
    return mass_;
  }

  /// Whether neither an entry nor a phantom tells body_mass().
  bool guesses_mass() const
  {
    return guesses_mass_;
  }

  /// Names of the measures.
  std::vector<std::string> measure_names() const;

  /// Records overpressure [Pa] and inward velocity of the chest wall [m/s] at
  /// a time [s]; times must increase.
  void
  record(const double time, const double pressure, const double wall_velocity);

  /// Injury measures; empty before the second call of record().
  std::vector<InjuryMeasure> measures() const;

  /// Recorded times [s]; pressures() [Pa] and wall_velocities() [m/s] have the
  /// same size.
  const std::vector<double> &times() const
  {
    return times_;
  }
  const std::vector<double> &pressures() const
  {
    return pressures_;
  }

  const std::vector<double> &wall_velocities() const
  {
    return wall_velocities_;
  }

  /// Restores the record of a checkpoint.
  void restore(std::vector<double> times,
               std::vector<double> pressures,
               std::vector<double> wall_velocities);

private:
  /// Adds the injuries by the load on the chest.
  void add_load(std::vector<InjuryMeasure> &list) const;

  dealii::Point<3> place_;
  bool reports_load_ = true;
  double radius_ = 0.;
  double mass_ = 0.;
  bool guesses_mass_ = false;
  std::vector<double> times_;
  std::vector<double> pressures_;
  std::vector<double> wall_velocities_;
};
} // namespace contrecoup::solid
