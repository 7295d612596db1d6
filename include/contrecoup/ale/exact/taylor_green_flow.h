// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/**
 * Steady vortices of G. I. Taylor and A. E. Green in the plane of x and y,
 * those of an incompressible fluid, one in each square. Gas of the ratio gamma
 * of specific heats has them where it is heated by u dp/dx + v dp/dy over gamma
 * - 1.
 */
class TaylorGreenFlow : public ExactFlow
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for constants without a physical meaning
  static std::unique_ptr<ExactFlow> create(const dealii::ParameterHandler &prm);

  FlowState value(const dealii::Point<3> &place, double time) const override;

private:
  double density_ = 1.;  ///< [kg/m^3]
  double speed_ = 1.;    ///< [m/s]
  double pressure_ = 1.; ///< [Pa]
  double side_ = 1.;     ///< [m]
};
} // namespace contrecoup::ale
