// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/ghost_exchange.h>

#include <deal.II/base/mpi.templates.h>

namespace contrecoup::gas
{
namespace
{
  constexpr int message_tag = 1701;
}


template <int dim>
void GhostExchange<dim>::reinit(const LeafMesh<dim> &mesh,
                                const LeafLayout &layout)
{
  communicator_ = mesh.communicator();
  layout_ = layout;
  owners_.clear();
  readers_.clear();
  values_of_.clear();
  if (dealii::Utilities::MPI::n_mpi_processes(communicator_) == 1)
    return;

  // Requests by owner rank: pairs of a global cell index and a mask of faces.
  // The owner sends the values in the order of the requests.
  std::map<unsigned int, std::vector<std::uint64_t>> wanted;
  std::map<unsigned int, Partner> partners;
  for (unsigned int i = 0; i < mesh.n_ghosts(); ++i)
  {
    const auto &ghost = mesh.ghosts()[i];
    wanted[ghost.owner].push_back(ghost.global_index);
    wanted[ghost.owner].push_back(ghost.faces);
    partners[ghost.owner].rank = ghost.owner;
    add(partners[ghost.owner], mesh.first_ghost() + i, ghost.faces);
  }
  for (auto &[rank, partner] : partners)
    owners_.push_back(std::move(partner));
  const auto requests =
    dealii::Utilities::MPI::some_to_some(communicator_, wanted);
  for (const auto &[rank, request] : requests)
  {
    Partner partner;
    partner.rank = rank;
    for (std::size_t i = 0; i < request.size(); i += 2)
      add(partner, mesh.leaf_of_global(request[i]), request[i + 1]);
    readers_.push_back(std::move(partner));
  }
  for (auto *partners : {&owners_, &readers_})
    for (Partner &partner : *partners)
      partner.buffer.resize(partner.n_values * sizeof(double));
}


template <int dim>
void GhostExchange<dim>::add(Partner &partner,
                             const unsigned int leaf,
                             const unsigned char faces)
{
  partner.leaves.push_back(leaf);
  partner.faces.push_back(faces);
  partner.n_values += values_of(faces).size() + 1;
}


template <int dim>
const std::vector<std::size_t> &
GhostExchange<dim>::values_of(const unsigned char faces)
{
  const auto entry = values_of_.try_emplace(faces);
  auto &values = entry.first->second;
  if (!entry.second)
    return values;
  std::vector<bool> needed(layout_.n_points, false);
  for (unsigned int face = 0; face < 2 * dim; ++face)
    if ((faces >> face) & 1U)
      for (unsigned int q = 0; q < layout_.n_face_points; ++q)
        for (unsigned int depth = 0; depth < std::min(2U, layout_.n); ++depth)
          needed[layout_.face_point(face, q, depth)] = true;
  for (unsigned int c = 0; c < layout_.n_components; ++c)
    for (unsigned int q = 0; q < layout_.n_points; ++q)
      if (needed[q])
        values.push_back(layout_.value(c, q));
  return values;
}


template <int dim>
template <typename Real>
void GhostExchange<dim>::update(Real *state, Real *leaf_values)
{
  requests_.clear();
  for (Partner &partner : owners_)
  {
    requests_.emplace_back();
    MPI_Irecv(partner.buffer.data(),
              partner.n_values * sizeof(Real),
              MPI_BYTE,
              partner.rank,
              message_tag,
              communicator_,
              &requests_.back());
  }
  for (Partner &partner : readers_)
  {
    pack(partner, state, leaf_values);
    requests_.emplace_back();
    MPI_Isend(partner.buffer.data(),
              partner.n_values * sizeof(Real),
              MPI_BYTE,
              partner.rank,
              message_tag,
              communicator_,
              &requests_.back());
  }
  MPI_Waitall(requests_.size(), requests_.data(), MPI_STATUSES_IGNORE);
  for (const Partner &partner : owners_)
    unpack(partner, state, leaf_values);
}


template <int dim>
template <typename Real>
void GhostExchange<dim>::pack(Partner &partner,
                              const Real *state,
                              const Real *values)
{
  Real *next = reinterpret_cast<Real *>(partner.buffer.data());
  for (std::size_t i = 0; i < partner.leaves.size(); ++i)
  {
    const Real *from = state + layout_.offset(partner.leaves[i]);
    for (const std::size_t position : values_of(partner.faces[i]))
      *next++ = from[position];
    *next++ = values[partner.leaves[i]];
  }
}


template <int dim>
template <typename Real>
void GhostExchange<dim>::unpack(const Partner &partner,
                                Real *state,
                                Real *values)
{
  const Real *next = reinterpret_cast<const Real *>(partner.buffer.data());
  for (std::size_t i = 0; i < partner.leaves.size(); ++i)
  {
    Real *to = state + layout_.offset(partner.leaves[i]);
    for (const std::size_t position : values_of(partner.faces[i]))
      to[position] = *next++;
    values[partner.leaves[i]] = *next++;
  }
}


template class GhostExchange<1>;
template class GhostExchange<2>;
template class GhostExchange<3>;
template void GhostExchange<1>::update(double *, double *);
template void GhostExchange<2>::update(double *, double *);
template void GhostExchange<3>::update(double *, double *);
template void GhostExchange<1>::update(float *, float *);
template void GhostExchange<2>::update(float *, float *);
template void GhostExchange<3>::update(float *, float *);
} // namespace contrecoup::gas
