// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/file_mesh.h>
#include <contrecoup/ale/mesh/layered_head.h>
#include <contrecoup/ale/mesh/slip_walls.h>
#include <contrecoup/base/expression.h>
#include <contrecoup/geometry/body_description.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace contrecoup::ale
{
/**
 * The mesh of a scene, and what is at its sides: subsections "Mesh" and
 * "Side *"; particles also fill a body, subsection "Body". Sides have names:
 * x-, x+, y-, y+, z-, z+ of a box, sphere and plane of a half ball, which lies
 * at x >= 0; surface, plane x, plane y, plane z of a layered head and of a
 * file, of which the numbers that it gives to faces are sides, too. Expressions
 * move the nodes: a box becomes a wedge, a cone, or skewed.
 */
class MeshDescription
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError when entries do not go together
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Builds the mesh, all cells on one level. Material ids are those of
  /// layers(), if there are any.
  /// @throws InputError for cells that the moved nodes invert, and for a file
  /// that cannot be used
  void create(dealii::Triangulation<3> &mesh) const;

  /// Layers of a layered head, materials of a file; none of other meshes.
  /// @throws InputError for a file that cannot be used
  const MeshLayers &layers() const
  {
    return kind_ == "file"   ? file_.layers()
           : kind_ == "body" ? body_layers_
                             : head_.layers();
  }

  /// The mesh of a file; null for others.
  const FileMesh *file() const
  {
    return kind_ == "file" ? &file_ : nullptr;
  }

  /// Part of the body that is computed, by planes of symmetry [-].
  double part() const
  {
    return kind_ == "file" ? file_.part() : head_.part();
  }

  /// Planes of symmetry, those through the axis of a wedge among them.
  const SymmetryPlanes &symmetry_planes() const
  {
    return kind_ == "file" ? file_.symmetry_planes() : head_.is_halved();
  }

  /// The wedge that the mesh is; without a slope: none.
  HexWedge wedge() const
  {
    return kind_ == "layered head" ? head_.wedge() : HexWedge();
  }

  /// Whether layer_at() tells layers apart.
  bool has_layers() const
  {
    return kind_ == "layered head" || kind_ == "body";
  }

  /// The layered head; null for other meshes, and where nodes are moved.
  const LayeredHead *head() const
  {
    return kind_ == "layered head" && position_.empty() ? &head_ : nullptr;
  }

  /// The layer at a place of the undeformed mesh, 0 where the mesh has none;
  /// -1 outside of it. @throws InputError for moved nodes and files, whose
  /// inside is not known
  int layer_at(const dealii::Point<3> &place) const;

  /// Lower and upper corner around the mesh [m]. @throws InputError likewise
  std::array<dealii::Point<3>, 2> corners() const;

  /// Whether x-, x+, y-, y+, z-, z+ of the corners are walls at rest.
  /// @throws InputError for walls that move
  std::array<bool, 6> sides_at_rest() const;

  /// Which of them hold what touches them.
  std::array<bool, 6> clamped_sides() const;

  /// Thickness of the thinnest layer around the brain of a layered head, and
  /// how far its middle along x is from the centre [m].
  std::pair<double, double> thinnest_layer() const;

  /// Of the rigid sphere around a half ball; 0: there is none [m].
  double sphere_radius() const
  {
    return kind_ == "half ball" && walls_.count(0) == 1 ? radius_ : 0.;
  }

  /// How many cells create() makes.
  double n_cells() const;

  /// About the shortest edge of a cell [m].
  /// @throws InputError for cells that the moved nodes invert
  double cell_size() const;

  /// How fast walls move until @p end_time [s] at most, of some times [m/s].
  double largest_wall_speed(const double end_time) const;

  /// Sides along which matter slides; all others are free.
  const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls() const
  {
    return walls_;
  }

private:
  const std::vector<std::string> &side_names() const;
  /// The boundary id of a side. @throws InputError for none of this kind
  dealii::types::boundary_id find_side(const std::string &name) const;
  /// @throws InputError for a numbered side that the file does not have
  void check_numbered_sides() const;
  void parse_sides(dealii::ParameterHandler &prm);
  /// @throws InputError for a side that is no plane
  void clamp(const dealii::types::boundary_id side, const std::string &name);
  /// Which of the sides of corners() are chosen by their ids.
  template <typename Choice>
  std::array<bool, 6> box_sides(const Choice &is_chosen) const;
  void move_nodes(dealii::Triangulation<3> &mesh) const;

  std::string kind_;
  dealii::Point<3> lower_, upper_;
  std::vector<unsigned int> elements_;
  double radius_ = 0.;
  LayeredHead head_;
  FileMesh file_;
  BodyPointer body_;       ///< null for other meshes
  MeshLayers body_layers_; ///< tissues of its parts
  std::set<unsigned int> numbered_sides_;
  unsigned int refinements_ = 0;
  std::vector<Expression> position_; ///< x, y, z; none: nodes stay
  std::map<dealii::types::boundary_id, SlipWalls::Motion> walls_;
  std::set<dealii::types::boundary_id> clamped_; ///< those of them that hold
};
} // namespace contrecoup::ale
