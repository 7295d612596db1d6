// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/region_material.h>
#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/materials/explosives.h>

#include <algorithm>

namespace contrecoup::ale
{
namespace
{
  const std::vector<std::string> materials{"ideal gas",
                                           "tait",
                                           "jwl",
                                           "jwl in air",
                                           "elastic",
                                           "viscoelastic",
                                           "johnson-cook",
                                           "tissue"};

  void declare_fluid(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Gamma",
                   "1.4",
                   1.0001,
                   100.,
                   "-",
                   used_with("Material = ideal gas, jwl in air",
                             "Ratio of specific heats of ideal gas or air."));
    declare_selection(
      prm,
      "Explosive",
      "tnt",
      explosive_names(),
      used_with("Material = jwl, jwl in air",
                "Explosive of the products in jwl and jwl in air."));
    declare_double(
      prm,
      "Bulk modulus",
      "2.2e9",
      1.,
      1e15,
      "Pa",
      used_with(
        "Material = tait, viscoelastic",
        "K_0 of a Tait liquid at zero pressure, and of viscoelastic solids."));
    declare_double(prm,
                   "Exponent",
                   "7.15",
                   1.0001,
                   100.,
                   "-",
                   used_with("Material = tait", "n of a Tait liquid."));
    declare_string(
      prm,
      "Least pressure",
      "none",
      used_with("Material = tait",
                "Pressure at which a Tait liquid cavitates [Pa], at most "
                "0; none: it sustains any tension."));
  }

  void declare_viscoelastic(ParameterHandler &prm)
  {
    const UsedWith used("Material = viscoelastic");
    declare_double(prm,
                   "Shear modulus",
                   "49e3",
                   1e-3,
                   1e15,
                   "Pa",
                   "Instantaneous shear modulus G_0 of viscoelastic solids.");
    declare_double(
      prm,
      "Long-term shear modulus",
      "16e3",
      0.,
      1e15,
      "Pa",
      "Shear modulus of viscoelastic solids after full relaxation.");
    declare_double(prm,
                   "Relaxation time",
                   "6e-3",
                   0.,
                   1e6,
                   "s",
                   "Time constant of the relaxation of viscoelastic solids; 0: "
                   "they relax at once.");
  }

  void declare_solid(ParameterHandler &prm)
  {
    declare_double(
      prm,
      "Young modulus",
      "6.5e9",
      1e-3,
      1e15,
      "Pa",
      used_with("Material = elastic, johnson-cook",
                "E of elastic solids and johnson-cook; copper has 124e9."));
    declare_double(
      prm,
      "Poisson ratio",
      "0.22",
      -0.9,
      0.499999,
      "-",
      used_with("Material = elastic, johnson-cook",
                "Of elastic solids and johnson-cook; copper has 0.34."));
    declare_viscoelastic(prm);
    declare_selection(
      prm,
      "Tissue",
      "brain",
      tissue_names(),
      used_with("Material = tissue",
                "Tissue whose density and moduli Material = tissue uses."));
    declare_selection(
      prm,
      "Tissue set",
      "paper",
      tissue_set_names(),
      used_with("Material = tissue", "Property set of the tissue."));
    declare_selection(
      prm,
      "Kinematics",
      "finite rotation",
      names_of(solid_kinematics),
      used_with(
        "Material = elastic, viscoelastic, tissue",
        "Strain measure of solids; johnson-cook is always neo-hookean."));
  }

  void declare_strength(ParameterHandler &prm)
  {
    const UsedWith used("Material = johnson-cook");
    declare_double(prm,
                   "Yield stress",
                   "90e6",
                   0.,
                   1e12,
                   "Pa",
                   "A of johnson-cook: (A + B e^n) (1 + C ln(max(1, e' / "
                   "e'_0))) (1 - T*^m), with plastic strain e, its rate e' "
                   "and homologous temperature T*. Defaults are those of "
                   "OFHC copper.");
    declare_double(
      prm, "Hardening modulus", "292e6", 0., 1e12, "Pa", "B of johnson-cook.");
    declare_double(
      prm, "Hardening exponent", "0.31", 0.01, 1., "-", "n of johnson-cook.");
    declare_double(
      prm, "Rate coefficient", "0.025", 0., 1., "-", "C of johnson-cook.");
    declare_double(prm,
                   "Reference rate",
                   "1",
                   1e-9,
                   1e9,
                   "1/s",
                   "e'_0 of johnson-cook; lower rates have no effect.");
  }

