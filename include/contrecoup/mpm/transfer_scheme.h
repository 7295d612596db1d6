// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/names.h>

#include <array>
#include <cmath>
#include <limits>

namespace contrecoup::mpm
{
/// All splines of the background grid by degree, for entry and help text.
inline constexpr std::array<NamedChoice<unsigned int>, 3> bases{
  {{1, "linear", "makes forces jump where particles cross cells"},
   {2, "quadratic", "makes forces continuous"},
   {3, "cubic", "makes them smooth"}}};

/// Transfer of velocities from the nodes to the particles.
enum class Transfer
{
  pic,
  flip,   ///< with a mass series, that of consistent masses
  affine, ///< APIC
  fmpm    ///< series in the mass matrix, see TransferScheme::series_order
};

/// All transfers, for entry and help text.
inline constexpr std::array<NamedChoice<Transfer>, 4> transfers{
  {{Transfer::pic, "pic", "takes the nodal velocity"},
   {Transfer::flip, "flip", "adds the change of the nodal velocity"},
   {Transfer::affine, "apic", "takes the nodal velocity with its affine field"},
   {Transfer::fmpm,
    "fmpm",
    "takes the nodal velocity, corrected by a series in the mass matrix"}}};

/// Order of the stress update within a step.
enum class StressUpdate
{
  first,
  last,
  modified_last
};

/// All orders of the stress update, for entry and help text.
inline constexpr std::array<NamedChoice<StressUpdate>, 3> stress_updates{
  {{StressUpdate::first, "usf", "takes the velocity before the step"},
   {StressUpdate::last, "usl", "takes the velocity after the step"},
   {StressUpdate::modified_last,
    "musl",
    "takes the velocity of the momentum of the moved particles"}}};

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
