// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/hex_mesh.h>
#include <contrecoup/geometry/shape.h>

#include <string>

namespace contrecoup
{
namespace io
{
  /// Writes hexahedra for ParaView (VTU) with cell data `part` and `tissue`
  /// (numbers of HexMesh::parts and of tissue_names()). @throws SystemError
  void write_vtu(const HexMesh &mesh, const std::string &file);

  /// Writes hexahedra for Gmsh and deal.II (Gmsh's format 2.2, ASCII): the
  /// physical group, deal.II's material id, is the number of the tissue, the
  /// elementary one 1 + that of the part. @throws SystemError
  void write_msh(const HexMesh &mesh, const std::string &file);

  /// Writes the outer quadrilaterals for ParaView (VTU) with cell data
  /// `part`, `tissue` and `normal`, the outward normal of @p surface at the
  /// middle of each. @throws SystemError
  void write_surface_vtu(const HexMesh &mesh,
                         const Shape &surface,
                         const std::string &file);

  /// Writes the outer quadrilaterals as two triangles each (binary STL).
  /// @throws SystemError
  void write_surface_stl(const HexMesh &mesh, const std::string &file);

  /// Writes the hanging nodes as a table: node, number of masters, masters,
  /// weights. @throws SystemError
  void write_hanging_nodes(const HexMesh &mesh, const std::string &file);

  /// Writes signed distances on a grid of points around a surface (VTI), with
  /// @p margin to spare on all sides.
  /// @param spacing of the points [m]
  /// @throws SystemError
  void write_distance(const Shape &surface,
                      double spacing,
                      double margin,
                      const std::string &file);
} // namespace io
} // namespace contrecoup
