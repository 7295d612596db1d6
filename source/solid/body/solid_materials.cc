// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/tissue_list.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/solid/body/solid_materials.h>

#include <algorithm>

namespace contrecoup::solid
{
namespace
{
  void declare_gas(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Gas part",
                   "0",
                   0.,
                   1.,
                   "-",
                   "Fraction of the undeformed volume that is gas. The gas "
                   "stiffens under compression while the rest is "
                   "incompressible; Bulk modulus is then the modulus at "
                   "small strains. 0: pressure is proportional to the "
                   "change of volume.");
    declare_double(prm,
                   "Gas exponent",
                   "1.4",
                   0.1,
                   10.,
                   "-",
                   "Polytropic exponent of the gas: 1.4 for adiabatic air, "
                   "1 for isothermal air.");
    declare_double(
      prm,
      "Modulus without gas",
      "2.2e9",
      1e-6,
      1e15,
      "Pa",
      "Bulk modulus when all gas is squeezed out, not below Bulk modulus.");
  }

  void declare_custom(ParameterHandler &prm)
  {
    const Section section(prm, "Tissue *");
    declare_double(prm,
                   "Density",
                   "1000",
                   1e-6,
                   1e6,
                   "kg/m^3",
                   "Mass density of the tissue of this subsection.");
    declare_double(prm,
                   "Young's modulus",
                   "0",
                   0.,
                   1e15,
                   "Pa",
                   "With Poisson's ratio replaces bulk and shear modulus; "
                   "0: use Bulk modulus and Shear modulus.");
    declare_double(prm,
                   "Poisson's ratio",
                   "0.3",
                   -0.999,
                   0.4999999,
                   "-",
                   "Only used with Young's modulus.");
    declare_double(prm,
                   "Bulk modulus",
                   "2.2e9",
                   1e-6,
                   1e15,
                   "Pa",
                   "Ratio of pressure to compression at small strains.");
    declare_double(prm,
                   "Shear modulus",
                   "0",
                   0.,
                   1e15,
                   "Pa",
                   "Instantaneous shear modulus G_0.");
    declare_double(prm,
                   "Relaxing shear modulus",
                   "0",
                   0.,
                   1e15,
                   "Pa",
                   "The part of G_0 that relaxes to zero.");
    declare_double(prm,
                   "Relaxation time",
                   "0.006",
                   1e-12,
                   1e6,
                   "s",
                   "Time in which the relaxing part decays to 1/e.");
    declare_gas(prm);
  }

  /// @throws InputError when the gas is stiffer than the tissue around it
  GasFilling read_gas(ParameterHandler &prm,
                      const double bulk_modulus,
                      const std::string &name)
  {
    const double gas_fraction = read_double(prm, "Gas part");
    if (gas_fraction == 0.)
      return {};
    const double max_stiffness =
      read_double(prm, "Modulus without gas") / bulk_modulus;
    if (!(max_stiffness >= 1.))
      throw InputError("Materials/Tissue " + name +
                       "/Modulus without gas must be at least the bulk "
                       "modulus, " +
                       brief(bulk_modulus) + " Pa");
    return {gas_fraction, read_double(prm, "Gas exponent"), max_stiffness};
  }

  /// Choices of "Bulk law".
  const std::vector<std::string> bulk_laws{"of the tissue", "linear"};
} // namespace


void SolidMaterials::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Materials");
  declare_selection(prm,
                    "Set",
                    "paper",
                    tissue_set_names(),
                    "Tissue properties: table 1 of the paper, measured wave "
                    "speeds of tissue, or the paper's with the lung of the "
                    "latter.");
  declare_selection(prm,
                    "Reading of G1",
                    "relaxing branch",
                    {"relaxing branch", "long-term modulus"},
                    "Meaning of the paper's G1 = 33 kPa of the brain: the "
                    "part that relaxes (leaving 16 kPa, as published for "
                    "brain), or the long-term modulus.");
  declare_selection(prm,
                    "Bulk law",
                    bulk_laws[0],
                    bulk_laws,
                    "Pressure as a function of volume. With \"of the tissue\" "
                    "the air in an aerated lung stiffens under "
                    "compression (p v^1.4 = const), and other tissues of the "
                    "sets have constant moduli. With \"linear\" all have "
                    "constant moduli; the lung then collapses under more than "
                    "some hundred kilopascals.");
  declare_string(prm,
                 "Cavitating tissues",
                 "",
                 "Tissues that bear no tension beyond Least pressure: names "
                 "separated by commas. Cavities open there at constant "
                 "pressure and collapse when the matter meets again. Empty: "
                 "all bear any tension.");
  declare_double(prm,
                 "Least pressure",
                 "-98.99e3",
                 -1e12,
                 -1e-6,
                 "Pa",
                 "Of cavitating tissues, above the ambient pressure; the "
                 "default is the vapour pressure of water at 20 degrees "
                 "Celsius, 2.34 kPa, less 101.325 kPa.");
  declare_custom(prm);
}


void SolidMaterials::parse_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Materials");
    set_ = prm.get("Set");
    has_gas_ = prm.get("Bulk law") == bulk_laws[0];
    g1_is_long_term_ = prm.get("Reading of G1") == "long-term modulus";
    cavitating_ = find_tissues(prm.get("Cavitating tissues"),
                               "Materials/Cavitating tissues");
    largest_tension_ = -read_double(prm, "Least pressure");
  }
  for (const std::string &name : item_names(prm, "Materials/Tissue"))
  {
    const Section section(prm, "Materials");
    const Section custom(prm, "Tissue " + name);
    SolidMaterial material;
    material.density = read_double(prm, "Density");
    const double young = read_double(prm, "Young's modulus");
    const double poisson = read_double(prm, "Poisson's ratio");
    material.bulk_modulus = young > 0. ? young / (3. * (1. - 2. * poisson))
                                       : read_double(prm, "Bulk modulus");
    material.instantaneous_shear = young > 0.
                                     ? young / (2. * (1. + poisson))
                                     : read_double(prm, "Shear modulus");
    material.relaxing_shear = read_double(prm, "Relaxing shear modulus");
    material.relaxation_time = read_double(prm, "Relaxation time");
    material.gas = read_gas(prm, material.bulk_modulus, name);
    material.check("Materials/Tissue " + name);
    custom_[find_tissue(name)] = material;
  }
}


SolidMaterial SolidMaterials::find(const Tissue tissue) const
{
  SolidMaterial material;
  const auto custom = custom_.find(tissue);
  if (custom != custom_.end())
    material = custom->second;
  else
  {
    material = solid_material(find_tissue_properties(set_, tissue),
                              g1_is_long_term_ && set_ == "paper");
    if (!has_gas_)
      material.gas = GasFilling();
  }
  if (std::find(cavitating_.begin(), cavitating_.end(), tissue) !=
      cavitating_.end())
    material.largest_tension = largest_tension_;
  return material;
}


std::vector<SolidMaterial>
SolidMaterials::find(const std::vector<Tissue> &tissues) const
{
  std::vector<SolidMaterial> materials;
  for (const Tissue tissue : tissues)
    materials.push_back(find(tissue));
  return materials;
}
} // namespace contrecoup::solid
