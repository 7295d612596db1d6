// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/johnson_cook.h>
#include <contrecoup/materials/mie_grueneisen.h>
#include <contrecoup/materials/solid_material.h>
#include <contrecoup/materials/tait.h>
#include <contrecoup/numerics/element/hex8_fluid.h>

#include <optional>
#include <string>
#include <variant>

namespace contrecoup::ale
{
/// Material of a region: equation of state of a fluid, or a solid.
using RegionLaw = std::variant<IdealGas, MieGrueneisen, Tait, SolidMaterial>;

/// A region of the mesh with one material.
struct Region
{
  std::string name;
  std::string layer; ///< of the mesh, as the entry has it
  RegionLaw law = IdealGas();
  FluidViscosity viscosity;
  /// Kinematics of solids, and hourglass stiffness relative to the value that
  /// gives a cube the energy of its shear [-].
  SolidKinematics kinematics = SolidKinematics::finite_rotation;
  /// Plasticity of metals, solids that yield: particles only.
  std::optional<JohnsonCook> plasticity;
  /// Whether the region slides along others; fluids only.
  bool slides = false;

  /// The solid material; null for fluids.
  const SolidMaterial *solid() const
  {
    return std::get_if<SolidMaterial>(&law);
  }

  /// Whether cells store relaxed strains.
  bool is_viscoelastic() const
  {
    return solid() != nullptr && solid()->is_viscoelastic();
  }
};
} // namespace contrecoup::ale
