// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/hex_mesh.h>
#include <contrecoup/solid/body/slip_interface.h>

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/**
 * One rank's part of the mesh: its hexahedra and all of their nodes. Ranks
 * share nodes but no cells. NodeExchange sums cell contributions to shared
 * nodes, and each rank then moves its copy of a shared node identically.
 *
 * Cells are sorted by tissue and, within a tissue, along a Morton curve. Nodes
 * are numbered in the order in which cells first use them.
 */
struct SolidMesh
{
  /// The nodes shared with another rank, in the same order on both ranks.
  struct Neighbor
  {
    int rank;
    std::vector<std::uint32_t> nodes;
  };

  std::vector<dealii::Point<3>> nodes; ///< [m]
  std::vector<HexMesh::Cell> elements; ///< node numbers are local
  std::vector<unsigned char> tissue;   ///< index in `tissues`, by cell
  std::vector<Tissue> tissues;         ///< all tissues of the whole mesh
  std::vector<HexMesh::Facet> boundary;
  /// Hanging nodes of this rank's cells; their masters are local as well.
  std::vector<HexMesh::HangingNode> hanging_nodes;
  /// Pairs with a node of this rank's cells; both nodes are local. Facets are
  /// those of this rank's cells.
  SlipInterface slip;

  std::vector<std::uint32_t> global_node;
  std::vector<std::uint32_t> global_element;
  /// Whether this rank owns a node; each node has exactly one owner.
  std::vector<unsigned char> owned;
  std::vector<Neighbor> neighbors; ///< by rank, ascending
  std::uint64_t n_global_nodes = 0;
  std::uint64_t n_global_elements = 0;
};

/**
 * Distributes the mesh: each rank receives an equal piece of the Morton curve
 * through all cells. All ranks must pass the same mesh.
 * @param slip the interface at which the mesh was split, if any
 * @throws InputError for an inverted cell, naming it
 */
SolidMesh distribute(const HexMesh &mesh,
                     MPI_Comm communicator,
                     const SlipInterface &slip = {});

/// Extent of the body in words: "the body lies from (0, 0, 0) to (1, 1, 1) m".
/// Collective.
std::string extent_in_words(const SolidMesh &mesh, MPI_Comm communicator);

/// Undeformed volume of a local cell [m^3].
double cell_volume(const SolidMesh &mesh, const std::uint32_t cell);
} // namespace contrecoup::solid
