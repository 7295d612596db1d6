// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace contrecoup::mpm
{
/// Splines of the background grid, by their degree.
const std::vector<std::string> &basis_names();

/// 1, 2, 3 for linear, quadratic, cubic. @throws InputError with the nearest
unsigned int find_basis(const std::string &name);

/// How velocities come back from the nodes to the particles.
enum class Transfer
{
  pic,    ///< nodes' velocity
  flip,   ///< change of the nodes' velocity; with series, of consistent mass
  affine, ///< nodes' velocity and its affine part (APIC)
  fmpm    ///< nodes' velocity, corrected by a series of mass matrices
};

/// When stresses are made.
enum class StressUpdate
{
  first,         ///< from the velocity before the step (USF)
  last,          ///< from the velocity after the step (USL)
  modified_last, ///< from that of the moved particles' momentum (MUSL)
};

/// Their words in parameter files, in the order of the enumerations.
const std::vector<std::string> &transfer_names();
const std::vector<std::string> &stress_update_names();

/// @throws InputError with the nearest word
Transfer find_transfer(const std::string &name);
StressUpdate find_stress_update(const std::string &name);

/// The choices of the material point method.
struct TransferScheme
{
  unsigned int degree = 3; ///< of the splines
  Transfer transfer = Transfer::flip;
  StressUpdate update = StressUpdate::modified_last;
  /**
   * Terms k of the series sum_j (I - M_L^-1 M)^j, j < k, that makes of lumped
   * nodal velocities and accelerations those of the consistent mass matrix: 1
   * leaves them lumped. Hammerquist and Nairn, Comput. Methods Appl. Mech. Eng.
   * 318 (2017), for velocities; here for accelerations, too.
   */
  unsigned int series_order = 1;
  /// Time in which FLIP's particles lose what their velocity has beside that of
  /// the nodes [s], whatever the step size; infinity: never.
  double damping_time = std::numeric_limits<double>::infinity();

  /// Part of the nodes' velocity in that of particles after a step.
  double grid_velocity_fraction(const double step) const
  {
    return transfer == Transfer::flip ? -std::expm1(-step / damping_time) : 1.;
  }
};
} // namespace contrecoup::mpm
