// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/names.h>
#include <contrecoup/materials/gas_filled.h>
#include <contrecoup/materials/tissue_library.h>

#include <array>
#include <string>
#include <vector>

namespace contrecoup
{
/// Kinematics of solids: strain measure and rotation of stresses.
enum class SolidKinematics
{
  small_strain,
  finite_rotation, ///< Green-Lagrange strain
  neo_hookean
};

/// All kinematics of solids, for entry and help text.
inline constexpr std::array<NamedChoice<SolidKinematics>, 3> solid_kinematics{
  {{SolidKinematics::small_strain,
    "small strain",
    "is linear: a rotation by an angle a counts as a strain of a^2 / 2"},
   {SolidKinematics::finite_rotation,
    "finite rotation",
    "is exact for any rotation with small strains"},
   {SolidKinematics::neo_hookean,
    "neo-hookean",
    "takes large strains as well"}}};

/// A tension that no matter reaches [Pa].
inline constexpr double no_cavitation = 1e30;

/// An isotropic solid: elastic in volume, viscoelastic in shear with one Prony
/// branch, G(t) = G_0 - G_1 (1 - exp(-t / tau)).
struct SolidMaterial
{
  double density = 1000.;          ///< [kg/m^3]
  double bulk_modulus = 1e9;       ///< K [Pa]
  double instantaneous_shear = 0.; ///< G_0 [Pa]
  double relaxing_shear = 0.;      ///< G_1 [Pa]; 0: elastic
  double relaxation_time = 1.;     ///< tau [s]; 0: relaxes at once
  GasFilling gas; ///< if any, K is the modulus at small strains
  /// Tension at which cavities open [Pa]: -p is that at any larger volume.
  double largest_tension = no_cavitation;

  /// Whether elements store relaxed strains.
  bool is_viscoelastic() const
  {
    return relaxing_shear > 0.;
  }

  /// Whether the tension that the matter bears is bounded.
  bool cavitates() const
  {
    return largest_tension < no_cavitation;
  }

  /// The dilatation at which cavities open; no_cavitation for never.
  double vapour_dilatation() const;

  /// G(t) [Pa] at a time after a step in strain [s].
  double relaxation_modulus(double time) const;

  /// -dp/dJ over K at a dilatation: stiffening or softening in volume.
  double stiffening(double dilatation) const;

  /// P-wave speed sqrt((K + 4/3 G_0) / rho) [m/s].
  double dilatational_speed() const;

  /// Shear wave speed sqrt(G_0 / rho) [m/s].
  double shear_speed() const;

  /// @throws InputError, naming @p name, unless density and bulk modulus are
  /// positive and 0 <= G_1 <= G_0
  void check(const std::string &name) const;
};

/**
 * The solid material of a tissue.
 * @param g1_is_long_term takes the modulus G_1 of the source as the long-term
 * modulus instead of the relaxing part
 */
SolidMaterial solid_material(const TissueProperties &tissue,
                             bool g1_is_long_term = false);
} // namespace contrecoup
