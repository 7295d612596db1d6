// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/numerics/exact/sedov_solution.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/// Sedov's point explosion at the origin.
class SedovFlow : public ExactFlow
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unphysical constants
  static std::unique_ptr<ExactFlow> create(const dealii::ParameterHandler &prm);

  FlowState value(const dealii::Point<3> &place, double time) const override;

private:
  explicit SedovFlow(const SedovSolution &solution)
    : solution_(solution)
  {}

  SedovSolution solution_;
};
} // namespace contrecoup::ale
