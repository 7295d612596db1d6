// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/numerics/exact/noh_solution.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/// Noh's implosion onto the plane x = 0, the axis x = y = 0 or the origin.
class NohFlow : public ExactFlow
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unphysical constants
  static std::unique_ptr<ExactFlow> create(const dealii::ParameterHandler &prm);

  FlowState value(const dealii::Point<3> &place, double time) const override;

private:
  NohFlow(const NohSolution &solution, const unsigned int dimension)
    : solution_(solution)
    , dimension_(dimension)
  {}

  NohSolution solution_;
  unsigned int dimension_;
};
} // namespace contrecoup::ale
