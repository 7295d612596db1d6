// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/materials/custom_explosive.h>
#include <contrecoup/materials/gas_material.h>

namespace contrecoup
{
GasMaterial::GasMaterial(const Model &model)
  : model_(model)
{}

std::vector<std::string> GasMaterial::equation_of_state_names()
{
  return {"ideal gas", "stiffened gas", "jwl", "jwl in air"};
}

void GasMaterial::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Material");
  declare_selection(prm,
                    "Equation of state",
                    "ideal gas",
                    equation_of_state_names(),
                    "One ideal or stiffened gas, pure explosive products, "
                    "or products mixed with an ideal gas. With jwl and B of "
                    "at least 0, states below the cold curve are refused, "
                    "also where their sound speed is real: limiters need the "
                    "convex set above it. With B < 0, all states of pure jwl "
                    "with a real sound speed are taken.");
  declare_double(
    prm,
    "Gamma",
    "1.4",
    1.001,
    100.,
    "-",
    used_with(
      "Material/Equation of state not jwl",
      "Ratio of specific heats of the ideal or stiffened gas, or of air."));
  declare_double(prm,
                 "Gas constant",
                 "287.05287",
                 1e-6,
                 1e6,
                 "J/(kg K)",
                 "Specific gas constant; gives the temperature and, with "
                 "Gamma, the specific heat.");
  declare_double(
    prm,
    "Stiffening pressure",
    "0",
    0.,
    1e15,
    "Pa",
    used_with("Material/Equation of state = stiffened gas", "p_infinity."));
  std::vector<std::string> explosives = explosive_names();
  explosives.push_back("custom");
  declare_selection(
    prm,
    "Explosive",
    "tnt",
    explosives,
    used_with("Material/Equation of state = jwl, jwl in air",
              "JWL constants from the library, or those of subsection "
              "Custom explosive."));
  const Section custom(prm, "Custom explosive");
  const UsedWith used("Explosive = custom");
  CustomExplosive::declare_parameters(prm);
}

void GasMaterial::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Material");
  const std::string equation = prm.get("Equation of state");
  const double gamma = read_double(prm, "Gamma");
  const double gas_constant = read_double(prm, "Gas constant");

  explosive_ = JwlParameters();
  if (equation == "ideal gas")
    model_ = IdealGas(gamma, gas_constant);
  else if (equation == "stiffened gas")
    model_ = MieGrueneisen::stiffened_gas(
      gamma, read_double(prm, "Stiffening pressure"), gas_constant);
  else
  {
    explosive_ = read_explosive(prm).jwl;
    model_ = equation == "jwl"
               ? MieGrueneisen::jwl(explosive_)
               : MieGrueneisen::jwl_in_air(explosive_, gamma, gas_constant);
  }
}

const GasMaterial::Model &GasMaterial::model() const
{
  return model_;
}

bool GasMaterial::is_ideal() const
{
  return std::holds_alternative<IdealGas>(model_);
}

const IdealGas &GasMaterial::ideal() const
{
  return std::get<IdealGas>(model_);
}

bool GasMaterial::has_products() const
{
  return !is_ideal() && std::get<MieGrueneisen>(model_).uses_products();
}

double GasMaterial::reference_density() const
{
  return explosive_.energy_density > 0. ? explosive_.reference_density : 0.;
}

double GasMaterial::reference_energy() const
{
  return explosive_.energy_density / explosive_.reference_density;
}

const JwlParameters &GasMaterial::explosive() const
{
  return explosive_;
}

double GasMaterial::pressure(const double density,
                             const double internal_energy_density,
                             const double products) const
{
  return std::visit(
    [&](const auto &gas) {
      return gas.pressure(density, internal_energy_density, products);
    },
    model_);
}

double GasMaterial::internal_energy_density(const double density,
                                            const double pressure,
                                            const double products) const
{
  return std::visit(
    [&](const auto &gas) {
      return gas.internal_energy_density(density, pressure, products);
    },
    model_);
}

double GasMaterial::sound_speed_squared(const double density,
                                        const double pressure,
                                        const double products) const
{
  return std::visit(
    [&](const auto &gas) {
      return gas.sound_speed_squared(density, pressure, products);
    },
    model_);
}

double GasMaterial::least_energy_density(const double density,
                                         const double products) const
{
  return std::visit(
    [&](const auto &gas) {
      return gas.least_energy_density(density, products);
    },
    model_);
}

double GasMaterial::temperature(const double density,
                                const double pressure,
                                const double products) const
{
  return std::visit(
    [&](const auto &gas) {
      return gas.temperature(density, pressure, products);
    },
    model_);
}
} // namespace contrecoup
