// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/run/ale_simulation.h>
#include <contrecoup/io/file/state_file.h>

#include <algorithm>

namespace contrecoup::ale
{
namespace
{
  /// Header of each checkpoint file: global values.
  struct CheckpointHeader
  {
    std::uint64_t n_global_nodes;
    std::uint64_t n_global_cells;
    std::uint64_t n_rezones;
    std::uint64_t n_skipped_rezones;
    double time;
    KnownEnergies energies;
    double external_work;
    double slip_work;
    double last_step;
    std::uint64_t first_iterations;
    ContactMeasures contact;
  };

  struct NodeRecord
  {
    std::uint32_t number;
    std::array<double, 2 * node_width> values;
    std::array<double, 3> reference;
    std::array<double, 6> smoothing;
  };

  struct CellRecord
  {
    std::uint32_t number;
    /// Mass, energy, products, and relaxed strain.
    std::array<double, 9> values;
  };
} // namespace


void AleSimulation::save(const std::string &folder)
{
  const double work = lagrange_.external_work();
  const double slip_work = lagrange_.slip_work();
  const SmoothingMemory memory = rezone_.memory();
  io::save_part(folder, "ale", communicator_, [&](io::StateWriter &out) {
    out.put(CheckpointHeader{space_.n_global_nodes(),
                             space_.n_global_cells(),
                             rezone_.n_rezones(),
                             rezone_.n_skipped(),
                             state_.time,
                             energies_,
                             work,
                             slip_work,
                             last_step_,
                             memory.first_iterations,
                             contact_.value_or(ContactMeasures())});
    out.put_records(space_.n_locally_owned_nodes(), [&](const std::size_t n) {
      NodeRecord record{space_.node_number(n), {}, {}, {}};
      for (unsigned int d = 0; d < node_width; ++d)
      {
        record.values[d] = state_.position[node_width * n + d];
        record.values[node_width + d] = state_.velocity[node_width * n + d];
      }
      for (unsigned int d = 0; d < 3; ++d)
      {
        record.reference[d] = rezone_.reference()[node_width * n + d];
        record.smoothing[d] = memory.displacement[node_width * n + d];
        record.smoothing[3 + d] = memory.hierarchy_position[node_width * n + d];
      }
      return record;
    });
    out.put_records(space_.n_locally_owned_cells(), [&](const std::size_t c) {
      CellRecord record{
        space_.cell_number(c),
        {{state_.mass[c], state_.energy[c], state_.products[c]}}};
      for (std::size_t k = 0; k < 6 && !state_.relaxed.empty(); ++k)
        record.values[3 + k] = state_.relaxed[k * space_.n_cells() + c];
      return record;
    });
  });
  lagrange_.coupling().save(folder);
  io::save_part(folder, "records", communicator_, [&](io::StateWriter &out) {
    recorders_.for_each(
      [&](const AleRecorder &recorder) { recorder.save(out); });
  });
}


void AleSimulation::restore_matter(const std::string &folder)
{
  const io::NumberIndex nodes =
                          io::index_by_number(space_.n_nodes(),
                                              [&](const std::size_t n) {
                                                return space_.node_number(n);
                                              }),
                        cells = io::index_by_number(
                          space_.n_cells(), [&](const std::size_t c) {
                            return space_.cell_number(c);
                          });
  CheckpointHeader header{};
  SmoothingMemory memory(space_);
  io::restore_parts(folder, "ale", [&](io::StateReader &in) {
    in.take(header);
    if (header.n_global_nodes != space_.n_global_nodes() ||
        header.n_global_cells != space_.n_global_cells())
      in.refuse();
    in.take_records<NodeRecord>(
      nodes, [&](const std::size_t n, const NodeRecord &record) {
        for (unsigned int d = 0; d < node_width; ++d)
        {
          state_.position[node_width * n + d] = record.values[d];
          state_.velocity[node_width * n + d] = record.values[node_width + d];
        }
        for (unsigned int d = 0; d < 3; ++d)
        {
          rezone_.reference()[node_width * n + d] = record.reference[d];
          memory.displacement[node_width * n + d] = record.smoothing[d];
          memory.hierarchy_position[node_width * n + d] =
            record.smoothing[3 + d];
        }
      });
    in.take_records<CellRecord>(
      cells, [&](const std::size_t c, const CellRecord &record) {
        state_.mass[c] = record.values[0];
        state_.energy[c] = record.values[1];
        state_.products[c] = record.values[2];
        for (std::size_t k = 0; k < 6 && !state_.relaxed.empty(); ++k)
          state_.relaxed[k * space_.n_cells() + c] = record.values[3 + k];
      });
  });
  state_.time = header.time;
  energies_ = header.energies;
  lagrange_.set_external_work(header.external_work);
  lagrange_.set_slip_work(header.slip_work);
  lagrange_.set_contact(header.contact);
  if (contact_)
    contact_ = header.contact;
  last_step_ = header.last_step;
  memory.first_iterations = static_cast<unsigned int>(header.first_iterations);
  const auto done = static_cast<unsigned int>(header.n_rezones),
             n_skipped = static_cast<unsigned int>(header.n_skipped_rezones);
  rezone_.resume(state_, done, n_skipped, memory);
  lagrange_.coupling().restore(folder);
}


void AleSimulation::restore(const std::string &folder)
{
  build();
  restore_matter(folder);
  const AleSnapshot now = snapshot();
  io::restore_parts(folder, "records", [&](io::StateReader &in) {
    recorders_.for_each(
      [&](AleRecorder &recorder) { recorder.restore(now, in); });
  });
}
} // namespace contrecoup::ale
