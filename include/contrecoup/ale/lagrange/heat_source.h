// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/hex_space.h>
#include <contrecoup/base/parameters/expression.h>

#include <deal.II/base/parameter_handler.h>

namespace contrecoup::ale
{
/// Heat source in all matter as a function of place and time: subsection "Heat
/// source".
class HeatSource
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for an invalid expression
  void parse_parameters(dealii::ParameterHandler &prm);

  /**
   * Heats owned cells for @p duration [s], with the power density at their
   * centres and at the middle of the interval.
   * @return added heat [J]
   */
  double add(const HexSpace &space,
             AleState &state,
             const double begin,
             const double duration) const;

  bool is_active() const
  {
    return !power_.is_zero();
  }

private:
  Expression power_{"", "0"}; ///< [W/m^3]
};
} // namespace contrecoup::ale
