// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/materials/small_matrix.h>
#include <contrecoup/mpm/particle_material.h>

/**
 * @file
 * Functions that the strain updates of liquids, solids and metals share.
 * Each works on the n particles p to p + n - 1, one in each lane.
 */

namespace contrecoup::mpm
{
using Lane = Lanes<double>;

inline Lane load_lane(const double *const values)
{
  Lane lane;
  lane.load(values);
  return lane;
}

template <unsigned int n>
std::array<Lane, n> load_some(const ParticleBlock &particles,
                              const unsigned int first,
                              const std::size_t p)
{
  std::array<Lane, n> values;
  for (unsigned int k = 0; k < n; ++k)
    values[k] = load_lane(particles[first + k] + p);
  return values;
}

template <std::size_t n>
void store_some(const std::array<Lane, n> &values,
                const unsigned int first,
                ParticleBlock &particles,
                const std::size_t p)
{
  for (unsigned int k = 0; k < n; ++k)
    values[k].store(particles[first + k] + p);
}

inline Matrix3<Lane> load_matrix(const ParticleBlock &particles,
                                 const unsigned int first,
                                 const std::size_t p)
{
  Matrix3<Lane> m;
  for (unsigned int k = 0; k < 9; ++k)
    m[k / 3][k % 3] = load_lane(particles[first + k] + p);
  return m;
}

/// Advances column::gradient by a step with the velocity gradient L (the
/// deformation gradient F changes by step * L F), and returns it.
inline Matrix3<Lane> strain_gradient(const Matrix3<Lane> &rate,
                                     const double step,
                                     ParticleBlock &particles,
                                     const std::size_t p)
{
  const auto h = load_matrix(particles, column::gradient, p);
  Matrix3<Lane> result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
    {
      result[i][j] =
        h[i][j] + Lane(step) * (rate[i][j] + rate[i][0] * h[0][j] +
                                rate[i][1] * h[1][j] + rate[i][2] * h[2][j]);
      result[i][j].store(particles[column::gradient + 3 * i + j] + p);
    }
  return result;
}

/// Artificial viscosity in compression, as a pressure [Pa].
inline Lane viscous_pressure(const ParticleMaterial &material,
                             const Lane &density,
                             const Lane &sound_speed,
                             const Lane &rate,
                             const double cell_size)
{
  const Lane inwards = select_less(rate, Lane(0.), -rate, Lane(0.));
  const Lane length(cell_size);
  return density * length * inwards *
         (material.linear_viscosity * sound_speed +
          material.quadratic_viscosity * length * inwards);
}

/// Rate of dilatation: smoothed, or the trace of the velocity gradient [1/s].
inline Lane dilatation_rate(const ParticleMaterial &material,
                            const ParticleBlock &particles,
                            const Matrix3<Lane> &rate,
                            const std::size_t p)
{
  return material.is_smoothed ? load_lane(particles[column::smoothed] + p)
                              : rate[0][0] + rate[1][1] + rate[2][2];
}

/// Advances column::dilatation and returns it: by the smoothed rate, or to the
/// dilatation @p of_strain of the deformation gradient.
inline Lane strain_volume(const ParticleMaterial &material,
                          const Lane &rate,
                          const Lane &of_strain,
                          const double step,
                          ParticleBlock &particles,
                          const std::size_t p)
{
  Lane dilatation = of_strain;
  if (material.is_smoothed)
  {
    dilatation = load_lane(particles[column::dilatation] + p);
    dilatation += (Lane(1.) + dilatation) * rate * step;
  }
  dilatation.store(particles[column::dilatation] + p);
  return dilatation;
}

/// Stores the pressure in column::pressure and the Kirchhoff stress in
/// column::stress. The stress includes the pressure unless the material is
/// smoothed.
inline void store_pressure(const ParticleMaterial &material,
                           const Lane &pressure,
                           const Lane &volume_ratio,
                           Symmetric3<Lane> &stress,
                           ParticleBlock &particles,
                           const std::size_t p)
{
  if (!material.is_smoothed)
    for (unsigned int d = 0; d < 3; ++d)
      stress[d] -= pressure * volume_ratio;
  pressure.store(particles[column::pressure] + p);
  store_some(stress, column::stress, particles, p);
}
} // namespace contrecoup::mpm
