// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/hex_mesh.h>

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <vector>

namespace contrecoup::solid
{
/**
 * The hexahedra of one rank with all of their nodes. Ranks share nodes but no
 * cells: what cells do to shared nodes is added up by NodeExchange, and each
 * rank then moves them alike.
 *
 * Cells of one tissue follow each other, along a Morton curve; nodes are
 * numbered as cells first need them.
 */
struct SolidMesh
{
  /// Nodes that another rank has as well, in the same order there.
  struct Neighbor
  {
    int rank;
    std::vector<std::uint32_t> nodes;
  };

  std::vector<dealii::Point<3>> nodes; ///< [m]
  std::vector<HexMesh::Cell> cells;    ///< of nodes of this rank
  std::vector<unsigned char> tissue;   ///< of each cell, index in `tissues`
  std::vector<Tissue> tissues;         ///< that are anywhere in the mesh
  std::vector<HexMesh::Facet> boundary;
  /// Those whose cells are here; their masters are, too.
  std::vector<HexMesh::HangingNode> hanging_nodes;

  std::vector<std::uint32_t> global_node;
  std::vector<std::uint32_t> global_cell;
  /// Whether this rank counts a node: one of those that have it does.
  std::vector<unsigned char> owned;
  std::vector<Neighbor> neighbors; ///< by rank, ascending
  std::uint64_t n_global_nodes = 0;
  std::uint64_t n_global_cells = 0;
};

/**
 * The part of this rank: cells along a Morton curve in pieces of equal
 * numbers. Every rank must give the same mesh.
 * @throws InputError for an inverted cell, naming it
 */
SolidMesh distribute(const HexMesh &mesh, MPI_Comm communicator);
} // namespace contrecoup::solid
