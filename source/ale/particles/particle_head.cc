// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_head.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::ale
{
namespace
{
  namespace column = mpm::column;
  namespace mpi = dealii::Utilities::MPI;
} // namespace


double ParticleHead::height_of(const mpm::ParticleBlock &block,
                               const std::size_t particle) const
{
  return height(mpm::vector_of(block, column::initial_position, particle));
}


template <typename Blocks, typename Work>
void ParticleHead::for_each_of_brain(Blocks &particles, const Work &work) const
{
  particles.for_each_block([&](const unsigned int m, auto &block) {
    for (std::size_t p = 0; m == brain_ && p < block.size(); ++p)
      work(block, p);
  });
}


void ParticleHead::reinit(const ParticleSnapshot &now)
{
  std::vector<double> sums(2, 0.);
  for_each_of_brain(now.particles,
                    [&](const mpm::ParticleBlock &block, const std::size_t p) {
                      sums[0] += block[column::volume][p];
                      sums[1] += block[column::volume][p] * height_of(block, p);
                    });
  mpi::sum(sums, now.communicator, sums);
  centre_ = sums[0] > 0. ? sums[1] / sums[0] : 0.;
}


void ParticleHead::take_samples(const mpm::Particles &particles)
{
  record_.samples.clear();
  for_each_of_brain(
    particles, [&](const mpm::ParticleBlock &block, const std::size_t p) {
      solid::BrainSample sample;
      sample.volume = block[column::volume][p];
      sample.peak_strain = block[column::peak_strain][p];
      sample.peak_pressure = block[column::peak_pressure][p];
      sample.lowest_pressure = block[column::lowest_pressure][p];
      record_.samples.push_back(sample);
    });
}


void ParticleHead::record(const ParticleSnapshot &now)
{
  if (!is_due())
    return;
  if (brain_ != none)
    follow_brain(now.scene.materials()[brain_], now.time, now.particles);
  solid::MeanMotion moving, head;
  now.particles.for_each_block(
    [&](const unsigned int m, const mpm::ParticleBlock &block) {
      for (std::size_t p = 0; is_of_head(m) && p < block.size(); ++p)
      {
        const auto place = mpm::vector_of(block, column::position, p),
                   velocity = mpm::vector_of(block, column::velocity, p);
        head.add(block[column::mass][p], place, velocity);
        if (m == moving_region())
          moving.add(block[column::mass][p], place, velocity);
      }
    });
  record_motion(now.time, now.communicator, moving, head);
}


void ParticleHead::follow_brain(const mpm::ParticleMaterial &brain,
                                const double time,
                                mpm::Particles &particles)
{
  take_samples(particles);
  std::vector<double> pressures, averages, heights;
  auto sample = record_.samples.begin();
  for_each_of_brain(particles,
                    [&](const mpm::ParticleBlock &block, const std::size_t p) {
                      const auto values = mpm::particle_values(brain, block, p);
                      pressures.push_back(block[column::pressure][p]);
                      averages.push_back(values.pressure);
                      heights.push_back(height_of(block, p) - centre_);
                      sample->record_strain(values.principal_strain);
                      ++sample;
                    });
  const solid::BrainSums before = record_.sums;
  record_brain(time, pressures, averages, heights, record_.samples);
  // Without smoothing there is no average to compare with.
  if (!brain.is_smoothed)
  {
    record_.sums.fluctuation_square = before.fluctuation_square;
    record_.sums.average_square = before.average_square;
  }
  sample = record_.samples.begin();
  for_each_of_brain(
    particles, [&](mpm::ParticleBlock &block, const std::size_t p) {
      block[column::peak_strain][p] = sample->peak_strain;
      block[column::peak_pressure][p] = sample->peak_pressure;
      block[column::lowest_pressure][p] = sample->lowest_pressure;
      ++sample;
    });
}
} // namespace contrecoup::ale
