// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/leaf_transfer.h>
#include <contrecoup/gas/record/blast_map_transfer.h>

#include <vector>

namespace contrecoup::gas
{
/// What leaves hold, gas and maps, as bytes that travel between ranks and
/// from the octree before an adaptation to the one after it.
template <int dim>
class LeafCarrier
{
public:
  using Cell = typename LeafMesh<dim>::CellIterator;

  /// Keeps references to mesh, field and maps; empty maps are left out.
  LeafCarrier(const LeafMesh<dim> &mesh,
              const LeafPoints<dim> &points,
              const GasMaterial &material,
              GasField &field,
              BlastMaps<dim> &maps);

  /// What @p cell will hold: its own data or, when its children are
  /// @p merged, theirs together. All cells give as many bytes.
  std::vector<char> pack(const Cell &cell, const bool merged) const;

  /// Gives @p cell or, when it was @p halved, its children what @p bytes
  /// hold. The field and the maps have been made fit for the new octree.
  void
  unpack(const Cell &cell, const bool halved, const char *const bytes) const;

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
