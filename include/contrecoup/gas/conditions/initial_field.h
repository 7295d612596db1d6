// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/gas_state.h>

#include <deal.II/base/point.h>

#include <limits>
#include <optional>

namespace contrecoup::gas
{
/**
 * One kind of initial state, ready to be sampled. Derived classes declare
 * and read a subsection of "Initial state" of their own.
 */
template <int dim>
class InitialField
{
public:
  virtual ~InitialField() = default;

  /// See InitialState::value().
  virtual GasState<dim> value(const dealii::Point<dim> &point) const = 0;

  /// See InitialState::ambient().
  virtual GasState<dim> ambient(const dealii::Point<dim> &point) const
  {
    return value(point);
  }

  /// See InitialState::time().
  virtual double time() const
  {
    return 0.;
  }

  /// See InitialState::smallest_feature().
  virtual double smallest_feature() const
  {
    return std::numeric_limits<double>::infinity();
  }

  /// See InitialState::distance_to_feature().
  virtual double distance_to_feature(const dealii::Point<dim> &) const
  {
    return 0.;
  }

  /// The pressure [Pa] far from regions and sources, if there is one.
  virtual std::optional<double> background_pressure() const
  {
    return {};
  }
};
} // namespace contrecoup::gas
