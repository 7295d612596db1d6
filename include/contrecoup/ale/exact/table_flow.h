// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/gas/conditions/table_profile.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/// Radial flow about the origin at the end time, from a table of radius [m],
/// density [kg/m^3], radial velocity [m/s] and pressure [Pa]; value() ignores
/// the time.
class TableFlow : public ExactFlow
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a file that is no table
  static std::unique_ptr<ExactFlow> create(const dealii::ParameterHandler &prm);

  FlowState value(const dealii::Point<3> &place, double time) const override;

private:
  explicit TableFlow(const gas::TableProfile &table)
    : table_(table)
  {}

  gas::TableProfile table_;
};
} // namespace contrecoup::ale
