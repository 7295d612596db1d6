// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/leaf_transfer.h>
#include <contrecoup/gas/record/blast_map_transfer.h>

#include <vector>

namespace contrecoup::gas
{
/// Serialises the data of leaves (gas and maps) for transfer between ranks and
/// from the octree before an adaptation to the octree after it.
///
/// deal.II's CellDataTransfer takes one value per cell of the octree: a second
/// copy of the field, in double precision, before and after each adaptation,
/// and knows no meshes of one dimension, which share this class.
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

  /// Data of @p cell after the adaptation: its own data or, if its children
  /// are @p merged, the data of the children restricted to @p cell. The number
  /// of bytes is the same for all cells.
  std::vector<char> pack(const Cell &cell, const bool merged) const;

  /// Writes @p bytes to @p cell or, if it was @p is_refined (refined),
  /// interpolates them to its children. Field and maps must have the size of
  /// the new octree.
  void unpack(const Cell &cell,
              const bool is_refined,
              const char *const bytes) const;

private:
  struct Data
  {
    std::vector<double> gas; ///< see GasField::leaf()
    std::vector<float> maps; ///< see BlastMaps::leaf()
  };

  Data read(const Cell &cell) const;
  Data read_children(const Cell &cell) const;
  void write(const Cell &cell, const Data &data) const;

  const LeafMesh<dim> &mesh_;
  const LeafTransfer<dim> transfer_;
  const BlastMapTransfer<dim> map_transfer_;
  GasField &field_;
  BlastMaps<dim> &maps_;
};
} // namespace contrecoup::gas
