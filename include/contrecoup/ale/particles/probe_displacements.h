// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/mpm/particles.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <memory>
#include <vector>

namespace contrecoup::ale
{
/// Displacements of material points at probes along an axis, compared with
/// known values.
class ProbeDisplacements
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  static std::unique_ptr<ProbeDisplacements>
  create(const dealii::ParameterHandler &prm);

  /// @param points initial positions of the probes [m]
  /// @throws InputError unless each probe has a known displacement
  void reinit(const std::vector<dealii::Point<3>> &points);

  /// Displacement of each probe [m], from displacement and displacement
  /// gradient of the nearest particle. Collective.
  std::vector<NamedValue> values(const mpm::Particles &particles,
                                 const MPI_Comm communicator) const;

  /// Absolute error of each probe [m]. Collective.
  std::vector<NamedValue> errors(const mpm::Particles &particles,
                                 const MPI_Comm communicator) const;

private:
  unsigned int direction_ = 0;
  std::vector<double> known_;
  std::vector<dealii::Point<3>> points_;
};
} // namespace contrecoup::ale
