// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/region.h>
#include <contrecoup/base/simulation.h>

#include <vector>

namespace contrecoup::ale
{
/**
 * What a run on a moving mesh leaves out, with the numbers that tell whether it
 * may:
 *
 *   cavitation     least pressure of each liquid that bears any tension
 *   gravity        its speed over that of the impact
 *   viscosity      of liquids: the layer that that of water makes at walls in
 *                  the time of the run is thinner than a cell
 *   friction       work of planes along themselves over the kinetic energy
 *   symmetry       part of the body that is computed
 */
struct ImpactPlan
{
  std::vector<Region> regions;
  double end_time = 0.;      ///< [s]
  double largest_speed = 0.; ///< of the matter at the start [m/s]
  double cell_size = 0.;     ///< [m]
  double part = 1.;          ///< of the body that is computed [-]
  bool has_planes = false;
  bool has_body_force = false;

  /// What a run found.
  struct Findings
  {
    std::vector<double> least_pressures; ///< by region [Pa]
    double friction_work = 0.;           ///< [J]
    double kinetic_energy = 0.;          ///< at the start [J]
  };

  /// As estimated from the scene.
  std::vector<Assumption> plan() const;
  std::vector<Assumption> audit(const Findings &findings) const;
};
} // namespace contrecoup::ale
