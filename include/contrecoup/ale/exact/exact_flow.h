// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/simulation.h>

#include <array>

namespace contrecoup::ale
{
/// What is known of a flow at a place and time.
struct FlowState
{
  double density = 0.;           ///< [kg/m^3]
  dealii::Tensor<1, 3> velocity; ///< [m/s]
  double pressure = 0.;          ///< [Pa]
};

/// A flow that is known everywhere.
class ExactFlow
{
public:
  virtual ~ExactFlow() = default;

  /// @param time above 0 [s]
  virtual FlowState value(const dealii::Point<3> &place, double time) const = 0;

  /// How many points along each edge of a cell its errors need.
  virtual std::array<unsigned int, 3> samples() const
  {
    return {{4, 4, 4}};
  }
};

/**
 * Mean absolute errors by volume, of those cells whose centres are within
 * @p radius of the origin, over points in the cells: density and pressure, of
 * which cells know their means, and the trilinear velocity. Collective.
 */
std::vector<NamedValue> flow_errors(const ExactFlow &flow,
                                    const HexSpace &space,
                                    const LagrangeStep &lagrange,
                                    const AleState &state,
                                    const double radius);
} // namespace contrecoup::ale
