// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters.h>
#include <contrecoup/gas/state/gas_state.h>
#include <contrecoup/materials/gas_material.h>

#include <optional>
#include <string>

namespace contrecoup::gas
{
/// @name Gas states in parameter files.
/// @{

/// Declares entries "Density", "Velocity", "Pressure" and "Products" in the
/// current subsection; defaults are air at sea level.
void declare_state(ParameterHandler &prm);

/**
 * Reads what declare_state() declared. Missing velocity components are zero.
 * @param energy_density internal energy [J/m^3] from which the pressure
 * follows, in place of the entry
 * @throws InputError, naming @p where, for a state that check_state()
 * refuses or a velocity component that @p dim dimensions do not have.
 */
template <int dim>
GasState<dim> read_state(const ParameterHandler &prm,
                         const GasMaterial &material,
                         const std::string &where,
                         std::optional<double> energy_density = {});

/**
 * @throws InputError, naming @p where, when the density is not positive,
 * the pressure is not above the lowest that @p material has at this density,
 * the products are outside [0, 1], or a number is not finite.
 */
template <int dim>
void check_state(const GasState<dim> &state,
                 const GasMaterial &material,
                 const std::string &where);

/// The numbers of a declare_list() entry as a vector, missing components
/// being zero.
/// @throws InputError, naming @p where, for non-zero components beyond @p dim.
template <int dim>
dealii::Tensor<1, dim> read_vector(const ParameterHandler &prm,
                                   const std::string &name,
                                   const std::string &where);

/// As read_vector(), scaled to length one.
/// @throws InputError, naming @p where, when all components are zero.
template <int dim>
dealii::Tensor<1, dim> read_direction(const ParameterHandler &prm,
                                      const std::string &name,
                                      const std::string &where);
/// @}
} // namespace contrecoup::gas
