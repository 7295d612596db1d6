// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/file_mesh.h>
#include <contrecoup/ale/mesh/layered_head.h>
#include <contrecoup/ale/mesh/slip_walls.h>
#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/geometry/body/body_description.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace contrecoup::ale
{
/**
 * The mesh of a scene and the conditions at its sides: subsections "Mesh" and
 * "Side *". Particles may also fill a body: subsection "Body". Names of sides
 * are x-, x+, y-, y+, z-, z+ of a box; sphere and plane of a half ball, which
 * lies at x >= 0; surface, plane x, plane y, plane z of a layered head and of
 * a file, plus the numbered faces of a file. Expressions may move the nodes,
 * for example to make a wedge or a cone of a box.
 */
class MeshDescription
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for contradictory entries
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Builds the mesh with all cells on one refinement level. Material ids are
  /// indices in layers().
  /// @throws InputError for cells that the moved nodes invert, and for an
  /// unusable file
  void create(dealii::Triangulation<3> &mesh) const;

  /// Layers of a layered head or a body, or materials of a file; empty for
  /// other meshes.
  /// @throws InputError for an unusable file
  const MeshLayers &layers() const
  {
    return kind_ == "file"   ? file_.layers()
           : kind_ == "body" ? body_layers_
                             : head_.layers();
  }

  /// The mesh of a file; null for other kinds.
  const FileMesh *file() const
  {
    return kind_ == "file" ? &file_ : nullptr;
  }

  /// Computed part of the body with symmetry planes [-].
  double computed_fraction() const
  {
    return kind_ == "file" ? file_.computed_fraction()
                           : head_.computed_fraction();
  }

  /// Symmetry planes, including those through the axis of a wedge.
  const SymmetryPlanes &symmetry_planes() const
  {
    return kind_ == "file" ? file_.symmetry_planes() : head_.is_halved();
  }

  /// The wedge that the mesh forms; without a slope: none.
  HexWedge wedge() const
  {
    return kind_ == "layered head" ? head_.wedge() : HexWedge();
  }

  /// Whether layer_at() distinguishes layers.
  bool has_layers() const
  {
    return kind_ == "layered head" || kind_ == "body";
  }

  /// The layered head; null for other kinds and with moved nodes.
  const LayeredHead *head() const
  {
    return kind_ == "layered head" && position_.empty() ? &head_ : nullptr;
  }

  /// Layer at a point of the undeformed mesh; 0 in a mesh without layers, -1
  /// outside the mesh.
  /// @throws InputError for moved nodes and files, where it is unknown
  int layer_at(const dealii::Point<3> &place) const;

  /// Bounding box of the mesh [m]. @throws InputError as layer_at()
  std::array<dealii::Point<3>, 2> corners() const;

  /// Whether each side x-, x+, y-, y+, z-, z+ of corners() is a fixed wall.
  /// @throws InputError for moving walls
  std::array<bool, 6> sides_at_rest() const;

  /// Whether each of these sides clamps the matter.
  std::array<bool, 6> clamped_sides() const;

  /// A layer around the brain of a layered head.
  struct Shell
  {
    std::string name;
    double thickness;   ///< [m]
    double middle;      ///< distance from the centre along x [m]
    unsigned int cells; ///< across the layer, of the mesh
  };
  /// The layers around the brain; empty for other kinds of mesh.
  std::vector<Shell> shells() const;

  /// Radius of the rigid sphere around a half ball; 0: none [m].
  double sphere_radius() const
  {
    return kind_ == "half ball" && walls_.count(0) == 1 ? radius_ : 0.;
  }

  /// Number of cells of create().
  double n_cells() const;

  /// Approximate shortest edge of a cell [m].
  /// @throws InputError for cells that the moved nodes invert
  double cell_size() const;

  /// Largest wall speed up to @p end_time, sampled in time [m/s].
  double largest_wall_speed(const double end_time) const;

  /// Slip walls by boundary id; other sides are free.
  const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls() const
  {
    return walls_;
  }

private:
  const std::vector<std::string> &side_names() const;
  /// Boundary id of a side. @throws InputError for an unknown side
  dealii::types::boundary_id find_side(const std::string &name) const;
  /// @throws InputError for a numbered side that the file does not have
  void check_numbered_sides() const;
  void parse_sides(dealii::ParameterHandler &prm);
  /// @throws InputError for a plane of symmetry that there is not, or that is
  /// free or moves
  void check_symmetry_plane(const dealii::ParameterHandler &prm,
                            const std::string &name) const;
  /// @throws InputError for a side that is no plane
  void clamp(const dealii::types::boundary_id side, const std::string &name);
  /// Which sides of corners() have an id that @p is_chosen accepts.
  template <typename Choice>
  std::array<bool, 6> box_sides(const Choice &is_chosen) const;
  void move_nodes(dealii::Triangulation<3> &mesh) const;

  std::string kind_;
  dealii::Point<3> lower_, upper_;
  std::vector<unsigned int> elements_;
  double radius_ = 0.;
  LayeredHead head_;
  FileMesh file_;
  BodyPointer body_;       ///< null for other kinds
  MeshLayers body_layers_; ///< tissues of the parts of the body
  std::set<unsigned int> numbered_sides_;
  unsigned int refinements_ = 0;
  std::vector<Expression> position_; ///< x, y, z; empty: nodes stay
  std::map<dealii::types::boundary_id, SlipWalls::Motion> walls_;
  /// those of walls_ that clamp
  std::set<dealii::types::boundary_id> clamped_;
};
} // namespace contrecoup::ale
