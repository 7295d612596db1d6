// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/interface_coupling.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/state_file.h>

namespace contrecoup::ale
{
namespace
{
  struct NodeRecord
  {
    std::uint32_t number;
    std::array<double, 3> acceleration;
  };
} // namespace


void InterfaceCoupling::save(const std::string &folder) const
{
  if (!active())
    return;
  const CouplingRecord all = record();
  io::save_part(
    folder, "coupling", space_->communicator(), [&](io::StateWriter &out) {
      out.put(all);
      out.put_records(nodes_.size(), [&](const std::size_t i) {
        const Node &node = nodes_[i];
        return NodeRecord{space_->node_number(node.node),
                          {{node.before[0], node.before[1], node.before[2]}}};
      });
    });
}


void InterfaceCoupling::restore(const std::string &folder)
{
  if (!active())
    return;
  const io::NumberIndex here =
    io::index_by_number(nodes_.size(), [&](const std::size_t i) {
      return space_->node_number(nodes_[i].node);
    });
  std::size_t n_found = 0;
  io::restore_parts(folder, "coupling", [&](io::StateReader &in) {
    in.take(record_);
    in.take_records<NodeRecord>(
      here, [&](const std::size_t i, const NodeRecord &record) {
        for (unsigned int d = 0; d < 3; ++d)
          nodes_[i].before[d] = record.acceleration[d];
        ++n_found;
      });
  });
  if (n_found != nodes_.size())
    throw InputError("Checkpoint " + folder +
                     ": its coupling belongs to another scene");
  // The first rank continues the sum; on one rank, bitwise.
  if (dealii::Utilities::MPI::this_mpi_process(space_->communicator()) != 0)
    record_.work = 0.;
}
} // namespace contrecoup::ale
