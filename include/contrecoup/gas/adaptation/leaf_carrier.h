// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/leaf_origins.h>
#include <contrecoup/gas/adaptation/leaf_transfer.h>
#include <contrecoup/gas/record/blast_map_transfer.h>

#include <vector>

namespace contrecoup::gas
{
/// Carries the data of leaves (gas and maps) from the octree before an
/// adaptation to the octree after it, and serialises them for other ranks.
///
/// deal.II's CellDataTransfer serialises all leaves twice, changed or not, in
/// double precision, which took a third of the time of an adaptation. Here
/// leaves that stay on their rank are copied.
template <int dim>
class LeafCarrier
{
public:
  using Cell = typename LeafMesh<dim>::CellIterator;

  /// Keeps references to mesh, field and maps; empty maps are skipped.
  LeafCarrier(const LeafMesh<dim> &mesh,
              const LeafPoints<dim> &points,
              const GasMaterial &material,
              GasField &field,
              BlastMaps<dim> &maps);

  /// Gives field and maps the size of the present mesh and takes the data of
  /// each leaf from its origin: of refined leaves interpolated, of merged ones
  /// restricted.
  void carry_over(const std::vector<LeafOrigin> &origins) const;

  /// Data of @p cell. The number of bytes is the same for all cells.
  std::vector<char> pack(const Cell &cell) const;

  /// Writes @p bytes to @p cell. Field and maps must have the size of the mesh.
  void unpack(const Cell &cell, const char *const bytes) const;

private:
  void copy_former_leaves(const std::vector<LeafOrigin> &origins) const;
  /// Sets @p leaf and the next ones, the children of one former leaf.
  void refine(const unsigned int leaf, const unsigned int former) const;
  void merge(const unsigned int leaf, const unsigned int former) const;

  const LeafMesh<dim> &mesh_;
  const LeafTransfer<dim> transfer_;
  const BlastMapTransfer<dim> map_transfer_;
  GasField &field_;
  BlastMaps<dim> &maps_;
};
} // namespace contrecoup::gas
