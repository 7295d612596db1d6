// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/state/gas_field.h>

#include <string>

namespace contrecoup::gas
{
/**
 * Writes the leaves of this rank (position in the octree, state and, unless
 * they are empty, maps) to octree.RANK.bin in @p folder. Collective.
 * @throws SystemError when the disk is full
 */
template <int dim>
void save_leaves(const LeafMesh<dim> &mesh,
                 const GasField &field,
                 const std::string &folder,
                 const BlastMaps<dim> *maps = nullptr);

/**
 * Rebuilds octree, state and, if requested, maps from the files of
 * save_leaves(), on any number of ranks. The coarse mesh must have been
 * created. Collective.
 * @throws InputError when the files do not fit the scene or lack the maps
 */
template <int dim>
void restore_leaves(LeafMesh<dim> &mesh,
                    GasField &field,
                    const LeafLayout &layout,
                    const std::string &folder,
                    BlastMaps<dim> *maps = nullptr);
} // namespace contrecoup::gas
