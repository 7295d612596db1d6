// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/sphere_peaks.h>
#include <contrecoup/numerics/fluid_filled_shell.h>

namespace contrecoup::ale
{
/**
 * Pressures in a liquid that fills a shell, which hits a wall, at opposite
 * probes, against the closed form. The middle of the shell is the origin, and
 * it comes along -z. As pressures ring on about the half sine of the contact,
 * its amplitude is compared: 2 / T integral_0^T p sin(pi t / T) dt, T by the
 * closed form. The force of the walls has an amplitude alike, and over the mass
 * it is the acceleration that the liquid got in the run.
 */
class ShellPressures
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  static std::unique_ptr<ShellPressures>
  create(const dealii::ParameterHandler &prm);

  explicit ShellPressures(const FluidFilledShell &shell)
    : shell_(shell)
  {}

  /// Adds a step of @p step seconds that has been made to @p parts, the
  /// amplitudes [Pa] of what is positive and of what is negative, by probe, and
  /// last that of the force of all planes [N]. Collective.
  /// @param probes cells or HexSpace::no_cell
  /// @throws InputError for an odd number of probes
  void follow(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state,
              const std::vector<std::uint32_t> &probes,
              const double step,
              Peaks &parts);

  /// The acceleration over that of the closed form, less 1. Of each pair of
  /// probes: half the difference over that of the closed form, over that of a
  /// rigid wall, and over that of a rigid wall with the acceleration of the
  /// run, each less 1. Collective.
  /// @param mass of what is computed [kg]
  std::vector<NamedValue>
  errors(const Peaks &parts, const double mass, MPI_Comm communicator) const;

private:
  FluidFilledShell shell_;
  /// Where the cells of the probes were; zero where they are not here.
  std::vector<dealii::Point<3>> places_;
};
} // namespace contrecoup::ale
