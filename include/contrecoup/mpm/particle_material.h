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
/// What particles are made of.
struct ParticleMaterial
{
  std::string name;
  std::variant<Tait, SolidMaterial> law = SolidMaterial();
  SolidKinematics kinematics = SolidKinematics::finite_rotation; ///< of solids
  /// Of metals, solids that yield; their kinematics are neo-Hookean.
  std::optional<JohnsonCook> plasticity;
  /// Whether volume strain and pressure are smoothed against locking.
  bool is_smoothed = false;
  /// Materials of one group are smoothed together: their pressure is
  /// continuous.
  unsigned int smoothing_group = 0;
  double linear_viscosity = 0.;    ///< artificial, in compression [-]
  double quadratic_viscosity = 0.; ///< artificial, in compression [-]
  /// Number of the velocity field that the material moves with.
  unsigned int field = 0;

  double density() const; ///< undeformed [kg/m^3]

  const SolidMaterial *solid() const
  {
    return std::get_if<SolidMaterial>(&law);
  }
};

/**
 * Strains the particles over a step with column::rate, or where the material
 * is smoothed with the rate of dilatation in column::smoothed, and sets
 * stresses and pressures: column::gradient, dilatation, pressure, stress,
 * relaxed, plastic_strain, plastic_work.
 * @param step [s]; 0: stresses of the present strains
 * @param cell_size of the grid, for artificial viscosity [m]
 */
void strain_particles(const ParticleMaterial &material,
                      const double step,
                      const double cell_size,
                      ParticleBlock &particles);

/// Energy that the strains store [J]; of viscoelastic branches, as they are.
double stored_energy(const ParticleMaterial &material,
                     const ParticleBlock &particles);

/// The fastest sound in the particles [m/s]; 0 without any.
double largest_sound_speed(const ParticleMaterial &material,
                           const ParticleBlock &particles);

/// Pressure [Pa], present density [kg/m^3] and the largest principal
/// difference of strains, the shear strain [-], of one particle.
struct ParticleValues
{
  double pressure, density, shear_strain;
};
ParticleValues particle_values(const ParticleMaterial &material,
                               const ParticleBlock &particles,
                               const std::size_t particle);
} // namespace contrecoup::mpm