  void declare_softening(ParameterHandler &prm)
  {
    const UsedWith used("Material = johnson-cook");
    declare_double(
      prm, "Softening exponent", "1.09", 0.01, 100., "-", "m of johnson-cook.");
    declare_double(prm,
                   "Melting temperature",
                   "1356",
                   1.,
                   1e5,
                   "K",
                   "Temperature at which T* of johnson-cook is 1.");
    declare_double(
      prm,
      "Reference temperature",
      "298",
      0.,
      1e5,
      "K",
      "Temperature at which T* of johnson-cook is 0; the initial one.");
    declare_double(prm,
                   "Heat capacity",
                   "383",
                   1.,
                   1e6,
                   "J/(kg K)",
                   "Specific heat capacity of johnson-cook.");
    declare_double(
      prm,
      "Heating part",
      "0.9",
      0.,
      1.,
      "-",
      "Fraction of plastic work of johnson-cook that becomes heat.");
  }

  void declare_viscosity(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Linear viscosity",
                   "0.5",
                   0.,
                   10.,
                   "-",
                   "Linear artificial viscosity in compression, times "
                   "density, cell length and sound speed: 0.5 for shocks in "
                   "gases; 0.06 leaves sound in liquids and solids undamped.");
    declare_double(prm,
                   "Quadratic viscosity",
                   "2",
                   0.,
                   10.,
                   "-",
                   "Quadratic artificial viscosity in compression, times "
                   "density, squared cell length and compression rate.");
    declare_double(prm,
                   "Hourglass coefficient",
                   "0.1",
                   0.,
                   1.,
                   "-",
                   "Viscous hourglass control; in solids only where K "
                   "exceeds 100 G. Its damping of shear grows with K / G: "
                   "at 1e6, half a period of a wave of twelve cells loses a "
                   "quarter of its amplitude, without it nothing.");
  }

  /// The entry Density as a number.
  double read_density(ParameterHandler &prm, const std::string &name)
  {
    const std::string entry = "Region " + name + "/Density";
    const Expression density(entry, prm.get("Density"));
    if (density.depends_on_place())
      throw InputError(entry + ": that of a liquid or solid without pressure "
                               "must be a number");
    return density.value({});
  }

  /// Larger than in any liquid or solid: reveals default constants of air.
  constexpr double largest_sound_speed = 2e4;

  Tait parse_tait(ParameterHandler &prm, const std::string &name)
  {
    const std::string least = prm.get("Least pressure");
    const double density = read_density(prm, name),
                 modulus = read_double(prm, "Bulk modulus");
    const double speed = std::sqrt(modulus / density);
    if (density > 0. && speed > largest_sound_speed)
      throw InputError("Region " + name +
                       ": in a liquid of Density = " + brief(density) +
                       " kg/m^3 and Bulk modulus = " + brief(modulus) +
                       " Pa the sound speed would be " + brief(speed) +
                       " m/s; set both entries to those of the liquid");
    return Tait(
      density,
      modulus,
      read_double(prm, "Exponent"),
      least == "none"
        ? -std::numeric_limits<double>::infinity()
        : Expression("Region " + name + "/Least pressure", least).value({}));
  }

  SolidMaterial parse_solid(ParameterHandler &prm, const std::string &name)
  {
    const std::string kind = prm.get("Material");
    if (kind == "tissue")
      return solid_material(find_tissue_properties(
        prm.get("Tissue set"), find_tissue(prm.get("Tissue"))));
    SolidMaterial material;
    material.density = read_density(prm, name);
    if (kind == "elastic" || kind == "johnson-cook")
    {
      const double young = read_double(prm, "Young modulus"),
                   poisson = read_double(prm, "Poisson ratio");
      material.bulk_modulus = young / (3. * (1. - 2. * poisson));
      material.instantaneous_shear = young / (2. * (1. + poisson));
    }
    else
    {
      material.bulk_modulus = read_double(prm, "Bulk modulus");
      material.instantaneous_shear = read_double(prm, "Shear modulus");
      material.relaxing_shear = material.instantaneous_shear -
                                read_double(prm, "Long-term shear modulus");
      material.relaxation_time = read_double(prm, "Relaxation time");
    }
    material.check("Region " + name);
    if (material.dilatational_speed() > largest_sound_speed)
      throw InputError("Region " + name + ": in a solid of Density = " +
                       brief(material.density) + " kg/m^3 and these moduli " +
                       "the sound speed would be " +
                       brief(material.dilatational_speed()) +
                       " m/s; set Density and moduli to those of the solid");
    return material;
  }

  JohnsonCook parse_metal(ParameterHandler &prm, const std::string &name)
  {
    JohnsonCook metal;
    metal.yield_stress = read_double(prm, "Yield stress");
    metal.hardening = read_double(prm, "Hardening modulus");
    metal.hardening_exponent = read_double(prm, "Hardening exponent");
    metal.rate_coefficient = read_double(prm, "Rate coefficient");
    metal.reference_rate = read_double(prm, "Reference rate");
    metal.softening_exponent = read_double(prm, "Softening exponent");
    metal.melting_temperature = read_double(prm, "Melting temperature");
    metal.reference_temperature = read_double(prm, "Reference temperature");
    metal.heat_capacity =
      read_density(prm, name) * read_double(prm, "Heat capacity");
    metal.heating_fraction = read_double(prm, "Heating part");
    metal.check("Region " + name);
    return metal;
  }

  RegionLaw parse_law(ParameterHandler &prm, const std::string &name)
  {
    const std::string kind = prm.get("Material");
    if (kind == "ideal gas")
      return IdealGas(read_double(prm, "Gamma"));
    if (kind == "tait")
      return parse_tait(prm, name);
    const auto &jwl = find_explosive(prm.get("Explosive")).jwl;
    if (kind == "jwl")
      return MieGrueneisen::jwl(jwl);
    if (kind == "jwl in air")
      return MieGrueneisen::jwl_in_air(jwl, read_double(prm, "Gamma"));
    return parse_solid(prm, name);
  }

  InitialMatter matter_of(const Tait &liquid,
                          const double /*density*/,
                          const double pressure,
                          const double /*products*/)
  {
    InitialMatter matter{};
    matter.density = liquid.density_at(pressure);
    if (!(matter.density > 0.))
      return matter;
    matter.energy = matter.density * liquid.stored_energy(matter.density);
    double found = 0.;
    liquid.pressure_and_sound_speed(
      matter.density, 0., 0., found, matter.sound_speed_squared);
    return matter;
  }

  InitialMatter matter_of(const SolidMaterial &solid,
                          const double /*density*/,
                          const double /*pressure*/,
                          const double /*products*/)
  {
    const double speed = solid.dilatational_speed();
    return {solid.density, 0., speed * speed};
  }

  template <typename Gas>
  InitialMatter matter_of(const Gas &gas,
                          const double density,
                          const double pressure,
                          const double products)
  {
    return {density,
            gas.internal_energy_density(density, pressure, products),
            gas.sound_speed_squared(density, pressure, products)};
  }
} // namespace


