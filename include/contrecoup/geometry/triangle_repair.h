// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/triangle_mesh.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// What was wrong with a surface, and what was done to it.
struct RepairReport
{
  std::size_t n_triangles = 0;  ///< as read
  std::size_t n_merged = 0;     ///< vertices at places that others have
  std::size_t n_degenerate = 0; ///< triangles without area or given twice
  std::size_t n_flipped = 0;    ///< triangles turned over
  std::size_t n_holes = 0;      ///< closed with new triangles
  std::size_t n_open_edges = 0; ///< left open
  std::size_t n_branching = 0;  ///< edges of more than two triangles
  std::size_t n_pieces = 0;     ///< connected through edges
  double hole_area = 0.;        ///< of the new triangles [m^2]

  /// One line for each thing found; none for a clean surface.
  std::vector<std::string> lines() const;
};

/**
 * Makes of triangles from a file the boundary of a body, in place: vertices at
 * one place become one, triangles without area go, neighbours are turned to
 * look the same way and each piece outwards, holes are closed by a fan around
 * their middle.
 *
 * A piece that had to be turned in part, or that has a negative volume while
 * no other piece holds it, looks outwards afterwards; one that looks inwards
 * inside another is a cavity and is left alone.
 */
RepairReport repair(TriangleMesh &mesh);
} // namespace contrecoup
