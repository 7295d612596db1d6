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
 * Interface of one kind of initial state. A derived class declares and reads
 * its own subsection of "Initial state".
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

  /// Pressure far from regions and sources [Pa], if it is uniform.
  virtual std::optional<double> background_pressure() const
  {
    return {};
  }
};
} // namespace contrecoup::gas
