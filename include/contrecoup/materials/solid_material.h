// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/gas_filled.h>
#include <contrecoup/materials/tissue_library.h>

#include <complex>
#include <string>
#include <vector>

namespace contrecoup
{
/// How strains are measured and stresses turned.
enum class SolidKinematics
{
  small_strain,    ///< linear in the displacements; no rotations
  finite_rotation, ///< Green's strain: small strains, any rotation
  neo_hookean      ///< large strains and any rotation
};

/// Their words in parameter files, in the order of the enumeration.
const std::vector<std::string> &solid_kinematics_names();

/// @throws InputError with the nearest word
SolidKinematics find_solid_kinematics(const std::string &name);

/**
 * An isotropic solid, elastic in volume and viscoelastic in shear with one
 * branch that relaxes: G(t) = G_0 - G_1 (1 - exp(-t / tau)).
 */
struct SolidMaterial
{
  double density = 1000.;          ///< [kg/m^3]
  double bulk_modulus = 1e9;       ///< K [Pa]
  double instantaneous_shear = 0.; ///< G_0 [Pa]
  double relaxing_shear = 0.;      ///< G_1 [Pa], of the branch; 0: elastic
  double relaxation_time = 1.;     ///< tau [s]
  GasFilling gas;                  ///< with some, K is that of small strains

  /// Whether it remembers its strains.
  bool is_viscoelastic() const
  {
    return relaxing_shear > 0.;
  }

  /// G(t) [Pa] at a time after a sudden strain [s].
  double relaxation_modulus(double time) const;

  /// G*(omega) [Pa] at an angular frequency [rad/s].
  std::complex<double> dynamic_shear(double angular_frequency) const;

  /// - dp/dJ over K: what stiffness of volume a dilatation leaves or makes.
  double stiffening(double dilatation) const;

  /// sqrt((K + 4/3 G_0) / rho) [m/s].
  double dilatational_speed() const;

  /// sqrt(G_0 / rho) [m/s].
  double shear_speed() const;

  /// @throws InputError, in terms of @p name, unless density and bulk modulus
  /// are positive and 0 <= G_1 <= G_0
  void check(const std::string &name) const;
};

/**
 * The solid of a tissue.
 * @param g1_is_long_term reads the number that a source calls G_1 as the
 *   modulus that is left in the end, where the library took it for the branch
 *   that relaxes
 */
SolidMaterial solid_material(const TissueProperties &tissue,
                             bool g1_is_long_term = false);
} // namespace contrecoup
