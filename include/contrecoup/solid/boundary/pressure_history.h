// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/// Interface: pressure on facets as a function of time.
class PressureHistory
{
public:
  virtual ~PressureHistory() = default;

  /// Tells of the whole surface of the body on this rank, corners of its facets
  /// in order [m]. Called before reinit(). Collective.
  virtual void
  set_surface(const std::vector<std::array<dealii::Point<3>, 4>> & /*facets*/,
              const MPI_Comm /*communicator*/)
  {}

  /// Sets the facets of this rank: centres [m] and outward area vectors [m^2].
  /// Collective.
  virtual void reinit(const std::vector<dealii::Point<3>> &middles,
                      const std::vector<dealii::Tensor<1, 3>> &areas,
                      MPI_Comm communicator) = 0;

  /// Sets the current time [s]; times must not decrease.
  virtual void set_time(double time) = 0;

  /// Overpressure on a facet at the current time [Pa].
  virtual double pressure(std::size_t facet) const = 0;

  /// Factor on the pressures of all facets, for an impulse that is to be kept:
  /// of the force on the surface, not of what a gauge there would measure.
  virtual double correction() const
  {
    return 1.;
  }

  /// Loads that are missing until the end time of the run [s], such as those
  /// after the last sample of a record, in one sentence; empty: none.
  /// Call after reinit(). Collective.
  virtual std::string warning(double end_time) const = 0;

  /// Checks of the mapping of loads onto the facets, for the summary.
  /// Collective.
  virtual std::vector<NamedValue> check_values() const = 0;
};
} // namespace contrecoup::solid
