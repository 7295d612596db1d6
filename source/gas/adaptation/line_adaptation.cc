// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/line_adaptation.h>

namespace contrecoup::gas
{
namespace
{
  /// Whether a leaf may be coarsened: its sibling, the adjacent leaf, is about
  /// to get the level of the parent as well.
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


void balance_line(LeafMesh<1> &mesh)
{
  const unsigned int n = mesh.n_owned();
  std::vector<int> wanted(n);
  for (unsigned int leaf = 0; leaf < n; ++leaf)
  {
    const auto &cell = mesh.cell(leaf);
    wanted[leaf] = cell->level() + bool(cell->refine_flag_set()) -
                   bool(cell->coarsen_flag_set());
  }
  // Levels only increase in this loop, up to the largest one, so that it ends.
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
    if (mesh.coarse_mesh().is_periodic(0))
    {
      raise(0, wanted[n - 1]);
      raise(n - 1, wanted[0]);
    }
    for (unsigned int leaf = 0; leaf < n; ++leaf)
      if (wanted[leaf] < mesh.cell(leaf)->level() &&
          !sibling_follows(mesh, wanted, leaf))
        raise(leaf, mesh.cell(leaf)->level());
  }
  for (unsigned int leaf = 0; leaf < n; ++leaf)
  {
    const auto &cell = mesh.cell(leaf);
    cell->clear_refine_flag();
    cell->clear_coarsen_flag();
    if (wanted[leaf] > cell->level())
      cell->set_refine_flag();
    else if (wanted[leaf] < cell->level())
      cell->set_coarsen_flag();
  }
}
} // namespace contrecoup::gas
