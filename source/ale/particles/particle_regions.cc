// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/whole_body.h>
#include <contrecoup/ale/particles/particle_regions.h>
#include <contrecoup/materials/principal_difference.h>
#include <contrecoup/materials/solid_law.h>
#include <contrecoup/mpm/particle_lanes.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  namespace column = mpm::column;

  /// Largest plastic strain and work of metals. Sums: mass, momentum,
  /// kinetic energy, plastic work.
  struct MaterialSums
  {
    std::vector<double> largest = std::vector<double>(2, 0.);
    std::vector<double> sums = std::vector<double>(6, 0.);
  };

  void add_particle(const mpm::ParticleBlock &block,
                    const std::size_t p,
                    MaterialSums &found)
  {
    const double mass = block[column::mass][p];
    double square = 0.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double velocity = block[column::velocity + d][p];
      square += velocity * velocity;
      found.sums[1 + d] += mass * velocity;
    }
    found.sums[0] += mass;
    found.sums[4] += 0.5 * mass * square;
    const double work = block[column::plastic_work][p];
    found.largest[0] =
      std::max(found.largest[0], block[column::plastic_strain][p]);
    found.largest[1] = std::max(found.largest[1], work);
    found.sums[5] += block[column::volume][p] * work;
  }

  /// Largest shear strain of solid particles, if it is above @p least.
  double largest_shear_strain(const mpm::ParticleBlock &block,
                              const double least)
  {
    constexpr unsigned int width = n_lanes<double>;
    double square = least * least;
    for (std::size_t p = 0; p < block.size(); p += width)
    {
      const auto strain =
        green_strain<true>(mpm::load_matrix(block, column::gradient, p));
      if (!any_less(mpm::Lane(square), square_difference_bound(strain)))
        continue;
      const mpm::Lane difference = principal_difference(strain);
      // Lanes beyond the last particle are none.
      for (std::size_t lane = 0; lane < width && p + lane < block.size();
           ++lane)
        square = std::max(square, difference[lane] * difference[lane]);
    }
    return std::sqrt(square);
  }

  /// Largest speed and void volume of particles of a liquid.
  void add_liquid(const Tait &liquid,
                  const mpm::ParticleBlock &block,
                  RegionExtremes &found)
  {
    double square = 0.;
    for (std::size_t p = 0; p < block.size(); ++p)
    {
      square = std::max(
        square, mpm::vector_of(block, column::velocity, p).norm_square());
      const double density =
        liquid.density() / (1. + block[column::dilatation][p]);
      found.void_volume +=
        liquid.void_fraction(density) * block[column::mass][p] / density;
    }
    found.speed = std::max(found.speed, std::sqrt(square));
  }
} // namespace


void ParticleRegions::record(const ParticleSnapshot &now)
{
  const std::vector<mpm::ParticleMaterial> &materials = now.scene.materials();
  std::vector<RegionExtremes> extremes(materials.size());
  now.particles.for_each_block(
    [&](const unsigned int m, const mpm::ParticleBlock &block) {
      RegionExtremes &found = extremes[m];
      const double *const pressure =
        block[materials[m].is_smoothed ? column::smoothed : column::pressure];
      for (std::size_t p = 0; p < block.size(); ++p)
      {
        found.least_pressure = std::min(found.least_pressure, pressure[p]);
        found.largest_pressure = std::max(found.largest_pressure, pressure[p]);
      }
      if (const Tait *const liquid = std::get_if<Tait>(&materials[m].law))
        add_liquid(*liquid, block, found);
      else
        found.shear_strain = std::max(
          found.shear_strain, largest_shear_strain(block, found.shear_strain));
    });
  extremes_.add(std::move(extremes));
}


std::vector<NamedValue> ParticleRegions::history(const ParticleSnapshot &now)
{
  if (extremes_.is_empty())
    record(now);
  const std::vector<RegionExtremes> extremes = extremes_.take();
  const std::vector<mpm::ParticleMaterial> &materials = now.scene.materials();
  std::vector<MaterialSums> found(materials.size());
  now.particles.for_each_block(
    [&](const unsigned int m, const mpm::ParticleBlock &block) {
      for (std::size_t p = 0; p < block.size(); ++p)
        add_particle(block, p, found[m]);
    });
  std::vector<NamedValue> result;
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    auto &largest = found[m].largest;
    auto &sums = found[m].sums;
    dealii::Utilities::MPI::max(largest, now.communicator, largest);
    dealii::Utilities::MPI::sum(sums, now.communicator, sums);
    const std::string name = "_" + materials[m].name;
    result.push_back(
      {"least_pressure" + name, "Pa", extremes[m].least_pressure});
    result.push_back(
      {"largest_pressure" + name, "Pa", extremes[m].largest_pressure});
    result.push_back({"kinetic_energy" + name, "J", sums[4]});
    if (materials[m].solid() == nullptr)
    {
      result.push_back({"largest_speed" + name, "m/s", extremes[m].speed});
      result.push_back({"void_volume" + name, "m^3", extremes[m].void_volume});
      continue;
    }
    result.push_back(
      {"largest_shear_strain" + name, "-", extremes[m].shear_strain});
    for (unsigned int d = 0; d < 3; ++d)
      result.push_back({std::string("velocity_") + "xyz"[d] + name,
                        "m/s",
                        sums[d + 1] / sums[0]});
    if (const auto &metal = materials[m].plasticity)
    {
      result.push_back({"largest_plastic_strain" + name, "-", largest[0]});
      result.push_back({"plastic_work" + name, "J", sums[5]});
      result.push_back(
        {"largest_temperature" + name, "K", metal->temperature(largest[1])});
    }
  }
  return result;
}


void RegionContact::record(const ParticleSnapshot &now)
{
  if (!now.region_force)
    return;
  ContactMeasures measures;
  measures.force = *now.region_force;
  contact_.add(measures, now.time, now.step);
}


std::vector<NamedValue>
RegionContact::results(const ParticleSnapshot &now) const
{
  std::vector<NamedValue> values;
  for (const NamedValue &value : contact_.values(now.time))
    if (value.name.find("area") == std::string::npos)
      values.push_back({"region_" + value.name, value.unit, value.value});
  const MeshDescription &mesh = now.impact.mesh;
  set_to_whole(values, mesh.computed_fraction(), mesh.symmetry_planes());
  return values;
}
} // namespace contrecoup::ale
