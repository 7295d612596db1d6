// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/aligned_vector.h>

#include <cstddef>
#include <cstdint>

namespace contrecoup::mpm
{
/// Columns of a block of particles; those of several components name the first
/// one. Components of vectors and tensors follow one another.
namespace column
{
  enum Name : unsigned int
  {
    position = 0,    ///< 3 [m]
    velocity = 3,    ///< 3 [m/s]
    mass = 6,        ///< [kg]
    volume = 7,      ///< undeformed [m^3]
    gradient = 8,    ///< 9, of the displacement, by rows
    dilatation = 17, ///< J - 1 of the smoothed volume strain
    pressure = 18,   ///< of materials whose volume strain is smoothed [Pa]
    stress = 19,     ///< 6, Kirchhoff's, without this pressure [Pa]
    energy = 25,     ///< internal [J]
    relaxed = 26,    ///< 6, of viscoelastic branches; MetalState::elastic
    affine = 32,     ///< 9, velocity gradient of affine transfers [1/s]
    surface = 41,    ///< 3, undeformed way to the body's surface [m]
    area = 44,       ///< of the surface that belongs to the particle [m^2]
    probe = 45,      ///< number of a probe that follows it, from 1 on; 0: none
    level = 46,      ///< how often it was split [-]
    initial_position = 47, ///< 3, where it was at the start [m]
    plastic_strain = 50,   ///< of metals [-]
    plastic_work = 51,     ///< of metals, by undeformed volume [J/m^3]
    n_state_columns = 52,  ///< what moves with a particle and is saved
    // Within a step.
    velocity_change = 52,   ///< 3, of the velocity [m/s]
    position_change = 55,   ///< 3, of the position [m]
    velocity_gradient = 58, ///< 9, velocity gradient by rows [1/s]
    smoothed = 67,  ///< pressure, then rate of dilatation, after smoothing
    mean_rate = 68, ///< 9, gradient of the mean velocity of the step [1/s]
    force = 77,     ///< 3, from outside [N]
    moment = 80,    ///< 6, of this force about the particle [N m]
    n_columns = 86
  };
} // namespace column

/**
 * Particles of one tile and one material: a structure of arrays, in double
 * precision. Single would serve the pressures, as J - 1 and displacements'
 * gradients are kept and not J: rounded each step, state and transfers change
 * those of a head with cells of 8 mm by 80 Pa at most, its force by 1.4e-5. But
 * energy ledgers would close to 3e-7 instead of 1e-13, and twice as many lanes
 * make steps 13 % faster at most, since rows of splines are four nodes.
 */
class ParticleBlock
{
public:
  /// Padded to this many, so that lanes need no remainder.
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

  /// Appends a particle whose columns are zero. Returns its number.
  std::size_t append();

  /// Appends a copy of a particle of another block.
  void append(const ParticleBlock &other, const std::size_t particle);

  /// Appends a particle from column::n_state numbers.
  void append(const double *state);

  /// Its column::n_state numbers.
  void copy_state(const std::size_t particle, double *state) const;

  /// Puts the last particle in its place.
  void remove(const std::size_t particle);

private:
  void grow();

  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  dealii::AlignedVector<double> values_;
};
} // namespace contrecoup::mpm
