// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/region.h>

#include <deal.II/base/parameter_handler.h>

namespace contrecoup::ale
{
/// Declares what a region is made of, in its subsection.
void declare_region_material(dealii::ParameterHandler &prm);

/**
 * Reads it from the subsection of the region @p name.
 * @throws InputError for constants without a physical meaning
 */
Region parse_region_material(dealii::ParameterHandler &prm,
                             const std::string &name);

/// What the matter of a region has at the start.
struct InitialMatter
{
  double density;             ///< [kg/m^3]
  double energy;              ///< internal [J/m^3]
  double sound_speed_squared; ///< [m^2/s^2], not above 0 where p is too low
};

/**
 * @param density asked for; Tait's liquid and solids have their own [kg/m^3]
 * @param pressure [Pa]; solids are free of stress
 * @param products mass fraction of explosive products [-]
 */
InitialMatter initial_matter(const Region &region,
                             const double density,
                             const double pressure,
                             const double products);
} // namespace contrecoup::ale
