// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/mesh_layer.h>
#include <contrecoup/ale/mesh/symmetry_planes.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <memory>
#include <set>
#include <string>

namespace contrecoup::ale
{
/**
 * A mesh from a file, such as mesh.msh of `anatomy`: conforming hexahedra,
 * with one layer per material. Entries "File", "Smallest scaled Jacobian" and
 * "Symmetry planes" of subsection "Mesh".
 */
class FileMesh
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError when no file is named
  void parse_parameters(dealii::ParameterHandler &prm);

  /**
   * Reads the file. Material ids are indices in layers(). Boundary ids are 0
   * for the surface, 1, 2, 3 for symmetry planes normal to x, y, z, and
   * boundary_id() for numbered faces of the file.
   * @throws InputError for an unreadable file, for cells that are no
   * hexahedra, are distorted or do not share whole faces, and for symmetry
   * planes that do not bound the mesh
   */
  void create(dealii::Triangulation<3> &mesh) const;

  /// Boundary id of faces with this positive number in the file.
  static dealii::types::boundary_id boundary_id(const unsigned int number)
  {
    return number + 3;
  }

  /// The following functions read the file unless create() did. @throws
  /// InputError

  /// Materials of the file: by the name that the file gives, or by the tissue
  /// with this number.
  const MeshLayers &layers() const
  {
    return statistics().layers;
  }
  double n_cells() const
  {
    return statistics().n_cells;
  }
  /// Shortest edge [m].
  double cell_size() const
  {
    return statistics().cell_size;
  }
  /// Minimum over all cells of scaled_jacobian().
  double smallest_scaled_jacobian() const
  {
    return statistics().scaled_jacobian;
  }
  /// Number of face-connected sets of cells.
  unsigned int n_pieces() const
  {
    return statistics().n_pieces;
  }
  /// Positive numbers of surface faces in the file.
  const std::set<unsigned int> &boundaries() const
  {
    return statistics().boundaries;
  }

  const SymmetryPlanes &symmetry_planes() const
  {
    return planes_;
  }

  /// Computed part of the body [-].
  double computed_fraction() const
  {
    return fraction_within(planes_);
  }

private:
  struct MeshStatistics
  {
    MeshLayers layers;
    double n_cells = 0.;
    double cell_size = 0.;
    double scaled_jacobian = 1.;
    unsigned int n_pieces = 0;
    std::set<unsigned int> boundaries;
  };

  const MeshStatistics &statistics() const;
  void measure_cells(const dealii::Triangulation<3> &mesh,
                     MeshStatistics &found) const;
  void refuse_hanging_nodes(const dealii::Triangulation<3> &mesh) const;
  /// Refuses cells that touch others only at a node or edge.
  /// @return number of face-connected sets of cells
  unsigned int refuse_joints(const dealii::Triangulation<3> &mesh) const;
  MeshLayers number_layers(dealii::Triangulation<3> &mesh) const;
  std::set<unsigned int>
  number_boundaries(dealii::Triangulation<3> &mesh) const;
  void cut_by_plane(dealii::Triangulation<3> &mesh,
                    const unsigned int axis) const;
  [[noreturn]] void refuse(const std::string &reason) const;

  std::string file_;
  double least_jacobian_ = 0.;
  SymmetryPlanes planes_{};
  mutable std::shared_ptr<const MeshStatistics> statistics_;
};
} // namespace contrecoup::ale
