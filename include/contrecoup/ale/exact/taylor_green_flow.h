// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/**
 * Steady Taylor-Green vortices of an incompressible fluid in the x-y plane,
 * one per square. A gas with specific heat ratio gamma keeps this flow if the
 * heat source (u dp/dx + v dp/dy) / (gamma - 1) is added.
 */
class TaylorGreenFlow : public ExactFlow
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unphysical constants
  static std::unique_ptr<ExactFlow> create(const dealii::ParameterHandler &prm);

  FlowState value(const dealii::Point<3> &place, double time) const override;

private:
  double density_ = 1.;  ///< [kg/m^3]
  double speed_ = 1.;    ///< [m/s]
  double pressure_ = 1.; ///< [Pa]
  double side_ = 1.;     ///< of a square [m]
};
} // namespace contrecoup::ale
