// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/hex_mesh.h>

#include <cstdint>
#include <vector>

namespace contrecoup::solid
{
/// An interface whose two sides have nodes of their own.
struct SlipInterface
{
  /// Two nodes that coincide in the undeformed body.
  struct Pair
  {
    std::uint32_t sliding; ///< of the sliding side
    std::uint32_t held;    ///< of the other side
  };

  std::vector<Pair> pairs;
  /// Faces of the sliding side's cells, with normals out of these cells.
  std::vector<HexMesh::Facet> facets;
};

/**
 * Gives the cells of the tissues @p sliding nodes of their own where they
 * share faces with cells of the tissues @p held. Nodes that cells of any third
 * tissue touch stay shared, and so do nodes where the faces have no common
 * normal.
 * @param entry section of the parameter file, for errors
 * @throws InputError if the tissues have no common face, or if a node of the
 * interface hangs or is a master of one that does
 */
SlipInterface split_interface(HexMesh &mesh,
                              const std::vector<Tissue> &sliding,
                              const std::vector<Tissue> &held,
                              const std::string &entry);
} // namespace contrecoup::solid
