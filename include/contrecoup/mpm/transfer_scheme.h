// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace contrecoup::mpm
{
/// Names of the splines of the background grid, in the order of their degree.
const std::vector<std::string> &basis_names();

/// 1, 2, 3 for linear, quadratic, cubic. @throws InputError that suggests the
/// most similar name
unsigned int find_basis(const std::string &name);

/// Transfer of velocities from the nodes to the particles.
enum class Transfer
{
  pic,    ///< nodes' velocity
  flip,   ///< change of the nodal velocity; with a mass series, that of
          ///< consistent masses
  affine, ///< nodal velocity with its affine field (APIC)
  fmpm    ///< nodal velocity, corrected by a series in the mass matrix (FMPM)
};

/// Order of the stress update within a step.
enum class StressUpdate
{
  first,         ///< with the velocity before the step (USF)
  last,          ///< with the velocity after the step (USL)
  modified_last, ///< with the velocity of the momentum of the moved particles
                 ///< (MUSL)
};

/// Names in parameter files, in the order of the enumerations.
const std::vector<std::string> &transfer_names();
const std::vector<std::string> &stress_update_names();

/// @throws InputError that suggests the most similar name
Transfer find_transfer(const std::string &name);
StressUpdate find_stress_update(const std::string &name);

/// Parameters of the material point method.
struct TransferScheme
{
  unsigned int degree = 3; ///< of the splines
  Transfer transfer = Transfer::flip;
  StressUpdate update = StressUpdate::modified_last;
  /**
   * Number k of terms of the series sum_j (I - M_L^-1 M)^j, j < k, which
   * approximates nodal velocities and accelerations of the consistent mass
   * matrix M from those of the lumped masses M_L; 1: lumped masses. Hammerquist
   * and Nairn, Comput. Methods Appl. Mech. Eng. 318 (2017), for velocities;
   * here also for accelerations.
   */
  unsigned int series_order = 1;
  /// Decay time of the difference between the velocities of particles and of
  /// the grid with FLIP [s], for any step size; infinity: no decay.
  double damping_time = std::numeric_limits<double>::infinity();

  /// Weight of the grid velocity in the velocity of particles after a step [-].
  double grid_velocity_fraction(const double step) const
  {
    return transfer == Transfer::flip ? -std::expm1(-step / damping_time) : 1.;
  }
};
} // namespace contrecoup::mpm
