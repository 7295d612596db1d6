// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/explosive/charge.h>
#include <contrecoup/materials/gas_material.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/// A charge of a parameter file, before meshing.
template <int dim>
struct NamedCharge
{
  std::string where; ///< its subsection
  double mass;       ///< as given [kg], 0 if only sizes are
  Charge<dim> charge;
};

/// Charges of subsection "Charges"; none without an explosive.
/// @throws InputError as Charge does
template <int dim>
std::vector<NamedCharge<dim>> read_charges(ParameterHandler &prm,
                                           const GasMaterial &material,
                                           const CoarseMesh<dim> &mesh);

/// A charge, or a ball or point source of the initial state.
template <int dim>
struct Burst
{
  std::string where;         ///< its subsection
  dealii::Point<dim> center; ///< [m]
  double size;               ///< smallest diameter [m]
  double mass;               ///< of a charge, as a whole; others 0 [kg]
  bool is_explosion;         ///< charge, burned explosive, or point source
  /// Sides of the domain that are planes of symmetry next to it, which compute
  /// its mirror image as well.
  std::vector<unsigned int> mirrors;
};

/// All bursts of a scene in a box domain, none in others.
/// @param prm with all entries
template <int dim>
std::vector<Burst<dim>> read_bursts(ParameterHandler &prm,
                                    const GasMaterial &material,
                                    const CoarseMesh<dim> &mesh);

/// Whether the gas has several explosions, images included, so that no
/// reference for a single one describes it.
template <int dim>
bool has_several_explosions(const std::vector<Burst<dim>> &bursts);

/// Remarks for the log on bursts next to planes of symmetry, and on a reference
/// of Kingery and Bulmash for another mass or place than those of the charge,
/// or for one of several.
template <int dim>
std::vector<std::string> remarks_on_bursts(ParameterHandler &prm,
                                           const GasMaterial &material,
                                           const CoarseMesh<dim> &mesh);
} // namespace contrecoup::gas
