// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/ghost_exchange.h>

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
  if (dealii::Utilities::MPI::n_mpi_processes(communicator_) == 1)
    return;

  // What this rank needs, by owner; the owners answer by sending it in the
  // same order.
  std::map<unsigned int, std::vector<std::uint64_t>> wanted;
  std::map<unsigned int, Partner> partners;
  for (unsigned int i = 0; i < mesh.n_ghosts(); ++i)
  {
    const auto &ghost = mesh.ghosts()[i];
    wanted[ghost.owner].push_back(ghost.global_index);
    partners[ghost.owner].rank = ghost.owner;
    partners[ghost.owner].leaves.push_back(mesh.n_batches() * W + i);
  }
  const std::size_t leaf_size =
    std::size_t(layout.n_components) * layout.n_points + 1;
  for (auto &[rank, partner] : partners)
  {
    partner.buffer.resize(partner.leaves.size() * leaf_size);
    owners_.push_back(std::move(partner));
  }
  const auto requests =
    dealii::Utilities::MPI::some_to_some(communicator_, wanted);
  for (const auto &[rank, indices] : requests)
  {
    Partner partner;
    partner.rank = rank;
    for (const std::uint64_t index : indices)
      partner.leaves.push_back(mesh.leaf_of_global(index));
    partner.buffer.resize(partner.leaves.size() * leaf_size);
    readers_.push_back(std::move(partner));
  }
}


template <int dim>
void GhostExchange<dim>::update(double *state, double *leaf_values)
{
  requests_.clear();
  for (Partner &partner : owners_)
  {
    requests_.emplace_back();
    MPI_Irecv(partner.buffer.data(),
              partner.buffer.size(),
              MPI_DOUBLE,
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
              partner.buffer.size(),
              MPI_DOUBLE,
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
void GhostExchange<dim>::pack(Partner &partner,
                              const double *state,
                              const double *values)
{
  const unsigned int n = layout_.n_components * layout_.n_points;
  double *next = partner.buffer.data();
  for (const unsigned int leaf : partner.leaves)
  {
    const double *from = state + layout_.offset(leaf);
    for (unsigned int i = 0; i < n; ++i)
      *next++ = from[i * W];
    *next++ = values[leaf];
  }
}


template <int dim>
void GhostExchange<dim>::unpack(const Partner &partner,
                                double *state,
                                double *values)
{
  const unsigned int n = layout_.n_components * layout_.n_points;
  const double *next = partner.buffer.data();
  for (const unsigned int leaf : partner.leaves)
  {
    double *to = state + layout_.offset(leaf);
    for (unsigned int i = 0; i < n; ++i)
      to[i * W] = *next++;
    values[leaf] = *next++;
  }
}


template class GhostExchange<1>;
template class GhostExchange<2>;
template class GhostExchange<3>;
} // namespace contrecoup::gas
