// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/triangle_mesh.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// Defects of a surface and their repair.
struct RepairReport
{
  std::size_t n_triangles = 0;  ///< number as read
  std::size_t n_merged = 0;     ///< vertices merged with coincident ones
  std::size_t n_degenerate = 0; ///< triangles without area, and duplicates
  std::size_t n_flipped = 0;    ///< triangles with reversed orientation
  std::size_t n_holes = 0;      ///< closed with new triangles
  std::size_t n_open_edges = 0; ///< left open
  std::size_t n_branching = 0;  ///< edges with more than two triangles
  std::size_t n_pieces = 0;     ///< edge-connected pieces
  double hole_area = 0.;        ///< of the new triangles [m^2]

  /// One line for each kind of defect; empty for a clean surface.
  std::vector<std::string> lines() const;
};

/**
 * Repairs a triangulation in place so that it bounds a body: merges coincident
 * vertices, removes degenerate triangles, orients adjacent triangles
 * consistently and each piece outwards, and closes holes by fans around their
 * centres.
 *
 * A piece is oriented outwards if it had inconsistent orientations, or if its
 * volume is negative and no other piece encloses it. An enclosed piece that is
 * consistently oriented inwards is a cavity and stays.
 */
RepairReport repair(TriangleMesh &mesh);
} // namespace contrecoup
