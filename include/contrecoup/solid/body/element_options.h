// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/solid_material.h>
#include <contrecoup/numerics/hourglass.h>

#include <deal.II/base/parameter_handler.h>

namespace contrecoup::solid
{
/// Where stresses of an element are found.
enum class Integration
{
  one_point, ///< in one point, with hourglass control
  full       ///< shear in 2 x 2 x 2 points, one dilatation
};

/// How elements are integrated: subsection "Elements".
struct ElementOptions
{
  Integration integration = Integration::one_point;
  SolidKinematics kinematics = SolidKinematics::small_strain;
  HourglassKind hourglass = HourglassKind::stiffness;
  double hourglass_coefficient = 1.;
  double hourglass_damping = 0.;
  bool skip_quiet = true; ///< elements where nothing has moved
  double linear_viscosity = 0.06;
  double quadratic_viscosity = 1.2;
  unsigned int largest_retries = 10; ///< halvings of a step

  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// What is left of the stable step beside bulk viscosity: the factor
  /// sqrt(1 + xi^2) - xi with xi = linear_viscosity.
  double step_factor() const;
};
} // namespace contrecoup::solid
