// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/body/file_unit.h>
#include <contrecoup/geometry/mesh/hex_mesh.h>
#include <contrecoup/geometry/mesh/mesh_groups.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>
#include <vector>

namespace contrecoup
{
/// A body of hexahedra of one's own. Its surface consists of the boundary
/// facets, each of two triangles.
class MeshBody : public Body
{
public:
  /// @param mesh without hanging nodes
  explicit MeshBody(HexMesh mesh);

  BodyPointer placed(const Placement &placement) const override;
  ShapePointer surface() const override;
  unsigned char part_at(const dealii::Point<3> &point) const override;
  void fill(LabelGrid &grid) const override;
  std::shared_ptr<const HexMesh> own_mesh() const override;

private:
  struct Search;

  bool contains(std::uint32_t cell, const dealii::Point<3> &point) const;

  std::shared_ptr<const HexMesh> mesh_;
  std::shared_ptr<const Search> search_; ///< for cells
  ShapePointer surface_;
};


/// Description of a body from a mesh file.
class MeshBodyDescription
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @throws InputError without a file, or for a wrong table of tissues
  void parse_parameters(dealii::ParameterHandler &prm);

  /// @param scale later scale of the body, for the check of its size
  /// @throws InputError when the file cannot be read, has inverted cells or
  /// hanging nodes, or groups without tissue
  BodyPointer create(double scale) const;

private:
  std::string file_;
  FileUnit unit_;
  MeshGroups groups_;
};
} // namespace contrecoup
