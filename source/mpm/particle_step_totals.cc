// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/mpm/particle_motion.h>
#include <contrecoup/mpm/particle_step.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::mpm
{
double ParticleStep::largest_strain_rate(const Particles &particles,
                                         const MPI_Comm communicator) const
{
  double largest = 0.;
  particles.for_each_block([&](unsigned int, const ParticleBlock &block) {
    largest = std::max(largest, largest_rate(block));
  });
  return dealii::Utilities::MPI::max(largest, communicator);
}


void ParticleStep::throw_step_failure(const Particles &particles,
                                      const double step,
                                      const MPI_Comm communicator) const
{
  namespace mpi = dealii::Utilities::MPI;
  const double largest = largest_strain_rate(particles, communicator);
  std::string place;
  particles.for_each_block(
    [&](const unsigned int m, const ParticleBlock &block) {
      for (std::size_t p = 0; p < block.size() && place.empty(); ++p)
        for (unsigned int k = 0; k < 9; ++k)
          if (!(std::abs(block[column::mean_rate + k][p]) < largest))
          {
            place = "a particle of " + materials_[m].name + " at (" +
                    std::to_string(block[column::position][p]) + ", " +
                    std::to_string(block[column::position + 1][p]) + ", " +
                    std::to_string(block[column::position + 2][p]) +
                    ") m with density " +
                    std::to_string(materials_[m].density() /
                                   (1. + block[column::dilatation][p])) +
                    " kg/m^3";
            break;
          }
    });
  const auto all = mpi::all_gather(communicator, place);
  const auto found = std::find_if(
    all.begin(), all.end(), [](const auto &one) { return !one.empty(); });
  throw NumericsError(
    (found == all.end() ? std::string("a particle") : *found) +
    " would be strained by more than " + std::to_string(largest_strain) +
    " in a step, even in one of " + std::to_string(step) + " s");
}


ParticleTotals ParticleStep::totals(const TileGrid &grid,
                                    const Particles &particles) const
{
  std::vector<double> sums(7, 0.);
  particles.for_each_block(
    [&](const unsigned int m, const ParticleBlock &block) {
      for (std::size_t p = 0; p < block.size(); ++p)
      {
        const double mass = block[column::mass][p];
        sums[0] += mass;
        for (unsigned int d = 0; d < 3; ++d)
        {
          const double velocity = block[column::velocity + d][p];
          sums[1 + d] += mass * velocity;
          sums[4] += 0.5 * mass * velocity * velocity;
        }
        sums[5] += block[column::energy][p];
      }
      sums[6] += mpm::stored_energy(materials_[m], block);
    });
  dealii::Utilities::MPI::sum(sums, grid.communicator(), sums);
  return {sums[0], {{sums[1], sums[2], sums[3]}}, sums[4], sums[5], sums[6]};
}


double ParticleStep::signal_time(const TileGrid &grid,
                                 const Particles &particles) const
{
  double largest = 0.;
  for (const auto &tile : particles.tiles())
    for (unsigned int m = 0; m < materials_.size(); ++m)
    {
      const ParticleBlock &block = tile.second[m];
      if (block.size() == 0)
        continue;
      double fastest = 0.;
      for (std::size_t p = 0; p < block.size(); ++p)
      {
        double square = 0.;
        for (unsigned int d = 0; d < 3; ++d)
          square += std::pow(block[column::velocity + d][p], 2);
        fastest = std::max(fastest, square);
      }
      largest = std::max(largest,
                         std::sqrt(fastest) +
                           largest_sound_speed(materials_[m], block));
    }
  return std::min(
    std::numeric_limits<double>::max(),
    grid.box().cell_size /
      std::max(dealii::Utilities::MPI::max(largest, grid.communicator()),
               1e-300));
}
} // namespace contrecoup::mpm
