// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/gas/state/gas_state.h>
#include <contrecoup/materials/gas_material.h>

#include <optional>
#include <string>

namespace contrecoup::gas
{
/// @name Gas states in parameter files.
/// @{

/// Declares entries "Density", "Velocity", "Pressure" and "Products" in the
/// current subsection; the defaults are air at sea level.
void declare_state(ParameterHandler &prm);

/**
 * Reads the entries of declare_state(). Missing velocity components are zero.
 *
 * @param energy_density internal energy density [J/m^3] that determines the
 * pressure, instead of the entry "Pressure"
 * @throws InputError, naming @p where, if check_state() rejects the state or
 * the velocity has non-zero components beyond @p dim.
 */
template <int dim>
GasState<dim> read_state(const ParameterHandler &prm,
                         const GasMaterial &material,
                         const std::string &where,
                         std::optional<double> energy_density = {});

/**
 * Checks a state.
 *
 * @throws InputError, naming @p where, if the density is not positive, the
 * pressure does not exceed that of the least energy which @p material admits at
 * this density, the products are outside [0, 1], or a value is not finite.
 */
template <int dim>
void check_state(const GasState<dim> &state,
                 const GasMaterial &material,
                 const std::string &where);

/// Reads a declare_list() entry as a vector; missing components are zero.
/// @throws InputError, naming @p where, for non-zero components beyond @p dim.
template <int dim>
dealii::Tensor<1, dim> read_vector(const ParameterHandler &prm,
                                   const std::string &name,
                                   const std::string &where);

/// As read_vector(), normalised to length one.
/// @throws InputError, naming @p where, if all components are zero.
template <int dim>
dealii::Tensor<1, dim> read_direction(const ParameterHandler &prm,
                                      const std::string &name,
                                      const std::string &where);
/// @}
} // namespace contrecoup::gas
