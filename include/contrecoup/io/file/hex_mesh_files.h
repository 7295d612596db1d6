// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/hex_mesh.h>
#include <contrecoup/geometry/shape/shape.h>

#include <string>

namespace contrecoup
{
namespace io
{
  /// Writes the mesh for ParaView (VTU) with cell data `part` and `tissue`
  /// (indices in HexMesh::parts and tissue_names()), and the names of both in
  /// the field data. @throws SystemError
  void write_vtu(const HexMesh &mesh, const std::string &file);

  /// Writes the mesh for Gmsh and deal.II (Gmsh format 2.2, ASCII). The
  /// physical group, deal.II's material id, is the number of the tissue; the
  /// elementary entity is 1 + the part number. @throws SystemError
  void write_msh(const HexMesh &mesh, const std::string &file);

  /// Writes the boundary quadrilaterals for ParaView (VTU) with cell data
  /// `part`, `tissue` and `normal`, the outward normal of @p surface at their
  /// centres, and names as write_vtu(). @throws SystemError
  void write_surface_vtu(const HexMesh &mesh,
                         const Shape &surface,
                         const std::string &file);

  /// Writes the boundary quadrilaterals, as two triangles each (binary STL).
  /// @throws SystemError
  void write_surface_stl(const HexMesh &mesh, const std::string &file);

  /// Writes a table of hanging nodes: node, number of masters, masters,
  /// weights. @throws SystemError
  void write_hanging_nodes(const HexMesh &mesh, const std::string &file);

  /// Writes signed distances on a grid of points around a surface (VTI).
  /// @param spacing of the points [m]
  /// @param margin around the surface [m]
  /// @throws SystemError
  void write_distance(const Shape &surface,
                      double spacing,
                      double margin,
                      const std::string &file);
} // namespace io
} // namespace contrecoup
