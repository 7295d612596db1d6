// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/sphere_peaks.h>
#include <contrecoup/numerics/exact/fluid_filled_shell.h>

namespace contrecoup::ale
{
/**
 * Pressures at opposite probes in a liquid-filled shell that hits a wall,
 * compared with the closed-form solution. The shell is centred at the origin
 * and moves along -z. Pressures oscillate about the half sine of the contact,
 * so the amplitude of the half sine is compared: 2 / T integral_0^T p sin(pi t
 * / T) dt, with the contact time T of the closed form. The contact force is
 * projected in the same way; divided by the mass it gives the acceleration of
 * the liquid in the run.
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

  /// Adds a completed step of size @p step [s] to the integrals.
  /// Collective.
  /// @param probes cells or HexSpace::no_cell, in opposite pairs: 0 and 1, 2
  /// and 3 and so on; Reference checks that their number is even
  /// @param peaks sums over the steps of positive and of negative parts, whose
  /// difference is the amplitude: of the pressure at each probe [Pa] and, as
  /// the last entry, of the force of all planes [N]
  void follow(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state,
              const std::vector<std::uint32_t> &probes,
              const double step,
              Peaks &peaks);

  /// Relative errors: of the acceleration against the closed form; and, for
  /// each pair of probes, of half the pressure difference against the closed
  /// form, against a rigid shell, and against a rigid shell with the
  /// acceleration of the run. Collective.
  /// @param mass of the computed part [kg]
  std::vector<NamedValue>
  errors(const Peaks &peaks, const double mass, MPI_Comm communicator) const;

private:
  FluidFilledShell shell_;
  /// Centres of the probes' cells; zero on ranks that do not own the cell.
  std::vector<dealii::Point<3>> places_;
};
} // namespace contrecoup::ale
