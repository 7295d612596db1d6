// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::ale
{
namespace
{
  namespace column = mpm::column;

  /// Measures of a material. Extreme values: minus pressure, pressure, shear
  /// strain, squared speed, plastic strain, plastic work. Sums: mass,
  /// momentum, void, kinetic energy, plastic work.
  struct MaterialExtrema
  {
    std::vector<double> largest{-std::numeric_limits<double>::max(),
                                -std::numeric_limits<double>::max(),
                                0.,
                                0.,
                                0.,
                                0.};
    std::vector<double> sums = std::vector<double>(7, 0.);
  };

  void add_particle(const mpm::ParticleMaterial &material,
                    const mpm::ParticleBlock &block,
                    const std::size_t p,
                    MaterialExtrema &found)
  {
    const auto values = mpm::particle_values(material, block, p);
    found.largest[0] = std::max(found.largest[0], -values.pressure);
    found.largest[1] = std::max(found.largest[1], values.pressure);
    found.largest[2] = std::max(found.largest[2], values.shear_strain);
    const double mass = block[column::mass][p];
    double square = 0.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double velocity = block[column::velocity + d][p];
      square += velocity * velocity;
      found.sums[1 + d] += mass * velocity;
    }
    found.largest[3] = std::max(found.largest[3], square);
    found.sums[0] += mass;
    if (const Tait *const liquid = std::get_if<Tait>(&material.law))
      found.sums[4] +=
        liquid->void_fraction(values.density) * mass / values.density;
    found.sums[5] += 0.5 * mass * square;
    const double work = block[column::plastic_work][p];
    found.largest[4] =
      std::max(found.largest[4], block[column::plastic_strain][p]);
    found.largest[5] = std::max(found.largest[5], work);
    found.sums[6] += block[column::volume][p] * work;
  }
} // namespace


std::vector<NamedValue>
particle_measures(const std::vector<mpm::ParticleMaterial> &materials,
                  const mpm::Particles &particles,
                  const MPI_Comm communicator)
{
  std::vector<MaterialExtrema> extrema(materials.size());
  particles.for_each_block(
    [&](const unsigned int m, const mpm::ParticleBlock &block) {
      for (std::size_t p = 0; p < block.size(); ++p)
        add_particle(materials[m], block, p, extrema[m]);
    });
  std::vector<NamedValue> result;
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    auto &largest = extrema[m].largest;
    auto &sums = extrema[m].sums;
    dealii::Utilities::MPI::max(largest, communicator, largest);
    dealii::Utilities::MPI::sum(sums, communicator, sums);
    const std::string name = "_" + materials[m].name;
    result.push_back({"least_pressure" + name, "Pa", -largest[0]});
    result.push_back({"largest_pressure" + name, "Pa", largest[1]});
    result.push_back({"kinetic_energy" + name, "J", sums[5]});
    if (materials[m].solid() == nullptr)
    {
      result.push_back({"largest_speed" + name, "m/s", std::sqrt(largest[3])});
      result.push_back({"void_volume" + name, "m^3", sums[4]});
      continue;
    }
    result.push_back({"largest_shear_strain" + name, "-", largest[2]});
    for (unsigned int d = 0; d < 3; ++d)
      result.push_back({std::string("velocity_") + "xyz"[d] + name,
                        "m/s",
                        sums[d + 1] / sums[0]});
    if (const auto &metal = materials[m].plasticity)
    {
      result.push_back({"largest_plastic_strain" + name, "-", largest[4]});
      result.push_back({"plastic_work" + name, "J", sums[6]});
      result.push_back(
        {"largest_temperature" + name, "K", metal->temperature(largest[5])});
    }
  }
  return result;
}
} // namespace contrecoup::ale
