// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>

#include <cmath>

namespace contrecoup
{
/**
 * Two elastic disks of equal size that collide (Sulsky, Chen and Schreyer,
 * Comput. Methods Appl. Mech. Engrg. 118 (1994) 179). Before contact_time()
 * the motion is uniform, so that earlier contact is numerical.
 */
struct CollidingDisks
{
  double radius = 0.2;               ///< [m]
  double density = 1000.;            ///< [kg/m^3]
  double young_modulus = 1000.;      ///< [Pa]
  double poisson_ratio = 0.3;        ///< [-]
  dealii::Point<2> first{0.2, 0.2};  ///< centre [m]
  dealii::Point<2> second{0.8, 0.8}; ///< centre [m]
  dealii::Point<2> velocity_of_first{0.1,
                                     0.1}; ///< the other's is opposite [m/s]

  /// Time of contact [s]; negative if the disks miss each other.
  double contact_time() const
  {
    // |d - 2 v t| = 2 R, with d from the first to the second centre.
    const dealii::Tensor<1, 2> d = second - first, v(velocity_of_first);
    const double a = 4. * v.norm_square(), b = -4. * (d * v),
                 c = d.norm_square() - 4. * radius * radius;
    const double root = b * b - 4. * a * c;
    return root < 0. || !(a > 0.) ? -1. : (-b - std::sqrt(root)) / (2. * a);
  }

  /// Kinetic energy of both disks per thickness [J/m].
  double kinetic_energy() const
  {
    return density * dealii::numbers::PI * radius * radius *
           velocity_of_first.square();
  }
};
} // namespace contrecoup
