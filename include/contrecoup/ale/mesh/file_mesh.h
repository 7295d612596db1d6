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
 * The mesh of a file, as `anatomy` writes mesh.msh: conforming hexahedra, whose
 * materials are its layers. Entries "File", "Smallest scaled Jacobian" and
 * "Symmetry planes" of subsection "Mesh".
 */
class FileMesh
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError when no file is named
  void parse_parameters(dealii::ParameterHandler &prm);

  /**
   * Reads the file. Material ids are numbers in layers(). Boundary ids are 0
   * for the surface, 1, 2, 3 for planes of symmetry normal to x, y, z, and
   * boundary_id() for what the file numbers.
   * @throws InputError for a file that cannot be read, cells that are no
   * hexahedra, distorted, or do not meet at whole faces, and for planes of
   * symmetry at which the mesh does not end
   */
  void create(dealii::Triangulation<3> &mesh) const;

  /// The boundary id of faces to which the file gives this number, above 0.
  static dealii::types::boundary_id boundary_id(const unsigned int number)
  {
    return number + 3;
  }

  /// What follows reads the file if create() did not. @throws InputError

  /// Its materials: the name that the file gives, or that of the tissue of this
  /// number.
  const MeshLayers &layers() const
  {
    return findings().layers;
  }
  double n_cells() const
  {
    return findings().n_cells;
  }
  /// The shortest edge [m].
  double cell_size() const
  {
    return findings().cell_size;
  }
  /// Of all cells, see scaled_jacobian().
  double smallest_scaled_jacobian() const
  {
    return findings().scaled_jacobian;
  }
  /// Sets of cells that are joined by faces.
  unsigned int n_pieces() const
  {
    return findings().n_pieces;
  }
  /// The numbers that the file gives to faces of the surface, above 0.
  const std::set<unsigned int> &boundaries() const
  {
    return findings().boundaries;
  }

  const SymmetryPlanes &symmetry_planes() const
  {
    return planes_;
  }

  /// Part of the body that is computed [-].
  double part() const
  {
    return computed_part(planes_);
  }

private:
  struct Findings
  {
    MeshLayers layers;
    double n_cells = 0.;
    double cell_size = 0.;
    double scaled_jacobian = 1.;
    unsigned int n_pieces = 0;
    std::set<unsigned int> boundaries;
  };

  const Findings &findings() const;
  void measure_cells(const dealii::Triangulation<3> &mesh,
                     Findings &found) const;
  void refuse_hanging_nodes(const dealii::Triangulation<3> &mesh) const;
  /// Refuses cells that touch the others at a node alone.
  /// @return how many sets of cells there are that no face joins
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
  mutable std::shared_ptr<const Findings> findings_;
};
} // namespace contrecoup::ale
