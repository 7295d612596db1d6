// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/node_exchange.h>

#include <set>

namespace contrecoup::solid
{
void NodeExchange::reinit(const SolidMesh &mesh, const MPI_Comm communicator)
{
  communicator_ = communicator;
  rank_ = dealii::Utilities::MPI::this_mpi_process(communicator);
  neighbors_ = mesh.neighbors;
  std::set<std::uint32_t> shared;
  for (const auto &neighbor : neighbors_)
    shared.insert(neighbor.nodes.begin(), neighbor.nodes.end());
  shared_.assign(shared.begin(), shared.end());
}


template <typename Real>
void NodeExchange::add(Real *values,
                       const unsigned int width,
                       const unsigned int stride) const
{
  if (neighbors_.empty())
    return;
  const auto pack = [&](const std::vector<std::uint32_t> &nodes) {
    std::vector<Real> packed;
    packed.reserve(width * nodes.size());
    for (const std::size_t node : nodes)
      for (unsigned int d = 0; d < width; ++d)
        packed.push_back(values[stride * node + d]);
    return packed;
  };
  const int tag = 471;
  std::vector<std::vector<Real>> out, in;
  std::vector<MPI_Request> requests(2 * neighbors_.size());
  for (std::size_t i = 0; i < neighbors_.size(); ++i)
  {
    out.push_back(pack(neighbors_[i].nodes));
    in.emplace_back(out[i].size());
    const int n_bytes = static_cast<int>(out[i].size() * sizeof(Real));
    MPI_Irecv(in[i].data(),
              n_bytes,
              MPI_BYTE,
              neighbors_[i].rank,
              tag,
              communicator_,
              &requests[2 * i]);
    MPI_Isend(out[i].data(),
              n_bytes,
              MPI_BYTE,
              neighbors_[i].rank,
              tag,
              communicator_,
              &requests[2 * i + 1]);
  }
  MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);

  add_up(values, width, stride, pack(shared_), in);
}


template <typename Real>
void NodeExchange::add_up(Real *values,
                          const unsigned int width,
                          const unsigned int stride,
                          const std::vector<Real> &own,
                          const std::vector<std::vector<Real>> &in) const
{
  for (const std::size_t node : shared_)
    for (unsigned int d = 0; d < width; ++d)
      values[stride * node + d] = Real();
  const auto add_own = [&]() {
    for (std::size_t i = 0; i < shared_.size(); ++i)
      for (unsigned int d = 0; d < width; ++d)
        values[stride * shared_[i] + d] += own[width * i + d];
  };
  bool done = false;
  for (std::size_t k = 0; k < neighbors_.size(); ++k)
  {
    if (!done && neighbors_[k].rank > rank_)
    {
      add_own();
      done = true;
    }
    const auto &nodes = neighbors_[k].nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (unsigned int d = 0; d < width; ++d)
        values[stride * nodes[i] + d] += in[k][width * i + d];
  }
  if (!done)
    add_own();
}


template void NodeExchange::add<double>(double *,
                                        const unsigned int,
                                        const unsigned int) const;
template void
NodeExchange::add<float>(float *, const unsigned int, const unsigned int) const;
} // namespace contrecoup::solid
