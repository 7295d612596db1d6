// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/gas/conditions/initial_field.h>
#include <contrecoup/materials/gas_material.h>

#include <deal.II/base/function_parser.h>

namespace contrecoup::gas
{
/**
 * Density, velocity, pressure and products as muParser expressions of x, y,
 * z: subsection "Expression".
 */
template <int dim>
class ExpressionField : public InitialField<dim>
{
public:
  static void declare_parameters(ParameterHandler &prm);

  /// Reads subsection "Expression" of the current one.
  /// @throws InputError for an expression that cannot be read.
  ExpressionField(ParameterHandler &prm, const GasMaterial &material);

  /// @throws InputError, naming the point, for an unphysical state.
  GasState<dim> value(const dealii::Point<dim> &point) const override;

private:
  GasMaterial material_;
  dealii::FunctionParser<dim> function_;
};
} // namespace contrecoup::gas
