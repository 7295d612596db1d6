// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/materials/explosives.h>
#include <contrecoup/materials/gas_material.h>
#include <contrecoup/materials/jwl_check.h>

namespace contrecoup
{
namespace
{
  void declare_custom_explosive(ParameterHandler &prm)
  {
    const Section section(prm, "Custom explosive");
    const double largest = 1e15;
    declare_double(prm, "A", "373.8e9", 0., largest, "Pa", "JWL constant A.");
    declare_double(prm,
                   "B",
                   "3.747e9",
                   -largest,
                   largest,
                   "Pa",
                   "JWL constant B; negative only if the sound speed stays "
                   "real as the products expand or, without energy release, "
                   "as the explosive is compressed.");
    declare_double(prm, "R1", "4.15", 1e-3, 1e3, "-", "JWL constant R1.");
    declare_double(prm, "R2", "0.9", 1e-3, 1e3, "-", "JWL constant R2.");
    declare_double(prm, "Omega", "0.35", 1e-3, 10., "-", "JWL constant omega.");
    declare_double(prm,
                   "Density",
                   "1630",
                   1e-6,
                   1e6,
                   "kg/m^3",
                   "Density of the unburned explosive.");
    declare_double(prm,
                   "Energy density",
                   "6.0e9",
                   0.,
                   largest,
                   "J/m^3",
                   "Energy E_0 released per volume of unburned explosive.");
    declare_double(prm,
                   "Specific heat",
                   "613.5",
                   1e-6,
                   1e9,
                   "J/(kg K)",
                   "c_v of the products, which weights their mixture with "
                   "air and gives the temperature.");
    declare_double(prm,
                   "Detonation speed",
                   "0",
                   0.,
                   1e6,
                   "m/s",
                   "Published detonation speed, compared with that of the "
                   "constants where charges burn; 0: none.");
    declare_double(
      prm,
      "Detonation pressure",
      "0",
      0.,
      largest,
      "Pa",
      "Published Chapman-Jouguet pressure, compared likewise; 0: none.");
  }

  JwlParameters read_custom_explosive(ParameterHandler &prm)
  {
    const Section section(prm, "Custom explosive");
    JwlParameters jwl;
    jwl.A = read_double(prm, "A");
    jwl.B = read_double(prm, "B");
    jwl.R1 = read_double(prm, "R1");
    jwl.R2 = read_double(prm, "R2");
    jwl.omega = read_double(prm, "Omega");
    jwl.reference_density = read_double(prm, "Density");
    jwl.energy_density = read_double(prm, "Energy density");
    jwl.specific_heat = read_double(prm, "Specific heat");
    require_real_sound_speed(jwl, "Material/Custom explosive");
    return jwl;
  }
} // namespace

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
                    "or products mixed with an ideal gas.");
  declare_double(
    prm,
    "Gamma",
    "1.4",
    1.001,
    100.,
    "-",
    "Ratio of specific heats of the ideal or stiffened gas; not used by jwl.");
  declare_double(prm,
                 "Gas constant",
                 "287.05287",
                 1e-6,
                 1e6,
                 "J/(kg K)",
                 "Specific gas constant; gives the temperature and, with "
                 "Gamma, the specific heat.");
  declare_double(prm,
                 "Stiffening pressure",
                 "0",
                 0.,
                 1e15,
                 "Pa",
                 "p_infinity of the stiffened gas; not used by others.");
  std::vector<std::string> explosives = explosive_names();
  explosives.push_back("custom");
  declare_selection(prm,
                    "Explosive",
                    "tnt",
                    explosives,
                    "JWL constants from the library, or those of subsection "
                    "Custom explosive.");
  declare_custom_explosive(prm);
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
    const std::string name = prm.get("Explosive");
    explosive_ =
      name == "custom" ? read_custom_explosive(prm) : find_explosive(name).jwl;
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

double GasMaterial::cold_energy_density(const double density,
                                        const double products) const
{
  return std::visit(
    [&](const auto &gas) { return gas.cold_energy_density(density, products); },
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
