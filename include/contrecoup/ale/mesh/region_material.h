// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/region.h>

#include <deal.II/base/parameter_handler.h>

namespace contrecoup::ale
{
/// Declares the material of a region, in the region's subsection.
void declare_region_material(dealii::ParameterHandler &prm);

/**
 * Reads the material from the subsection of region @p name.
 * @throws InputError for unphysical constants
 */
Region parse_region_material(dealii::ParameterHandler &prm,
                             const std::string &name);

/// Initial state of the matter of a region.
struct InitialMatter
{
  double density;             ///< [kg/m^3]
  double energy;              ///< internal [J/m^3]
  double sound_speed_squared; ///< [m^2/s^2]; not positive: pressure too low
};

/**
 * @param density ignored for Tait liquids and solids, which have their own
 * [kg/m^3]
 * @param pressure [Pa]; solids are free of stress
 * @param products mass fraction of explosive products [-]
 */
InitialMatter initial_matter(const Region &region,
                             const double density,
                             const double pressure,
                             const double products);
} // namespace contrecoup::ale
