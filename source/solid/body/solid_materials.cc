// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/new_tissues.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/tissue_list.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/solid/body/solid_materials.h>

#include <algorithm>

namespace contrecoup::solid
{
namespace
{
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
  declare_selection(
    prm,
    "Reading of G1",
    "relaxing branch",
    {"relaxing branch", "long-term modulus"},
    used_with("Materials/Set = paper",
              "Meaning of the paper's G1 = 33 kPa of the brain: the "
              "part that relaxes (leaving 16 kPa, as published for "
              "brain), or the long-term modulus."));
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
  declare_string(
    prm,
    "Cavitating tissues",
    "",
    selecting("Tissues that bear no tension beyond Least pressure: names "
              "separated by commas. Cavities open there at constant "
              "pressure and collapse when the matter meets again. Empty: "
              "all bear any tension."));
  declare_double(
    prm,
    "Least pressure",
    "-98.99e3",
    -1e12,
    -1e-6,
    "Pa",
    used_with("Materials/Cavitating tissues not empty",
              "Of cavitating tissues, above the ambient pressure; the "
              "default is the vapour pressure of water at 20 degrees "
              "Celsius, 2.34 kPa, less 101.325 kPa."));
  OwnTissues::declare_parameters(prm);
}


void SolidMaterials::parse_parameters(ParameterHandler &prm)
{
  own_.parse_parameters(prm, "Materials");
  {
    const Section section(prm, "Materials");
    set_ = prm.get("Set");
    has_gas_ = prm.get("Bulk law") == bulk_laws[0];
    g1_is_long_term_ = prm.get("Reading of G1") == "long-term modulus";
    cavitating_ = find_tissues(prm.get("Cavitating tissues"),
                               "Materials/Cavitating tissues");
    largest_tension_ = -read_double(prm, "Least pressure");
  }
  for (const Tissue tissue : own_.tissues())
    find(tissue);
}


std::string SolidMaterials::changes(const Tissue tissue) const
{
  return own_.changes_in_words(tissue, of_library(tissue));
}


SolidMaterial SolidMaterials::of_library(const Tissue tissue) const
{
  if (is_new(tissue))
    return {};
  SolidMaterial material = solid_material(find_tissue_properties(set_, tissue),
                                          g1_is_long_term_ && set_ == "paper");
  if (!has_gas_)
    material.gas = GasFilling();
  return material;
}


SolidMaterial SolidMaterials::find(const Tissue tissue) const
{
  SolidMaterial material = own_.apply(tissue, of_library(tissue));
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
