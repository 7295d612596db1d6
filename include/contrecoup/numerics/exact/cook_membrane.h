// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/**
 * Cook's membrane, nearly incompressible and in plane strain: a tapered panel
 * with corners (0, 0), (48, 44), (48, 60) and (0, 44), clamped at the left and
 * loaded upwards at the right by a traction per undeformed area.
 */
struct CookMembrane
{
  double width = 48.;           ///< [m]
  double left_height = 44.;     ///< [m]
  double right_height = 16.;    ///< [m]
  double young_modulus = 70.;   ///< [Pa]
  double poisson_ratio = 0.499; ///< [-]
  double traction = 1. / 16.;   ///< [Pa]

  /// Vertical displacements of the upper right corner and of the middle of the
  /// right edge, accurate to 1e-5 [m].
  static constexpr double tip_displacement = 0.27647,
                          middle_displacement = 0.26391;

  double shear() const
  {
    return young_modulus / (2. * (1. + poisson_ratio));
  }

  double bulk() const
  {
    return young_modulus / (3. * (1. - 2. * poisson_ratio));
  }
};
} // namespace contrecoup
