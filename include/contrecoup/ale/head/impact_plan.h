// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/head/head_estimate.h>
#include <contrecoup/base/simulation.h>

#include <vector>

namespace contrecoup::ale
{
/**
 * What a run on a moving mesh leaves out, with the numbers that tell whether it
 * may:
 *
 *   cavitation        least pressure of each liquid that bears any tension; of
 *                     a head before the run that of ShellImpact
 *   contact           its end over that of the run; of a head before the run
 *                     that of ShellImpact
 *   gravity           its speed over that of the impact
 *   viscosity         of liquids: the layer that that of water makes at
 *                     walls in the time of the run is thinner than a cell
 *   friction          work of planes along themselves over the kinetic energy;
 *                     where they have none, that of a coefficient of 0.3
 *   scalp             mass of 5 mm of it over that of a head without one
 *   symmetry          part of the cost that planes of symmetry or a wedge save
 *   asymmetry         motion across them, which they do not allow
 *   unused_symmetry   part of the cost that further ones would save
 *   coupling          energy that fluids and solids solved in turn make up
 *   mesh              of a file: the worst cell's scaled Jacobian
 *   pieces            of a file: sets of cells that no face joins, between
 *                     which there is no contact
 */
struct ImpactPlan
{
  std::vector<Region> regions;
  std::vector<ContactPlane> planes;
  std::optional<HeadEstimate> head;
  double end_time = 0.;          ///< [s]
  dealii::Tensor<1, 3> velocity; ///< of the fastest matter at the start [m/s]
  double cell_size = 0.;         ///< [m]
  double part = 1.;              ///< of the body that is computed [-]
  double cost = 1.;              ///< of that part over that of the body [-]
  std::string wedge;  ///< axis of the one that is computed; empty: none is
  double enough = 1.; ///< cost that would do, by symmetry of the scene [-]
  std::string enough_wedge; ///< axis of a wedge that it is of; empty: none
  double asymmetry = 0.; ///< part of the motion across planes of symmetry [-]
  /// Of a file; 0: the mesh is from none.
  unsigned int n_pieces = 0;
  double scaled_jacobian = 1.; ///< the least
  bool has_body_force = false;
  std::string coupling; ///< scheme that solves in turn; empty: monolithic

  /// What a run found.
  struct Findings
  {
    std::vector<double> least_pressures; ///< by region [Pa]
    double contact_end = 0.;             ///< below 0: there was none [s]
    double friction_work = 0.;           ///< [J]
    double sliding_work = 0.;            ///< see ContactMeasures [J]
    double kinetic_energy = 0.;          ///< at the start [J]
    double interface_work = 0.;          ///< see InterfaceCoupling [J]
    double largest_energy = 0.;          ///< that the ledger has seen [J]
  };

  /// As estimated from the scene.
  std::vector<Assumption> plan() const;
  std::vector<Assumption> audit(const Findings &findings) const;

private:
  bool has_friction() const;
  double expected_tension(const Region &region) const;
  double expected_friction() const;
  void add_liquids(std::vector<Assumption> &items) const;
  void add_contact(std::vector<Assumption> &items) const;
  void add_symmetry(std::vector<Assumption> &items) const;
  void add_file(std::vector<Assumption> &items) const;
};
} // namespace contrecoup::ale
