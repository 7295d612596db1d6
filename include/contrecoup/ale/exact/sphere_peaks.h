// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/simulation.h>
#include <contrecoup/numerics/rigid_sphere_solution.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/// Largest pressures so far, of the run and exact ones, at probes [Pa].
using Peaks = std::vector<std::array<double, 2>>;

/// Largest pressures at probes in a liquid that fills a rigid sphere, which is
/// decelerated along y, against those of the exact solution.
class SpherePeaks
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for constants without a physical meaning
  static std::unique_ptr<SpherePeaks>
  create(const dealii::ParameterHandler &prm);

  explicit SpherePeaks(const RigidSphere &sphere)
    : solution_(sphere)
  {}

  /// @param probes cells or HexSpace::no_cell
  void follow(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state,
              const std::vector<std::uint32_t> &probes,
              Peaks &peaks) const;

  /// Raises peaks by a pressure at a place [Pa].
  void take(const dealii::Point<3> &place,
            const double pressure,
            const double time,
            std::array<double, 2> &peak) const;

  /// The largest error over the largest exact peak. Collective.
  static std::vector<NamedValue> errors(const Peaks &peaks,
                                        MPI_Comm communicator);

private:
  RigidSphereSolution solution_;
};
} // namespace contrecoup::ale
