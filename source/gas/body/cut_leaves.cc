// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/cut_leaves.h>

namespace contrecoup::gas
{
template <int dim>
void CutLeaves<dim>::reinit(const LeafMesh<dim> &mesh,
                            const LeafLayout &layout,
                            const RigidBody &body)
{
  shapes_.measure(mesh, layout, body);
  matching_.reinit();
  neighborhoods_.reinit();
  classify_batches();
}


template <int dim>
bool CutLeaves<dim>::reads_cut(const unsigned int leaf) const
{
  if (!matching_.is_at_surface(leaf))
    return false;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    for (unsigned int line = 0; line < shapes_.layout().n_face_points; ++line)
      if (inner_opening_beyond(leaf, face, line) == 0.)
        return true;
  return false;
}


template <int dim>
void CutLeaves<dim>::classify_batches()
{
  const LeafMesh<dim> &mesh = shapes_.mesh();
  batch_kind_.assign(mesh.n_batches(), BatchKind::open);
  for (unsigned int batch = 0; batch < mesh.n_batches(); ++batch)
  {
    unsigned int n_closed = 0;
    bool is_cut = false;
    for (unsigned int lane = 0; lane < mesh.n_filled_lanes(batch); ++lane)
    {
      const unsigned int leaf = batch * mesh.width() + lane;
      if (fractions().is_closed(leaf))
        ++n_closed;
      else
        is_cut = is_cut || shape(leaf) != nullptr || reads_cut(leaf) ||
                 neighborhoods_.has_members(leaf);
    }
    if (n_closed == mesh.n_filled_lanes(batch))
      batch_kind_[batch] = BatchKind::closed;
    else if (is_cut || n_closed > 0)
      batch_kind_[batch] = BatchKind::cut;
  }
}


template class CutLeaves<2>;
template class CutLeaves<3>;
} // namespace contrecoup::gas
