// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/boundary.h>
#include <contrecoup/gas/conditions/initial_state.h>
#include <contrecoup/gas/conditions/reference_solution.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/explosive/charge_set.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/octree/scheme.h>

#include <deal.II/base/parameter_handler.h>

namespace contrecoup::gas
{
/// The gas, what surrounds it and the method that computes it, as the
/// parameter file describes them. Nothing of it changes in a run, but for the
/// initial state, which a first stage may hand over.
template <int dim>
struct GasScene
{
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the scene, and writes remarks on it into the log.
  /// @throws InputError when parts of it do not go together.
  void parse_parameters(dealii::ParameterHandler &prm);

  /// The gas before anything happened, in the domain's upper corner.
  GasState<dim> ambient() const
  {
    return initial_state.ambient(coarse_mesh.upper_corner());
  }

  /// @throws InputError for a place outside of a box; @p what begins the
  /// message, such as "Probes/Points: the point".
  void require_inside(const dealii::Point<dim> &place,
                      const std::string &what) const;

  /// Where point @p q of a leaf is [m].
  dealii::Point<dim> place(const LeafBox<dim> &leaf,
                           const unsigned int q) const;

  CoarseMesh<dim> coarse_mesh;
  GasMaterial material;
  std::string material_words; ///< see ProfileData::material
  Scheme scheme;
  InitialState<dim> initial_state;
  ChargeSet<dim> charges;
  ReferenceSolution<dim> reference;
  Boundary<dim> boundary;
  RigidBody body; ///< may be empty
  LeafLayout layout;
  LeafPoints<dim> points;
  double end_time = 0.; ///< [s]

  /// Checks the number of subcells against the body.
  /// @throws InputError for too few, or an odd number with levels of the body
  void check_subcells() const;

private:
  void check_body() const;
};
} // namespace contrecoup::gas
