// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/run/ale_simulation.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/binary_records.h>
#include <contrecoup/io/file/checked_file.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <sstream>
#include <unordered_map>

namespace contrecoup::ale
{
namespace
{
  /// Header of each checkpoint file: global values.
  struct CheckpointHeader
  {
    std::uint64_t n_nodes;
    std::uint64_t n_cells;
    std::uint64_t n_global_nodes;
    std::uint64_t n_global_cells;
    std::uint64_t n_rezones;
    std::uint64_t n_skipped_rezones;
    double time;
    double initial_energy;
    double external_work;
    double slip_work;
    double energy_scale;
    double last_step;
    std::uint64_t n_peaks;
    std::uint64_t first_iterations;
    ContactMeasures contact;
    ContactRecord record;
    double initial_kinetic_energy;
  };

  struct NodeRecord
  {
    std::uint32_t node;
    std::array<double, 2 * node_width> values;
    std::array<double, 3> reference;
    std::array<double, 6> smoothing;
  };

  struct CellRecord
  {
    std::uint32_t cell;
    /// Mass, energy, products, and relaxed strain.
    std::array<double, 9> values;
  };

  using io::read_binary;
  using io::write_binary;

  std::string file_of(const std::string &folder, const unsigned int rank)
  {
    return folder + "/ale." + std::to_string(rank) + ".bin";
  }
} // namespace


void AleSimulation::save(const std::string &folder)
{
  const double work = lagrange_.external_work();
  const double slip_work = lagrange_.slip_work();
  const ContactMeasures contact = lagrange_.contact();
  const SmoothingMemory memory = rezone_.memory();
  const auto rank = dealii::Utilities::MPI::this_mpi_process(communicator_);
  io::write_file(file_of(folder, rank), [&](std::ostream &out) {
    write_binary(out,
                 CheckpointHeader{space_.n_locally_owned_nodes(),
                                  space_.n_locally_owned_cells(),
                                  n_nodes_,
                                  n_cells_,
                                  rezone_.n_rezones(),
                                  rezone_.n_skipped(),
                                  state_.time,
                                  initial_energy_,
                                  work,
                                  slip_work,
                                  energy_scale_,
                                  last_step_,
                                  reference_.peaks().size(),
                                  memory.first_iterations,
                                  contact,
                                  contact_,
                                  initial_kinetic_energy_});
    extremes_.save(out);
    for (const auto &peak : reference_.peaks())
      write_binary(out, peak);
    for (std::size_t n = 0; n < space_.n_locally_owned_nodes(); ++n)
    {
      NodeRecord record{space_.node_number(n), {}, {}, {}};
      for (unsigned int d = 0; d < node_width; ++d)
      {
        record.values[d] = state_.position[node_width * n + d];
        record.values[node_width + d] = state_.velocity[node_width * n + d];
      }
      for (unsigned int d = 0; d < 3; ++d)
        record.reference[d] = rezone_.reference()[node_width * n + d];
      for (unsigned int d = 0; d < 3; ++d)
      {
        record.smoothing[d] = memory.displacement[node_width * n + d];
        record.smoothing[3 + d] = memory.hierarchy_position[node_width * n + d];
      }
      write_binary(out, record);
    }
    for (std::size_t c = 0; c < space_.n_locally_owned_cells(); ++c)
    {
      CellRecord record{
        space_.cell_number(c),
        {{state_.mass[c], state_.energy[c], state_.products[c]}}};
      for (std::size_t k = 0; k < 6 && !state_.relaxed.empty(); ++k)
        record.values[3 + k] = state_.relaxed[k * space_.n_cells() + c];
      write_binary(out, record);
    }
  });
  lagrange_.coupling().save(folder);
  head_.save(folder, communicator_);
}


void AleSimulation::restore_peaks(std::istream &in,
                                  const std::string &file,
                                  const std::size_t n_peaks)
{
  extremes_.restore(in, file);
  auto &peaks = reference_.peaks();
  peaks.resize(n_peaks, {{0., 0.}});
  for (std::size_t i = 0; i < n_peaks; ++i)
  {
    std::array<double, 2> peak{};
    read_binary(in, peak);
    // Only the rank that recorded the probe has nonzero peaks.
    for (unsigned int k = 0; k < 2; ++k)
      peaks[i][k] = std::max(peaks[i][k], peak[k]);
  }
}


void AleSimulation::restore_cells(
  std::istream &in,
  const std::uint64_t n,
  const std::unordered_map<std::uint32_t, std::size_t> &cells)
{
  for (std::uint64_t i = 0; i < n; ++i)
  {
    CellRecord record;
    read_binary(in, record);
    const auto found = cells.find(record.cell);
    if (found == cells.end())
      continue;
    state_.mass[found->second] = record.values[0];
    state_.energy[found->second] = record.values[1];
    state_.products[found->second] = record.values[2];
    for (std::size_t k = 0; k < 6 && !state_.relaxed.empty(); ++k)
      state_.relaxed[k * space_.n_cells() + found->second] =
        record.values[3 + k];
  }
}


void AleSimulation::restore(const std::string &folder)
{
  build();
  std::unordered_map<std::uint32_t, std::size_t> nodes, cells;
  for (std::size_t n = 0; n < space_.n_nodes(); ++n)
    nodes[space_.node_number(n)] = n;
  for (std::size_t c = 0; c < space_.n_cells(); ++c)
    cells[space_.cell_number(c)] = c;
  CheckpointHeader header{};
  SmoothingMemory memory(space_);
  std::string file;
  for (unsigned int rank = 0;
       std::filesystem::exists(file = file_of(folder, rank));
       ++rank)
  {
    std::istringstream in(io::read_file(file));
    read_binary(in, header);
    if (!in || header.n_global_nodes != n_nodes_ ||
        header.n_global_cells != n_cells_)
      throw InputError("Checkpoint file " + file + " belongs to another mesh");
    restore_peaks(in, file, header.n_peaks);
    for (std::uint64_t i = 0; i < header.n_nodes; ++i)
    {
      NodeRecord record;
      read_binary(in, record);
      const auto found = nodes.find(record.node);
      if (found == nodes.end())
        continue;
      const std::size_t n = found->second;
      for (unsigned int d = 0; d < node_width; ++d)
      {
        state_.position[node_width * n + d] = record.values[d];
        state_.velocity[node_width * n + d] = record.values[node_width + d];
      }
      for (unsigned int d = 0; d < 3; ++d)
      {
        rezone_.reference()[node_width * n + d] = record.reference[d];
        memory.displacement[node_width * n + d] = record.smoothing[d];
        memory.hierarchy_position[node_width * n + d] = record.smoothing[3 + d];
      }
    }
    restore_cells(in, header.n_cells, cells);
    if (!in)
      throw InputError("Checkpoint file " + file + " ends too early");
  }
  state_.time = header.time;
  initial_energy_ = header.initial_energy;
  lagrange_.set_external_work(header.external_work);
  lagrange_.set_slip_work(header.slip_work);
  lagrange_.set_contact(header.contact);
  contact_ = header.record;
  initial_kinetic_energy_ = header.initial_kinetic_energy;
  energy_scale_ = header.energy_scale;
  last_step_ = header.last_step;
  memory.first_iterations = static_cast<unsigned int>(header.first_iterations);
  const auto done = static_cast<unsigned int>(header.n_rezones),
             n_skipped = static_cast<unsigned int>(header.n_skipped_rezones);
  rezone_.resume(state_, done, n_skipped, memory);
  lagrange_.coupling().restore(folder);
  head_.restore(folder, communicator_);
}
} // namespace contrecoup::ale
