// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/head/head_record.h>
#include <contrecoup/ale/head/impact_plan.h>
#include <contrecoup/ale/lagrange/contact_planes.h>
#include <contrecoup/ale/mesh/mesh_description.h>
#include <contrecoup/ale/mesh/region_descriptions.h>
#include <contrecoup/base/parameters/expression.h>

#include <array>
#include <vector>

namespace contrecoup::ale
{
/// The entries of an impact that both methods share, moving meshes and
/// particles.
struct ImpactScene
{
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError
  void parse_parameters(dealii::ParameterHandler &prm);

  bool has_body_force() const;

  /// Whether the plane normal to an axis through the origin is one of symmetry.
  bool has_symmetry_plane(const unsigned int axis) const
  {
    return (mesh.file() != nullptr || mesh.has_layers()) &&
           mesh.symmetry_planes()[axis];
  }

  /// Motion along an axis, relative to all motion: of matter, by the normals
  /// of planes, or 1 for a body force [-].
  double motion_along(const unsigned int axis) const;

  /// Assumptions of a run on the whole computed part of the body, without those
  /// of the method.
  ImpactPlan plan(const HeadRecord &head) const;

  MeshDescription mesh;
  RegionDescriptions regions;
  ContactPlanes planes;
  /// Body force per mass along x, y and z [m/s^2].
  std::array<Expression, 3> acceleration{{{"", "0"}, {"", "0"}, {"", "0"}}};
  std::vector<dealii::Point<3>> probes; ///< [m]
  double courant_number = 0.3;
  unsigned int largest_retries = 10;
  double end_time = 0.; ///< [s]
};
} // namespace contrecoup::ale