void declare_region_material(ParameterHandler &prm)
{
  declare_selection(prm,
                    "Material",
                    "ideal gas",
                    materials,
                    "Fluids: jwl are the products of an explosive, jwl in "
                    "air their mixture with air. Solids: elastic and "
                    "viscoelastic have the moduli below, tissue those of "
                    "the named tissue. johnson-cook is an elastic-plastic "
                    "metal, with particles only.");
  declare_fluid(prm);
  declare_solid(prm);
  declare_strength(prm);
  declare_softening(prm);
  declare_viscosity(prm);
  declare_selection(
    prm,
    "Interface",
    "stick",
    {"stick", "slip"},
    selecting("Interface of a fluid with other regions. stick: shared "
              "nodes; slip: frictionless sliding without separation. "
              "Slipping regions stick to each other."));
}


Region parse_region_material(ParameterHandler &prm, const std::string &name)
{
  Region region;
  region.name = name;
  region.law = parse_law(prm, name);
  if (prm.get("Material") == "johnson-cook")
    region.plasticity = parse_metal(prm, name);
  region.viscosity = {read_double(prm, "Linear viscosity"),
                      read_double(prm, "Quadratic viscosity"),
                      read_double(prm, "Hourglass coefficient")};
  region.kinematics = find_choice(
    solid_kinematics, prm.get("Kinematics"), "kinematics of solids");
  region.slides = prm.get("Interface") == "slip";
  if (region.slides && region.solid() != nullptr)
    throw InputError("Region " + name +
                     "/Interface = slip is for fluids; give it to the fluid "
                     "at this solid");
  return region;
}


InitialMatter initial_matter(const Region &region,
                             const double density,
                             const double pressure,
                             const double products)
{
  return std::visit(
    [&](const auto &law) {
      return matter_of(law, density, pressure, products);
    },
    region.law);
}
} // namespace contrecoup::ale
