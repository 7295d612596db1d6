// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/aligned_vector.h>

#include <cstddef>
#include <cstdint>

namespace contrecoup::mpm
{
/// Columns of a block of particles. The name of a vector or tensor is that of
/// its first component; its components are consecutive.
namespace column
{
  enum Name : unsigned int
  {
    position = 0,    ///< 3 [m]
    velocity = 3,    ///< 3 [m/s]
    mass = 6,        ///< [kg]
    volume = 7,      ///< undeformed [m^3]
    gradient = 8,    ///< 9, displacement gradient by rows [-]
    dilatation = 17, ///< J - 1, smoothed where the material is [-]
    pressure = 18,   ///< of materials with smoothed volume strain [Pa]
    stress = 19,     ///< 6, Kirchhoff stress without this pressure [Pa]
    energy = 25,     ///< internal [J]
    relaxed = 26, ///< 6, strain of viscoelastic branches; MetalState::elastic
    affine = 32,  ///< 9, velocity gradient of the affine transfer [1/s]
    surface = 41, ///< 3, undeformed vector to the surface of the body [m]
    area = 44,    ///< surface area that belongs to the particle [m^2]
    probe = 45,   ///< number of the particle's probe, from 1; 0: none
    level = 46,   ///< number of times that the particle was split [-]
    initial_position = 47, ///< 3 [m]
    plastic_strain = 50,   ///< of metals [-]
    plastic_work = 51,     ///< of metals, per undeformed volume [J/m^3]
    peak_strain = 52,      ///< largest principal strain so far, of a brain [-]
    peak_pressure = 53,    ///< largest pressure so far, of a brain [Pa]
    lowest_pressure = 54,  ///< least pressure so far, of a brain [Pa]
    n_state_columns = 55,  ///< columns that are saved and move with a particle
    // Work values within a step.
    velocity_change = 55,   ///< 3, in this step [m/s]
    position_change = 58,   ///< 3, in this step [m]
    velocity_gradient = 61, ///< 9, velocity gradient by rows [1/s]
    smoothed = 70,  ///< smoothed pressure, then smoothed rate of dilatation
    mean_rate = 71, ///< 9, gradient of the mean velocity during the step [1/s]
    force = 80,     ///< 3, external force [N]
    moment = 83,    ///< 6, moment of this force about the particle [N m]
    n_columns = 89
  };
} // namespace column

/**
 * Particles of one tile and one material as a structure of arrays, in double
 * precision. Single precision would suffice for pressures, because J - 1 and
 * displacement gradients are stored instead of J and F: if state and transfers
 * are rounded to single precision in each step, the pressures in a head with
 * cells of 8 mm change by at most 80 Pa and its contact force by 1.4e-5. But
 * energy ledgers would close to 3e-7 instead of 1e-13, and twice as many lanes
 * make steps at most 13 % faster, because a row of splines has four nodes.
 */
class ParticleBlock
{
public:
  /// Blocks are padded to a multiple of this number, so that loops over lanes
  /// have no remainder.
  static constexpr std::size_t padding = 8;

  std::size_t size() const
  {
    return size_;
  }

  double *operator[](const unsigned int column)
  {
    return values_.data() + column * capacity_;
  }
  const double *operator[](const unsigned int column) const
  {
    return values_.data() + column * capacity_;
  }

  /// Appends a particle with all columns zero, and returns its index.
  std::size_t append();

  /// Appends a copy of a particle of another block.
  void append(const ParticleBlock &other, const std::size_t particle);

  /// Appends a particle with the given column::n_state_columns values.
  void append(const double *state);

  /// Copies the column::n_state_columns values of a particle.
  void copy_state(const std::size_t particle, double *state) const;

  /// Removes a particle; the last particle takes its index.
  void remove(const std::size_t particle);

private:
  void grow();

  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  dealii::AlignedVector<double> values_;
};

/// The vector of a particle in three columns from @p first on.
inline dealii::Tensor<1, 3> vector_of(const ParticleBlock &block,
                                      const unsigned int first,
                                      const std::size_t particle)
{
  return dealii::Tensor<1, 3>({block[first][particle],
                               block[first + 1][particle],
                               block[first + 2][particle]});
}
} // namespace contrecoup::mpm
