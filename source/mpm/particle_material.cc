// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/materials/relaxation.h>
#include <contrecoup/materials/solid_law.h>
#include <contrecoup/mpm/particle_lanes.h>
#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particle_metal.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace contrecoup::mpm
{
namespace
{
  constexpr unsigned int width = n_lanes<double>;

  void strain_fluid(const ParticleMaterial &material,
                    const Tait &law,
                    const double step,
                    const double cell_size,
                    ParticleBlock &particles,
                    const std::size_t p)
  {
    const auto velocity_gradient =
      load_matrix(particles, column::velocity_gradient, p);
    const Lane rate =
      dilatation_rate(material, particles, velocity_gradient, p);
    Lane dilatation = load_lane(particles[column::dilatation] + p);
    dilatation += (Lane(1.) + dilatation) * rate * step;
    dilatation.store(particles[column::dilatation] + p);
    const Lane ratio = Lane(1.) + dilatation;
    const Lane density = Lane(law.density()) / ratio;
    Lane pressure, square;
    law.pressure_and_sound_speed(density, Lane(0.), Lane(0.), pressure, square);
    if (step > 0.)
      pressure +=
        viscous_pressure(material, density, std::sqrt(square), rate, cell_size);
    Symmetric3<Lane> stress{};
    store_pressure(material, pressure, ratio, stress, particles, p);
  }

  SolidLaw<Lane> lane_law(const SolidMaterial &material, const double step)
  {
    SolidLaw<Lane> law;
    law.bulk = material.bulk_modulus;
    law.twice_shear = 2. * material.instantaneous_shear;
    law.twice_relaxing = 2. * material.relaxing_shear;
    law.decay_before = law.decay_after =
      std::exp(relaxation_exponent(step, material.relaxation_time));
    law.gas = material.gas;
    return law;
  }

  /// Kirchhoff stress of the shear branches.
  template <SolidKinematics kinematics>
  Symmetric3<Lane> shear_stress(const Matrix3<Lane> &h,
                                const Matrix3<Lane> &cofactors,
                                const Symmetric3<Lane> &shear)
  {
    const Matrix3<Lane> piola =
      piola_stress<kinematics>(h, cofactors, Lane(0.), shear);
    constexpr unsigned int row[] = {0, 1, 2, 0, 1, 2};
    constexpr unsigned int column[] = {0, 1, 2, 1, 2, 0};
    Symmetric3<Lane> stress;
    for (unsigned int k = 0; k < 6; ++k)
    {
      const unsigned int i = row[k], j = column[k];
      stress[k] = piola[i][j];
      if constexpr (kinematics != SolidKinematics::small_strain)
        stress[k] +=
          piola[i][0] * h[j][0] + piola[i][1] * h[j][1] + piola[i][2] * h[j][2];
    }
    return stress;
  }

  template <SolidKinematics kinematics>
  void strain_solid(const ParticleMaterial &material,
                    const SolidLaw<Lane> &law,
                    const double step,
                    const double cell_size,
                    ParticleBlock &particles,
                    const std::size_t p)
  {
    const SolidMaterial &solid = *material.solid();
    const auto velocity_gradient =
      load_matrix(particles, column::velocity_gradient, p);
    const Lane rate =
      dilatation_rate(material, particles, velocity_gradient, p);
    const auto h = strain_gradient(velocity_gradient, step, particles, p);
    const Matrix3<Lane> cofactors = cofactor(h);
    const SolidStrain<Lane> strain = solid_strain<kinematics>(h, cofactors);
    const Lane dilatation =
      strain_volume(material, rate, strain.dilatation, step, particles, p);
    Symmetric3<Lane> shear;
    for (unsigned int k = 0; k < 6; ++k)
      shear[k] = law.twice_shear * strain.shear_measure[k];
    if (solid.is_viscoelastic())
    {
      auto relaxed = load_some<6>(particles, column::relaxed, p);
      relaxed = relax(relaxed, strain.shear_measure, law.decay_after);
      store_some(relaxed, column::relaxed, particles, p);
      for (unsigned int k = 0; k < 6; ++k)
        shear[k] -= law.twice_relaxing * relaxed[k];
    }
    const Lane ratio = Lane(1.) + dilatation;
    Lane pressure = -volumetric_stress(law, dilatation);
    if (step > 0.)
      pressure += viscous_pressure(material,
                                   Lane(solid.density) / ratio,
                                   Lane(solid.dilatational_speed()),
                                   rate,
                                   cell_size);
    Symmetric3<Lane> stress = shear_stress<kinematics>(h, cofactors, shear);
    store_pressure(material, pressure, ratio, stress, particles, p);
  }

  /// Calls @p function with the kinematics as a compile-time constant.
  template <typename Function>
  auto with_kinematics(const SolidKinematics kinematics,
                       const Function &function)
  {
    using Kinematics = SolidKinematics;
    if (kinematics == Kinematics::small_strain)
      return function(
        std::integral_constant<Kinematics, Kinematics::small_strain>());
    if (kinematics == Kinematics::finite_rotation)
      return function(
        std::integral_constant<Kinematics, Kinematics::finite_rotation>());
    return function(
      std::integral_constant<Kinematics, Kinematics::neo_hookean>());
  }

  template <SolidKinematics kinematics>
  double solid_energy(const SolidMaterial &solid,
                      const ParticleBlock &particles,
                      const std::size_t p)
  {
    SolidLaw<double> law;
    law.bulk = solid.bulk_modulus;
    law.twice_shear = 2. * solid.instantaneous_shear;
    law.twice_relaxing = 2. * solid.relaxing_shear;
    law.gas = solid.gas;
    Matrix3<double> h;
    for (unsigned int k = 0; k < 9; ++k)
      h[k / 3][k % 3] = particles[column::gradient + k][p];
    auto strain = solid_strain<kinematics>(h, cofactor(h));
    strain.dilatation = particles[column::dilatation][p];
    Symmetric3<double> relaxed;
    for (unsigned int k = 0; k < 6; ++k)
      relaxed[k] = particles[column::relaxed + k][p];
    return contrecoup::stored_energy<kinematics>(law, strain, relaxed);
  }
} // namespace


double ParticleMaterial::density() const
{
  const SolidMaterial *const one = solid();
  return one != nullptr ? one->density : std::get<Tait>(law).density();
}


void strain_particles(const ParticleMaterial &material,
                      const double step,
                      const double cell_size,
                      ParticleBlock &particles)
{
  if (const Tait *const fluid = std::get_if<Tait>(&material.law))
  {
    for (std::size_t p = 0; p < particles.size(); p += width)
      strain_fluid(material, *fluid, step, cell_size, particles, p);
    return;
  }
  if (material.plasticity)
  {
    strain_metals(material, step, cell_size, particles);
    return;
  }
  const SolidMaterial &solid = *material.solid();
  const auto law = lane_law(solid, step);
  with_kinematics(material.kinematics, [&](const auto kinematics) {
    for (std::size_t p = 0; p < particles.size(); p += width)
      strain_solid<decltype(kinematics)::value>(
        material, law, step, cell_size, particles, p);
  });
}


double stored_energy(const ParticleMaterial &material,
                     const ParticleBlock &particles)
{
  double sum = 0.;
  const SolidMaterial *const solid = material.solid();
  for (std::size_t p = 0; p < particles.size(); ++p)
  {
    const double volume = particles[column::volume][p];
    if (solid == nullptr)
    {
      const Tait &law = std::get<Tait>(material.law);
      const double ratio = 1. + particles[column::dilatation][p];
      sum += volume * law.density() * law.stored_energy(law.density() / ratio);
    }
    else if (material.plasticity)
      sum += volume * metal_energy(*solid, particles, p);
    else
      sum += volume *
             with_kinematics(material.kinematics, [&](const auto kinematics) {
               return solid_energy<decltype(kinematics)::value>(
                 *solid, particles, p);
             });
  }
  return sum;
}


double largest_sound_speed(const ParticleMaterial &material,
                           const ParticleBlock &particles)
{
  if (particles.size() == 0)
    return 0.;
  const SolidMaterial *const solid = material.solid();
  double largest = solid != nullptr ? solid->dilatational_speed() : 0.;
  const double *const dilatation = particles[column::dilatation];
  for (std::size_t p = 0; p < particles.size() && solid == nullptr; ++p)
  {
    const Tait &law = std::get<Tait>(material.law);
    double pressure, square;
    law.pressure_and_sound_speed(
      law.density() / (1. + dilatation[p]), 0., 0., pressure, square);
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}


ParticleValues particle_values(const ParticleMaterial &material,
                               const ParticleBlock &particles,
                               const std::size_t particle)
{
  ParticleValues result;
  result.density =
    material.density() / (1. + particles[column::dilatation][particle]);
  // For smoothed materials, the pressure that acts in the stress.
  result.pressure =
    particles[material.is_smoothed ? column::smoothed : column::pressure]
             [particle];
  result.shear_strain = result.principal_strain = 0.;
  if (material.solid() == nullptr)
    return result;
  Matrix3<double> h;
  for (unsigned int k = 0; k < 9; ++k)
    h[k / 3][k % 3] = particles[column::gradient + k][particle];
  const auto strain = green_strain<true>(h);
  dealii::SymmetricTensor<2, 3> green;
  for (unsigned int k = 0; k < 6; ++k)
    green[k % 3][k < 3 ? k : (k + 1) % 3] = strain[k];
  const auto principal = dealii::eigenvalues(green);
  result.shear_strain = principal[0] - principal[2];
  result.principal_strain = principal[0];
  return result;
}
} // namespace contrecoup::mpm
