// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/**
 * Tait's liquid without pressure that runs along x onto a wall at x = 0. What
 * the wall has stopped has the state that an isentropic wave leaves; the front
 * goes as the masses on both sides of it require. Such a wave and a shock
 * differ by the third power of the ratio of the speeds of liquid and sound.
 */
class WaterHammerFlow : public ExactFlow
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for constants without a physical meaning
  static std::unique_ptr<ExactFlow> create(const dealii::ParameterHandler &prm);

  FlowState value(const dealii::Point<3> &place, double time) const override;

private:
  double density_ = 1000.; ///< before the front [kg/m^3]
  double speed_ = 1.;      ///< towards the wall [m/s]
  double stopped_density_ = 1000.;
  double pressure_ = 0.;    ///< of what is stopped [Pa]
  double front_speed_ = 0.; ///< away from the wall [m/s]
};
} // namespace contrecoup::ale
