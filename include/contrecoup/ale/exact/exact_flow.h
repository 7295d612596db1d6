// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/run/simulation.h>

#include <array>

namespace contrecoup::ale
{
/// State of a flow at a point and time.
struct FlowState
{
  double density = 0.;           ///< [kg/m^3]
  dealii::Tensor<1, 3> velocity; ///< [m/s]
  double pressure = 0.;          ///< [Pa]
};

/// Interface: a flow with an exact solution.
class ExactFlow
{
public:
  virtual ~ExactFlow() = default;

  /// State at a point. @param time must be positive [s]
  virtual FlowState value(const dealii::Point<3> &place, double time) const = 0;

  /// Number of sampling points along each edge of a cell, for errors.
  virtual std::array<unsigned int, 3> samples() const
  {
    return {{4, 4, 4}};
  }
};

/**
 * Volume-weighted mean absolute errors over the cells whose centres lie within
 * @p radius [m] of the origin, sampled at points in the cells: density and
 * pressure, compared with the cells' constant values, and the trilinear
 * velocity. Collective.
 */
std::vector<NamedValue> flow_errors(const ExactFlow &flow,
                                    const HexSpace &space,
                                    const LagrangeStep &lagrange,
                                    const AleState &state,
                                    const double radius);
} // namespace contrecoup::ale
