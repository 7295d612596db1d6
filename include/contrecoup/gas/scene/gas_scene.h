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
/// The problem of a gas run as given by the parameter file: gas, domain,
/// boundaries, charges, body, reference solution and numerical method. Constant
/// during a run, except that the hand-over of a first stage replaces the
/// initial state.
template <int dim>
struct GasScene
{
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the scene, and logs remarks on it.
  /// @throws InputError for parts that do not fit together.
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Undisturbed state of the gas at the domain's upper corner.
  GasState<dim> ambient() const
  {
    return initial_state.ambient(coarse_mesh.upper_corner());
  }

  /// @throws InputError for a position outside of a box domain
  /// @param what beginning of the message, such as "Probes/Points: the point"
  void require_inside(const dealii::Point<dim> &place,
                      const std::string &what) const;

  /// Position of point @p q of a leaf [m].
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

  /// Checks the number of subcells per leaf against the body.
  /// @throws InputError for too few, or for an odd number with levels of the
  /// body
  void check_subcells() const;

private:
  void check_body() const;
};
} // namespace contrecoup::gas
