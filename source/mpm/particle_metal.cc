// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/materials/johnson_cook.h>
#include <contrecoup/mpm/particle_lanes.h>
#include <contrecoup/mpm/particle_metal.h>

namespace contrecoup::mpm
{
namespace
{
  constexpr unsigned int metal_width = n_lanes<double>;

  /// Advances the state of metals by a step. Returns the deviatoric stress
  /// [Pa].
  Symmetric3<Lane> strain_shear(const ParticleMaterial &material,
                                const Matrix3<Lane> &rate,
                                const double step,
                                ParticleBlock &particles,
                                const std::size_t p)
  {
    MetalState<Lane> state;
    state.elastic = load_some<6>(particles, column::relaxed, p);
    state.plastic_strain = load_lane(particles[column::plastic_strain] + p);
    state.plastic_work = load_lane(particles[column::plastic_work] + p);
    Matrix3<Lane> increment = rate;
    for (auto &row : increment)
      for (Lane &component : row)
        component *= step;
    const auto deviator = strain_metal(*material.plasticity,
                                       material.solid()->instantaneous_shear,
                                       increment,
                                       step,
                                       state);
    store_some(state.elastic, column::relaxed, particles, p);
    state.plastic_strain.store(particles[column::plastic_strain] + p);
    state.plastic_work.store(particles[column::plastic_work] + p);
    return deviator;
  }
} // namespace


void strain_metals(const ParticleMaterial &material,
                   const double step,
                   const double cell_size,
                   ParticleBlock &particles)
{
  const SolidMaterial &solid = *material.solid();
  const Lane speed(solid.dilatational_speed());
  for (std::size_t p = 0; p < particles.size(); p += metal_width)
  {
    const auto gradient = load_matrix(particles, column::velocity_gradient, p);
    const Lane rate = dilatation_rate(material, particles, gradient, p);
    const auto h = strain_gradient(gradient, step, particles, p);
    const Lane dilatation = strain_volume(
      material, rate, finite_dilatation(h, cofactor(h)), step, particles, p);
    const Lane ratio = Lane(1.) + dilatation;
    Lane pressure = Lane(-solid.bulk_modulus) * dilatation;
    if (step > 0.)
      pressure += viscous_pressure(
        material, Lane(solid.density) / ratio, speed, rate, cell_size);
    auto stress = strain_shear(material, gradient, step, particles, p);
    store_pressure(material, pressure, ratio, stress, particles, p);
  }
}


double metal_energy(const SolidMaterial &solid,
                    const ParticleBlock &particles,
                    const std::size_t particle)
{
  Symmetric3<double> elastic;
  for (unsigned int k = 0; k < 6; ++k)
    elastic[k] = particles[column::relaxed + k][particle];
  const double dilatation = particles[column::dilatation][particle];
  return 0.5 * solid.bulk_modulus * dilatation * dilatation +
         metal_shear_energy(solid.instantaneous_shear, elastic);
}
} // namespace contrecoup::mpm
