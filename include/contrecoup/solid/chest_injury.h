// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/injury_measure.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <vector>

namespace contrecoup::solid
{
/**
 * Follows the pressure on the chest and says what it does to chest wall, lung
 * and eardrum, by models that know nothing of the mesh. Entries of the
 * subsection "Injury".
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

  /// Call with the overpressure there [Pa] at increasing times [s].
  void follow(const double time, const double pressure);

  /// Empty before the second call of follow().
  std::vector<InjuryMeasure> measures() const;

  /// What was followed: times [s] and as many overpressures [Pa].
  const std::vector<double> &times() const
  {
    return times_;
  }
  const std::vector<double> &pressures() const
  {
    return pressures_;
  }

  /// Goes on from what times() and pressures() were.
  void restore(std::vector<double> times, std::vector<double> pressures);

private:
  dealii::Point<3> place_;
  double mass_ = 70.;
  std::vector<double> times_;
  std::vector<double> pressures_;
};
} // namespace contrecoup::solid
