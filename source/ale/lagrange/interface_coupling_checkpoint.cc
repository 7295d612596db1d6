// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/interface_coupling.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/binary_records.h>
#include <contrecoup/io/file/checked_file.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <unordered_map>

namespace contrecoup::ale
{
namespace
{
  struct NodeRecord
  {
    std::uint32_t node;
    std::array<double, 3> acceleration;
  };

  using io::read_binary;
  using io::write_binary;

  std::string file_of(const std::string &folder, const unsigned int rank)
  {
    return folder + "/coupling." + std::to_string(rank) + ".bin";
  }
} // namespace


void InterfaceCoupling::save(const std::string &folder) const
{
  if (!active())
    return;
  const CouplingRecord all = record();
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(space_->communicator());
  io::write_file(file_of(folder, rank), [&](std::ostream &out) {
    write_binary(out, all);
    write_binary(out, static_cast<std::uint64_t>(nodes_.size()));
    for (const Node &node : nodes_)
      write_binary(
        out,
        NodeRecord{space_->node_number(node.node),
                   {{node.before[0], node.before[1], node.before[2]}}});
  });
}


void InterfaceCoupling::restore(const std::string &folder)
{
  if (!active())
    return;
  std::unordered_map<std::uint32_t, Node *> here;
  for (Node &node : nodes_)
    here[space_->node_number(node.node)] = &node;
  std::size_t n_found = 0;
  unsigned int rank = 0;
  do
  {
    const std::string file = file_of(folder, rank);
    std::ifstream in(file, std::ios::binary);
    std::uint64_t n_nodes = 0;
    read_binary(in, record_);
    read_binary(in, n_nodes);
    for (std::uint64_t i = 0; i < n_nodes && in; ++i)
    {
      NodeRecord record{};
      read_binary(in, record);
      const auto found = here.find(record.node);
      if (!in || found == here.end())
        continue;
      for (unsigned int d = 0; d < 3; ++d)
        found->second->before[d] = record.acceleration[d];
      ++n_found;
    }
    if (!in)
      throw InputError("Checkpoint file " + file + " ends too early");
  } while (std::filesystem::exists(file_of(folder, ++rank)));
  if (n_found != nodes_.size())
    throw InputError("Checkpoint file " + file_of(folder, 0) +
                     " belongs to another scene");
  // The first rank continues the sum; on one rank, bitwise.
  if (dealii::Utilities::MPI::this_mpi_process(space_->communicator()) != 0)
    record_.work = 0.;
}
} // namespace contrecoup::ale
