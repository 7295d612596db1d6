// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/body/body_layer.h>
#include <contrecoup/geometry/mesh/hex_mesh.h>
#include <contrecoup/geometry/mesh/mesh_groups.h>
#include <contrecoup/geometry/mesh/mesh_smoothing.h>
#include <contrecoup/solid/body/solid_materials.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <set>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/// The hexahedral mesh of a scene: subsection "Mesh", and "Body" for a mesh of
/// the body that `anatomy` builds.
class MeshDescription
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for contradictory entries
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Builds the mesh. @throws InputError when a file cannot be used
  HexMesh create() const;

  /// Names of the layers in which the elements of create() leave holes: of
  /// their tissue if that has no other parts, else of the part.
  std::set<std::string> thin_parts(const HexMesh &mesh) const;

  /// Mass of the phantom that the body is [kg]; NaN for other bodies.
  double phantom_mass() const;

  /// Estimates the number of elements of create().
  double estimate_elements() const;

  /// Estimates the stable step [s] from the smallest element size and the
  /// largest wave speed.
  double estimate_step(const SolidMaterials &materials) const;

private:
  /// Elements with a true expression get this tissue; later regions win.
  struct Region
  {
    std::string name;
    Tissue tissue;
    Expression where;
  };

  void parse_shape(dealii::ParameterHandler &prm);
  void make_shape(dealii::Triangulation<3> &mesh) const;
  void make_patch(dealii::Triangulation<3> &mesh) const;
  void refine(dealii::Triangulation<3> &mesh) const;
  HexMesh from_triangulation() const;
  HexMesh from_body() const;
  void set_regions(HexMesh &mesh) const;

  std::string kind_;
  dealii::Point<3> lower_;
  dealii::Point<3> upper_;
  std::vector<unsigned int> elements_;
  double inner_radius_ = 0.;
  double outer_radius_ = 0.;
  unsigned int refinements_ = 0;
  std::vector<Expression> refined_where_;
  double distortion_ = 0.;
  std::string file_;
  MeshGroups groups_; ///< of the file
  Tissue tissue_ = Tissue::soft_tissue;
  std::vector<Region> regions_;

  BodyDescription body_;
  std::vector<BodyLayer> layers_;
  double element_size_ = 0.;
  unsigned int levels_ = 0;
  SmoothingOptions smoothing_;
};
} // namespace contrecoup::solid
