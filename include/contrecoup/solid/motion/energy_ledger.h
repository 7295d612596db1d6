// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/motion/solid_operator.h>

#include <vector>

namespace contrecoup::solid
{
/// Energies summed over all ranks [J].
struct EnergyLedger
{
  std::vector<TissueEnergies> tissues;
  TissueEnergies sum;
  double external_work = 0.;  ///< by loads, moving supports and gravity
  double contact = 0.;        ///< in the springs of the ground
  double interface_work = 0.; ///< on both sides of a sliding interface
  /// Work of internal forces on the nodes, with what elements store at the
  /// start; should equal the sum of element energies.
  double nodal_internal_work = 0.;
  double initial = 0.; ///< kinetic and stored energy at the start
  /// Change by varying step sizes of the energy that central differences
  /// conserve, H - dt^2 / 8 f M^-1 f.
  double step_change = 0.;

  /// Energy that is missing in the balance of elements and nodes.
  double residual() const
  {
    return sum.kinetic + sum.internal() + contact - external_work -
           interface_work - initial - step_change;
  }
};
} // namespace contrecoup::solid
