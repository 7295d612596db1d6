// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_probes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace contrecoup::ale
{
namespace
{
  namespace column = mpm::column;
  namespace mpi = dealii::Utilities::MPI;
} // namespace


void ParticleProbes::begin(const ParticleSnapshot &now)
{
  const std::vector<dealii::Point<3>> &probes = now.impact.probes;
  for (unsigned int i = 0; i < probes.size(); ++i)
  {
    const auto distance = [&](const mpm::ParticleBlock &block,
                              const std::size_t p) {
      return (mpm::vector_of(block, column::position, p) - probes[i]).norm();
    };
    double nearest = std::numeric_limits<double>::max();
    now.particles.for_each_block(
      [&](unsigned int, const mpm::ParticleBlock &one) {
        for (std::size_t p = 0; p < one.size(); ++p)
          if (one[column::probe][p] == 0.)
            nearest = std::min(nearest, distance(one, p));
      });
    const double all = mpi::min(nearest, now.communicator);
    // Among equally near particles, one of the lowest rank counts.
    const unsigned int me = mpi::this_mpi_process(now.communicator);
    const bool is_near = nearest <= all * (1. + 1e-12);
    if (mpi::min(is_near ? me : ~0u, now.communicator) != me)
      continue;
    bool found = false;
    now.particles.for_each_block([&](unsigned int, mpm::ParticleBlock &one) {
      for (std::size_t p = 0; p < one.size() && !found; ++p)
        if (one[column::probe][p] == 0. &&
            distance(one, p) <= nearest * (1. + 1e-12))
        {
          one[column::probe][p] = i + 1;
          found = true;
        }
    });
  }
}


std::vector<NamedValue> ParticleProbes::values(const ParticleSnapshot &now)
{
  std::vector<double> found(2 * now.impact.probes.size(), 0.);
  for_each_probe(
    now.particles,
    [&](
      const unsigned int m, const auto &block, const auto p, const auto probe) {
      const auto value =
        mpm::particle_values(now.scene.materials()[m], block, p);
      found[2 * probe] = value.pressure;
      found[2 * probe + 1] = value.density;
    });
  mpi::sum(found, now.communicator, found);
  std::vector<NamedValue> values;
  for (std::size_t i = 0; i < now.impact.probes.size(); ++i)
  {
    const std::string name = "_" + std::to_string(i + 1);
    values.push_back({"pressure" + name, "Pa", found[2 * i]});
    values.push_back({"density" + name, "kg/m^3", found[2 * i + 1]});
  }
  return values;
}
} // namespace contrecoup::ale
