// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/johnson_cook.h>
#include <contrecoup/materials/solid_material.h>
#include <contrecoup/materials/tait.h>
#include <contrecoup/mpm/particle_block.h>

#include <optional>
#include <string>
#include <variant>

namespace contrecoup::mpm
{
/// Material of particles.
struct ParticleMaterial
{
  std::string name;
  std::variant<Tait, SolidMaterial> law = SolidMaterial();
  SolidKinematics kinematics = SolidKinematics::finite_rotation; ///< of solids
  /// Set for metals, which are solids that yield, with neo-Hookean kinematics.
  std::optional<JohnsonCook> plasticity;
  /// Whether volume strain and pressure are smoothed over the cells, against
  /// volumetric locking.
  bool is_smoothed = false;
  /// Materials of one group are smoothed together, so that the pressure is
  /// continuous across them.
  unsigned int smoothing_group = 0;
  double linear_viscosity = 0.;    ///< artificial, in compression [-]
  double quadratic_viscosity = 0.; ///< artificial, in compression [-]
  /// Number of the material's velocity field.
  unsigned int field = 0;

  double density() const; ///< undeformed [kg/m^3]

  const SolidMaterial *solid() const
  {
    return std::get_if<SolidMaterial>(&law);
  }
};

/**
 * Advances strains by a step with column::velocity_gradient and, if the
 * material is smoothed, with the rate of dilatation in column::smoothed; then
 * sets stresses and pressures. Changes column::gradient, dilatation, pressure,
 * stress, relaxed, plastic_strain and plastic_work.
 * @param step size of the step [s]; 0: only computes the stresses of the
 * present strains
 * @param cell_size cell size of the grid, for artificial viscosity [m]
 */
void strain_particles(const ParticleMaterial &material,
                      const double step,
                      const double cell_size,
                      ParticleBlock &particles);

/// Elastic energy of the strains [J], including that of viscoelastic branches
/// in their present state.
double stored_energy(const ParticleMaterial &material,
                     const ParticleBlock &particles);

/// Largest sound speed of the particles [m/s]; 0 without particles.
double largest_sound_speed(const ParticleMaterial &material,
                           const ParticleBlock &particles);

/// Values of one particle.
struct ParticleValues
{
  double pressure;         ///< that acts in the stress [Pa]
  double density;          ///< present [kg/m^3]
  double shear_strain;     ///< largest difference of principal strains [-]
  double principal_strain; ///< the largest [-]
};
ParticleValues particle_values(const ParticleMaterial &material,
                               const ParticleBlock &particles,
                               const std::size_t particle);
} // namespace contrecoup::mpm
