// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/record/open_sides.h>
#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/gas/state/leaf_sampling.h>

#include <istream>
#include <ostream>

namespace contrecoup::gas
{
template <int dim>
void OpenSides<dim>::reinit(const LeafMesh<dim> &mesh,
                            const Boundary<dim> &boundary)
{
  for (auto &leaves : leaves_)
    leaves.clear();
  if (!mesh.coarse_mesh().is_axis_aligned())
    return;
  for (unsigned int batch = 0; batch < mesh.n_batches(); ++batch)
    for (const SpecialFace *face = mesh.special_begin(batch);
         face != mesh.special_end(batch);
         ++face)
      if (face->kind == SpecialFace::Kind::boundary &&
          boundary.kind(face->index) == Boundary<dim>::Kind::open)
        leaves_[face->index].push_back(batch * mesh.width() + face->lane);
}


template <int dim>
void OpenSides<dim>::watch(const GasField &field,
                           const GasMaterial &material,
                           const double ambient_pressure,
                           const double time)
{
  const double smallest =
    ambient_pressure * (1. + BlastRecord<double>::threshold);
  const unsigned int n_points = field.layout().n_points;
  const auto is_hit = [&](const unsigned int leaf) {
    const auto values = field.leaf(leaf);
    std::vector<double> u(field.layout().n_components);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      for (unsigned int c = 0; c < u.size(); ++c)
        u[c] = values[c * n_points + q];
      if (primitive_state<dim>(u.data(), material).pressure > smallest)
        return true;
    }
    return false;
  };
  for (unsigned int side = 0; side < 2 * dim; ++side)
    if (arrivals_[side] == never &&
        std::any_of(leaves_[side].begin(), leaves_[side].end(), is_hit))
      arrivals_[side] = time;
}


template <int dim>
void OpenSides<dim>::share(const MPI_Comm communicator)
{
  for (double &time : arrivals_)
    time = dealii::Utilities::MPI::min(time, communicator);
}


template <int dim>
void OpenSides<dim>::save(std::ostream &stream) const
{
  stream.write(reinterpret_cast<const char *>(arrivals_.data()),
               sizeof(arrivals_));
}


template <int dim>
void OpenSides<dim>::load(std::istream &stream)
{
  stream.read(reinterpret_cast<char *>(arrivals_.data()), sizeof(arrivals_));
}


template class OpenSides<1>;
template class OpenSides<2>;
template class OpenSides<3>;
} // namespace contrecoup::gas
