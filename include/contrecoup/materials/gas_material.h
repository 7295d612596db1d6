// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <variant>
#include <vector>

namespace contrecoup
{
/**
 * The gas of a scene, subsection "Material": its equation of state for
 * kernels, and the same functions for plain numbers. Default: air.
 *
 * Units are those of IdealGas; @p products is the mass fraction of explosive
 * products.
 */
class GasMaterial
{
public:
  using Model = std::variant<IdealGas, MieGrueneisen>;

  GasMaterial() = default;

  explicit GasMaterial(const Model &model);

  /// Names of the equations of state.
  static std::vector<std::string> equation_of_state_names();

  /// Declares subsection "Material".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads subsection "Material".
  /// @throws InputError for unphysical custom constants
  void parse_parameters(dealii::ParameterHandler &prm);

  /// The equation of state. Visit it once, outside of kernels.
  const Model &model() const;

  bool is_ideal() const;

  /// @throws std::bad_variant_access unless is_ideal().
  const IdealGas &ideal() const;

  /// Whether the mass fraction of products is part of the state.
  bool has_products() const;

  /// Initial density of the explosive [kg/m^3]; 0 without explosive.
  double reference_density() const;

  /// Specific energy e_0 released by the explosive [J/kg]; 0 without
  /// explosive.
  double reference_energy() const;

  /// JWL constants of the explosive; zero without explosive.
  const JwlParameters &explosive() const;

  double pressure(double density,
                  double internal_energy_density,
                  double products) const;

  double internal_energy_density(double density,
                                 double pressure,
                                 double products) const;

  double
  sound_speed_squared(double density, double pressure, double products) const;

  double least_energy_density(double density, double products) const;

  double temperature(double density, double pressure, double products) const;

private:
  Model model_;
  JwlParameters explosive_;
};
} // namespace contrecoup
