// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/run/simulation.h>
#include <contrecoup/numerics/exact/radial_state.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <functional>
#include <string>

namespace contrecoup::ale
{
/// State of a flow at a point and time.
struct FlowState
{
  double density = 0.;           ///< [kg/m^3]
  dealii::Tensor<1, 3> velocity; ///< [m/s]
  double pressure = 0.;          ///< [Pa]
};

/// A flow with an exact solution.
struct ExactFlow
{
  /// State at a point and a positive time [s].
  std::function<FlowState(const dealii::Point<3> &place, double time)> value;
  /// Number of sampling points along each edge of a cell, for errors.
  std::array<unsigned int, 3> samples{{4, 4, 4}};
};

/// State at @p way from a plane, an axis or a point, away from which it flows.
FlowState radial_state(const RadialState &state,
                       const dealii::Tensor<1, 3> &way);

/// A flow that Reference/Kind may name.
struct FlowKind
{
  std::string name, section;
  void (*declare)(dealii::ParameterHandler &prm);
  /// @throws InputError for unphysical constants, and for a file that is no
  /// table
  ExactFlow (*read)(const dealii::ParameterHandler &prm);
};

/// @name Kinds of flows, each in a file exact_flow_*.cc.
/// @{
/// Riemann problem of an ideal gas with two initial states, on both sides of a
/// plane normal to x.
FlowKind shock_tube_flow();
/// Noh's implosion onto the plane x = 0, the axis x = y = 0 or the origin.
FlowKind noh_flow();
/// Sedov's point explosion at the origin.
FlowKind sedov_flow();
/// Steady Taylor-Green vortices of an incompressible fluid in the x-y plane,
/// one per square. A gas with specific heat ratio gamma keeps this flow if the
/// heat source (u dp/dx + v dp/dy) / (gamma - 1) is added.
FlowKind taylor_green_flow();
/// A Tait liquid at zero pressure runs along x onto a wall at x = 0. The
/// stopped liquid has the state behind an isentropic compression wave; mass
/// conservation gives the speed of the front. The isentropic wave differs from
/// a shock by the third power of the Mach number.
FlowKind water_hammer_flow();
/// Radial flow about the origin at the end time, from a table.
FlowKind table_flow();
/// @}

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
