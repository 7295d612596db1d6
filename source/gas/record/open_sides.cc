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
void OpenSides<dim>::mesh_changed(const GasSnapshot<dim> &gas)
{
  const LeafMesh<dim> &mesh = gas.mesh;
  communicator_ = mesh.communicator();
  for (auto &leaves : leaves_)
    leaves.clear();
  if (!mesh.coarse_mesh().is_axis_aligned())
    return;
  for (unsigned int batch = 0; batch < mesh.n_batches(); ++batch)
    for (const SpecialFace *face = mesh.special_begin(batch);
         face != mesh.special_end(batch);
         ++face)
      if (face->kind == SpecialFace::Kind::boundary &&
          gas.scene.boundary.kind(face->index) == Boundary<dim>::Kind::open)
        leaves_[face->index].push_back(batch * mesh.width() + face->lane);
}


template <int dim>
void OpenSides<dim>::add_step(const GasSnapshot<dim> &gas)
{
  if (gas.step_number % interval != 0)
    return;
  const double smallest =
    gas.scene.ambient().pressure * (1. + BlastRecord<double>::threshold);
  const LeafLayout &layout = gas.field.layout();
  const auto is_hit = [&](const unsigned int leaf) {
    const auto values = gas.field.leaf(leaf);
    std::vector<double> u(layout.n_components);
    for (unsigned int q = 0; q < layout.n_points; ++q)
    {
      for (unsigned int c = 0; c < u.size(); ++c)
        u[c] = values[c * layout.n_points + q];
      if (primitive_state<dim>(u.data(), gas.scene.material).pressure >
          smallest)
        return true;
    }
    return false;
  };
  for (unsigned int side = 0; side < 2 * dim; ++side)
    if (arrivals_[side] == never &&
        std::any_of(leaves_[side].begin(), leaves_[side].end(), is_hit))
      arrivals_[side] = gas.time;
}


template <int dim>
void OpenSides<dim>::reduce_over_ranks()
{
  for (double &time : arrivals_)
    time = dealii::Utilities::MPI::min(time, communicator_);
}


template <int dim>
void OpenSides<dim>::save(std::ostream &stream,
                          const std::string & /*folder*/) const
{
  stream.write(reinterpret_cast<const char *>(arrivals_.data()),
               sizeof(arrivals_));
}


template <int dim>
void OpenSides<dim>::load(std::istream &stream, const std::string & /*folder*/)
{
  stream.read(reinterpret_cast<char *>(arrivals_.data()), sizeof(arrivals_));
}


template class OpenSides<1>;
template class OpenSides<2>;
template class OpenSides<3>;
} // namespace contrecoup::gas
