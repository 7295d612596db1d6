// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>

#include <deal.II/base/point.h>

#include <vector>

namespace contrecoup::solid
{
/// Pressures on facets over time, such as those that another run recorded.
class PressureHistory
{
public:
  virtual ~PressureHistory() = default;

  /// Takes the facets of this rank, by their middles [m] and area vectors out
  /// of the body [m^2]. Collective.
  virtual void reinit(const std::vector<dealii::Point<3>> &middles,
                      const std::vector<dealii::Tensor<1, 3>> &areas,
                      MPI_Comm communicator) = 0;

  /// Goes to a time [s]; times ascend.
  virtual void set_time(double time) = 0;

  /// Overpressure on a facet at that time [Pa].
  virtual double pressure(std::size_t facet) const = 0;

  /// What there is to say of how the loads were brought here. Collective.
  virtual std::vector<NamedValue> audit() const = 0;
};
} // namespace contrecoup::solid
