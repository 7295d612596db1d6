// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/solid_material.h>
#include <contrecoup/numerics/element/hourglass.h>

#include <deal.II/base/parameter_handler.h>

namespace contrecoup::solid
{
/// Quadrature of an element's internal forces.
enum class Integration
{
  one_point, ///< one point, with hourglass control
  full       ///< 2 x 2 x 2 points for shear, one mean dilatation
};

/// Formulation of the elements: subsection "Elements".
struct ElementOptions
{
  Integration integration = Integration::one_point;
  SolidKinematics kinematics = SolidKinematics::small_strain;
  HourglassKind hourglass = HourglassKind::stiffness;
  double hourglass_coefficient = 1.;
  double hourglass_damping = 0.;
  double pressure_smoothing = 0.;
  bool skip_quiet = true; ///< leave out elements whose nodes never moved
  double linear_viscosity = 0.06;
  double quadratic_viscosity = 1.2;
  /// number of times that a step may be halved
  unsigned int largest_retries = 10;

  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Factor by which linear bulk viscosity reduces the stable step: sqrt(1 +
  /// xi^2) - xi with xi = linear_viscosity.
  double step_factor() const;
};
} // namespace contrecoup::solid
