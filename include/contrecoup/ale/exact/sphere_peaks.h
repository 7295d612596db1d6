// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/run/simulation.h>
#include <contrecoup/io/file/state_file.h>
#include <contrecoup/numerics/exact/rigid_sphere_solution.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/// Peak pressures so far [Pa] by probe: of the run, and exact.
using Peaks = std::vector<std::array<double, 2>>;

/// Adds the peaks that a rank has saved: those of probes of other ranks are
/// zero.
void add_peaks(io::StateReader &in, Peaks &peaks);

/// Peak pressures at probes in a liquid that fills a rigid sphere, decelerated
/// along y, compared with those of the exact solution.
class SpherePeaks
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unphysical constants
  static std::unique_ptr<SpherePeaks>
  create(const dealii::ParameterHandler &prm);

  explicit SpherePeaks(const RigidSphere &sphere)
    : solution_(sphere)
  {}

  /// Updates the peaks. @param probes cells or HexSpace::no_cell
  void follow(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state,
              const std::vector<std::uint32_t> &probes,
              Peaks &peaks) const;

  /// Updates the peaks of one probe by the pressure at a point [Pa].
  void take(const dealii::Point<3> &place,
            const double pressure,
            const double time,
            std::array<double, 2> &peak) const;

  /// Largest error, relative to the largest exact peak. Collective.
  static std::vector<NamedValue> errors(const Peaks &peaks,
                                        MPI_Comm communicator);

private:
  RigidSphereSolution solution_;
};
} // namespace contrecoup::ale
