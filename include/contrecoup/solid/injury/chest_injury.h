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
 * Follows the pressure on the chest and says what it does to chest wall, lung
 * and eardrum, by models that know nothing of the mesh; beside them, how fast
 * the skin of the mesh moved there. Entries of the subsection "Injury".
 */
class ChestInjury
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Where the pressure on the chest is wanted.
  const dealii::Point<3> &place() const
  {
    return place_;
  }

  /// How far around it the motion of the chest wall is averaged [m].
  double radius() const
  {
    return radius_;
  }

  /// Call at increasing times [s] with the overpressure there [Pa] and the
  /// inward velocity of the skin around [m/s].
  void
  follow(const double time, const double pressure, const double wall_velocity);

  /// Empty before the second call of follow().
  std::vector<InjuryMeasure> measures() const;

  /// What was followed: times [s], as many overpressures [Pa] and inward
  /// velocities [m/s].
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

  /// Goes on from what these were.
  void restore(std::vector<double> times,
               std::vector<double> pressures,
               std::vector<double> wall_velocities);

private:
  dealii::Point<3> place_;
  double radius_ = 0.;
  double mass_ = 70.;
  std::vector<double> times_;
  std::vector<double> pressures_;
  std::vector<double> wall_velocities_;
};
} // namespace contrecoup::solid
