// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/mpm/particles.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <memory>
#include <vector>

namespace contrecoup::ale
{
/// Displacements at probes of particles, against known ones: how far what was
/// at a probe's place has gone along an axis.
class ProbeDisplacements
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  static std::unique_ptr<ProbeDisplacements>
  create(const dealii::ParameterHandler &prm);

  /// @param places of the probes at the start [m]
  /// @throws InputError unless there is a known displacement of each
  void reinit(const std::vector<dealii::Point<3>> &places);

  /// By probe, from the displacement of the nearest particle and its gradient
  /// there [m]. Collective.
  std::vector<NamedValue> values(const mpm::Particles &particles,
                                 const MPI_Comm communicator) const;

  /// By probe, absolute [m]. Collective.
  std::vector<NamedValue> errors(const mpm::Particles &particles,
                                 const MPI_Comm communicator) const;

private:
  unsigned int direction_ = 0;
  std::vector<double> known_;
  std::vector<dealii::Point<3>> places_;
};
} // namespace contrecoup::ale
