// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/numerics/exact/exact_riemann.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/// Riemann problem of an ideal gas with two initial states, on both sides of a
/// plane normal to x.
class ShockTubeFlow : public ExactFlow
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unphysical constants
  static std::unique_ptr<ExactFlow> create(const dealii::ParameterHandler &prm);

  FlowState value(const dealii::Point<3> &place, double time) const override;
  std::array<unsigned int, 3> samples() const override
  {
    return {{20, 2, 2}};
  }

private:
  ShockTubeFlow(const ExactRiemann &solution, const double interface)
    : solution_(solution)
    , interface_(interface)
  {}

  ExactRiemann solution_;
  double interface_; ///< [m]
};
} // namespace contrecoup::ale
