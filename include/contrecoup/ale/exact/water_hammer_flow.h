// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/**
 * Water hammer: a Tait liquid at zero pressure runs along x onto a wall at x =
 * 0. The stopped liquid has the state behind an isentropic compression wave;
 * mass conservation gives the speed of the front. The isentropic wave differs
 * from a shock by the third power of the Mach number.
 */
class WaterHammerFlow : public ExactFlow
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unphysical constants
  static std::unique_ptr<ExactFlow> create(const dealii::ParameterHandler &prm);

  FlowState value(const dealii::Point<3> &place, double time) const override;

private:
  double density_ = 1000.; ///< ahead of the front [kg/m^3]
  double speed_ = 1.;      ///< towards the wall [m/s]
  double stopped_density_ = 1000.;
  double pressure_ = 0.;    ///< of the stopped liquid [Pa]
  double front_speed_ = 0.; ///< away from the wall [m/s]
};
} // namespace contrecoup::ale
