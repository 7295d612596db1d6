// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/base/run/simulation.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <vector>

namespace contrecoup::solid
{
/// Initial displacements and velocities: subsection "Initial state".
class InitialMotion
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  template <typename Real>
  void set(const SolidMesh &mesh, NodeFields<Real> &nodes) const;

private:
  std::vector<Expression> displacement_; ///< x, y, z
  std::vector<Expression> velocity_;
};


/// Reference displacements and pressure: subsection "Reference".
class ReferenceMotion
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /**
   * The errors against the given references: displacement_L2 (relative to the
   * norm of the reference, weighted with masses), displacement_maximum
   * (relative to the largest reference displacement), and pressure_L1 (mean
   * absolute error over the mean absolute reference pressure). Collective.
   */
  template <typename Real>
  std::vector<NamedValue> errors(const SolidBody<Real> &body) const;

private:
  template <typename Real>
  void add_displacement(const SolidBody<Real> &body,
                        std::vector<NamedValue> &errors) const;
  template <typename Real>
  void add_pressure(const SolidBody<Real> &body,
                    std::vector<NamedValue> &errors) const;

  std::vector<Expression> displacement_; ///< empty: no reference
  std::optional<Expression> pressure_;
};
} // namespace contrecoup::solid
