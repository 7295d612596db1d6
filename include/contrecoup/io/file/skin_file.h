// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Facets of a body's surface: polygons or, in 2-D, lines, between vertices
  /// that neighbours share.
  struct SkinMesh
  {
    bool are_lines = false;
    std::vector<float> vertices;        ///< three numbers each [m]
    std::vector<std::uint32_t> corners; ///< vertices, facet after facet
    std::vector<std::int64_t> ends;     ///< of each facet in corners
  };

  /// Joins the corners of facets, three numbers each [m]; those with equal
  /// numbers become one vertex.
  SkinMesh make_skin_mesh(const std::vector<std::vector<float>> &outlines,
                          const bool are_lines);

  /// A number for each facet.
  struct SkinField
  {
    std::string name;
    std::string unit;
    std::vector<float> values;
  };

  /// Writes facets and fields at a time [s] as VTK PolyData (.vtp).
  /// @throws SystemError when the disk is full
  void write_skin(const std::string &file,
                  const SkinMesh &skin,
                  const std::vector<SkinField> &fields,
                  const double time);
} // namespace io
} // namespace contrecoup
