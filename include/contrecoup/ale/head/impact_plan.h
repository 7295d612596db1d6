// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/head/head_estimate.h>
#include <contrecoup/ale/lagrange/contact_record.h>
#include <contrecoup/base/run/simulation.h>
#include <contrecoup/numerics/injury/own_thresholds.h>

#include <limits>
#include <vector>

namespace contrecoup::ale
{
/**
 * Assumptions of a run on a moving mesh, with the figures that tell whether
 * they hold:
 *
 *   cavitation        least pressure of each liquid that sustains tension; of
 *                     a head before the run, that of ShellImpact
 *   contact           end of contact over end time; of a head before the run,
 *                     that of ShellImpact
 *   gravity           velocity by gravity over impact velocity
 *   viscosity         of liquids: thickness of water's boundary layer at walls
 *                     at the end time, over the cell size
 *   friction          frictional work of planes over kinetic energy; of planes
 *                     without friction, for a coefficient of 0.3
 *   brain             of a head without one: regions that are it
 *   scalp             mass of 5 mm of scalp over that of a head without scalp
 *   symmetry          cost that symmetry planes or a wedge save
 *   asymmetry         walls that are inclined to symmetry planes, beyond which
 *                     there are their mirror images
 *   unused_symmetry   cost that further symmetry planes would save
 *   coupling          spurious energy of a partitioned fluid-solid coupling
 *   mesh              of a file: smallest scaled Jacobian
 *   pieces            of a file: face-connected sets of cells; the run has no
 *                     contact between them
 *   own_MEASURE       the user's own thresholds of a measure of injury
 */
struct ImpactPlan
{
  std::vector<Region> regions;
  std::vector<ContactPlane> planes;
  std::optional<HeadEstimate> head;
  double end_time = 0.;          ///< [s]
  dealii::Tensor<1, 3> velocity; ///< largest initial velocity of matter [m/s]
  double cell_size = 0.;         ///< [m]
  double computed_fraction = 1.; ///< computed part of the body [-]
  double cost = 1.;              ///< over that of the whole body [-]
  std::string wedge;             ///< axis of the computed wedge; empty: none
  double least_cost = 1.; ///< cost with all symmetry of the scene used [-]
  std::string least_cost_wedge; ///< axis of a wedge for that cost; empty: none
  double asymmetry = 0.;        ///< see ImpactScene::motion_along() [-]
  /// Number of pieces of a mesh file; 0: other mesh.
  unsigned int n_pieces = 0;
  double scaled_jacobian = 1.; ///< the smallest
  bool has_body_force = false;
  bool has_brain = true;
  std::string coupling; ///< partitioned scheme; empty: monolithic
  OwnThresholds thresholds;

  /// Results of a run.
  struct ImpactResults
  {
    std::vector<double> least_pressures; ///< by region [Pa]
    ContactRecord contact;
    double friction_work = 0.;  ///< [J]
    double sliding_work = 0.;   ///< see ContactMeasures [J]
    double kinetic_energy = 0.; ///< at the start [J]
    double interface_work = 0.; ///< see InterfaceCoupling [J]
    double largest_energy = 0.; ///< largest total energy so far [J]
    /// Time that the run has come to [s].
    double time = std::numeric_limits<double>::max();
  };

  /// Estimates before the run.
  std::vector<Assumption> plan() const;
  std::vector<Assumption> audit(const ImpactResults &results) const;

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
