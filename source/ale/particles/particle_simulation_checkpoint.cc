// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_simulation.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/state_file.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace contrecoup::ale
{
namespace
{
  namespace mpi = dealii::Utilities::MPI;

  /// Header of each checkpoint file: global values.
  struct CheckpointHeader
  {
    std::uint64_t n_particles; ///< on all ranks
    std::uint64_t n_materials;
    std::uint64_t n_blocks; ///< in this file
    ResampledParticles resampled;
    double cell_size;
    double time;
    double initial_energy;
    LargestEnergies largest;
    mpm::EnergyLedger ledger; ///< of the rank that wrote this file
    ContactMeasures contact;
  };

  /// Header of a block of particles.
  struct BlockHead
  {
    std::uint64_t tile;
    std::uint64_t material;
  };
} // namespace


void ParticleSimulation::save(const std::string &folder)
{
  io::save_part(folder, "mpm", communicator_, [&](io::StateWriter &out) {
    CheckpointHeader header{n_particles_,
                            scene_.materials().size(),
                            0,
                            resampled_,
                            scene_.cell_size(),
                            time_,
                            initial_energy_,
                            largest_,
                            step_->ledger(),
                            contact_now_};
    particles_.for_each_block(
      [&](unsigned int, const mpm::ParticleBlock &) { ++header.n_blocks; });
    out.put(header);
    for (const auto &[tile, blocks] : particles_.tiles())
      for (unsigned int m = 0; m < blocks.size(); ++m)
      {
        if (blocks[m].size() == 0)
          continue;
        out.put(BlockHead{tile, m});
        std::vector<double> states(mpm::column::n_state_columns *
                                   blocks[m].size());
        for (std::size_t p = 0; p < blocks[m].size(); ++p)
          blocks[m].copy_state(p, &states[mpm::column::n_state_columns * p]);
        out.put_list(states);
      }
  });
  io::save_part(folder, "records", communicator_, [&](io::StateWriter &out) {
    recorders_.for_each(
      [&](const ParticleRecorder &recorder) { recorder.save(out); });
  });
}


void ParticleSimulation::restore_part(io::StateReader &in)
{
  CheckpointHeader header;
  in.take(header);
  if (header.n_materials != scene_.materials().size() ||
      header.cell_size != scene_.cell_size())
    in.refuse();
  n_particles_ = header.n_particles;
  resampled_ = header.resampled;
  time_ = header.time;
  initial_energy_ = header.initial_energy;
  largest_ = header.largest;
  contact_now_ = header.contact;
  // Only sums over ranks count, so the first rank takes all.
  if (mpi::this_mpi_process(communicator_) == 0)
  {
    mpm::EnergyLedger ledger = step_->ledger();
    ledger.external_work += header.ledger.external_work;
    ledger.transfer_loss += header.ledger.transfer_loss;
    ledger.contact_loss += header.ledger.contact_loss;
    step_->set_ledger(ledger);
  }
  const auto &own = grid_.own_tiles();
  for (std::uint64_t i = 0; i < header.n_blocks; ++i)
  {
    BlockHead head;
    in.take(head);
    std::vector<double> states;
    in.take_list(states);
    if (head.material >= header.n_materials ||
        states.size() % mpm::column::n_state_columns != 0)
      in.refuse();
    if (std::binary_search(own.begin(), own.end(), head.tile))
      for (std::size_t p = 0; p < states.size();
           p += mpm::column::n_state_columns)
        particles_.block(head.tile, head.material).append(&states[p]);
  }
}


void ParticleSimulation::restore(const std::string &folder)
{
  build_grid();
  // Each rank reads all parts and keeps the particles in its tiles.
  io::restore_parts(
    folder, "mpm", [&](io::StateReader &in) { restore_part(in); });
  const std::uint64_t found =
    mpi::sum(static_cast<std::uint64_t>(particles_.size()), communicator_);
  if (found != n_particles_)
    throw InputError("Checkpoint " + folder +
                     " lacks particles: " + std::to_string(found) + " of " +
                     std::to_string(n_particles_) + " are there");
  particles_.sort(grid_);
  step_->resume(grid_, particles_);
  const ParticleSnapshot now = snapshot();
  recorders_.for_each(&ParticleRecorder::reinit, now);
  io::restore_parts(folder, "records", [&](io::StateReader &in) {
    recorders_.for_each(
      [&](ParticleRecorder &recorder) { recorder.restore(now, in); });
  });
}
} // namespace contrecoup::ale
