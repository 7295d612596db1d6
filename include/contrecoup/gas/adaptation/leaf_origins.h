// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_mesh.h>

#include <vector>

namespace contrecoup::gas
{
/// Which leaf a leaf of an adapted octree comes from.
struct LeafOrigin
{
  enum class Change : unsigned char
  {
    none,
    refined, ///< child of the former leaf
    merged   ///< parent of 2^dim former leaves
  };
  unsigned int former; ///< number of the (first) former leaf
  Change change;
  unsigned char child; ///< number within the former leaf, if refined
};


/// Levels of the owned leaves, in their order.
template <int dim>
std::vector<unsigned char> leaf_levels(const LeafMesh<dim> &mesh);

/**
 * Origins of leaves from their levels and those of the leaves before the
 * octree changed: both stand in Morton order and cover the same coarse cells.
 * Throws std::logic_error if they do not, or if a leaf changed by more than one
 * level.
 */
template <int dim>
std::vector<LeafOrigin>
leaf_origins(const std::vector<unsigned char> &former_levels,
             const std::vector<unsigned char> &levels);
} // namespace contrecoup::gas
