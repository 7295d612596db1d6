// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/adaptation.h>
#include <contrecoup/gas/adaptation/leaf_carrier.h>

namespace contrecoup::gas
{
namespace
{
  /// Whether a leaf may be merged: its sibling, the leaf beside it, is about
  /// to reach the level of their parent too.
  bool sibling_follows(const LeafMesh<1> &mesh,
                       const std::vector<int> &wanted,
                       const unsigned int leaf)
  {
    const auto &cell = mesh.cell(leaf);
    if (cell->level() == 0)
      return false;
    const bool is_first = cell->parent()->child(0) == cell;
    if (cell->parent()->child(is_first ? 1 : 0)->has_children())
      return false;
    return wanted[is_first ? leaf + 1 : leaf - 1] == wanted[leaf];
  }
} // namespace


// deal.II's own meshes in 1-D neither bound the levels of neighbours nor
// carry data over, as p4est does in 2-D and 3-D.
template <int dim>
void Adaptation<dim>::balance_line()
{
  if constexpr (dim == 1)
  {
    const unsigned int n = mesh_.n_owned();
    std::vector<int> wanted(n);
    for (unsigned int leaf = 0; leaf < n; ++leaf)
    {
      const auto &cell = mesh_.cell(leaf);
      wanted[leaf] = cell->level() + bool(cell->refine_flag_set()) -
                     bool(cell->coarsen_flag_set());
    }
    // Levels only rise here, and never beyond the finest one: this ends.
    bool changed = true;
    const auto raise = [&](const unsigned int leaf, const int level) {
      changed = changed || wanted[leaf] < level;
      wanted[leaf] = std::max(wanted[leaf], level);
    };
    while (changed)
    {
      changed = false;
      for (unsigned int leaf = 0; leaf + 1 < n; ++leaf)
      {
        raise(leaf, wanted[leaf + 1] - 1);
        raise(leaf + 1, wanted[leaf] - 1);
      }
      if (mesh_.coarse_mesh().is_periodic(0))
      {
        raise(0, wanted[n - 1]);
        raise(n - 1, wanted[0]);
      }
      for (unsigned int leaf = 0; leaf < n; ++leaf)
        if (wanted[leaf] < mesh_.cell(leaf)->level() &&
            !sibling_follows(mesh_, wanted, leaf))
          raise(leaf, mesh_.cell(leaf)->level());
    }
    for (unsigned int leaf = 0; leaf < n; ++leaf)
    {
      const auto &cell = mesh_.cell(leaf);
      cell->clear_refine_flag();
      cell->clear_coarsen_flag();
      if (wanted[leaf] > cell->level())
        cell->set_refine_flag();
      else if (wanted[leaf] < cell->level())
        cell->set_coarsen_flag();
    }
  }
}


template <int dim>
void Adaptation<dim>::carry_over_line(GasField &field, BlastMaps<dim> &maps)
{
  if constexpr (dim == 1)
  {
    struct Parcel
    {
      dealii::CellId id;
      bool is_halved;
      std::vector<char> bytes;
    };
    const LeafCarrier<dim> carrier(mesh_, points_, material_, field, maps);
    std::vector<Parcel> parcels;
    for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    {
      const auto &cell = mesh_.cell(leaf);
      if (!cell->coarsen_flag_set())
        parcels.push_back({cell->id(),
                           bool(cell->refine_flag_set()),
                           carrier.pack(cell, false)});
      else if (cell->parent()->child(0) == cell)
        parcels.push_back(
          {cell->parent()->id(), false, carrier.pack(cell->parent(), true)});
    }
    auto &triangulation = mesh_.triangulation();
    triangulation.execute_coarsening_and_refinement();
    mesh_.rebuild();
    field.reinit(field.layout(), mesh_.n_stored_batches());
    if (!maps.empty())
      maps.reinit(field.layout().n_points, mesh_.n_owned());
    for (const auto &parcel : parcels)
      carrier.unpack(triangulation.create_cell_iterator(parcel.id),
                     parcel.is_halved,
                     parcel.bytes.data());
    field.fill_padding(mesh_.n_owned());
  }
}


template class Adaptation<1>;
template class Adaptation<2>;
template class Adaptation<3>;
} // namespace contrecoup::gas
