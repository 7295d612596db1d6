// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/new_tissues.h>
#include <contrecoup/base/parameters/number_or_word.h>
#include <contrecoup/base/parameters/parameter_names.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/materials/own_tissues.h>

#include <algorithm>

namespace contrecoup
{
namespace
{
  /// Default of all entries: the value of the library's tissue.
  const std::string of_library = "library";

  /// Gas of tissues that have none in the library.
  constexpr double usual_exponent = 1.4, usual_modulus = 2.2e9;

  struct Property
  {
    std::string name;
    double smallest;
    double largest;
    std::string unit;
    std::string sentence;
  };

  const std::vector<Property> &properties()
  {
    static const std::vector<Property> list{
      {"Density", 1e-6, 1e6, "kg/m^3", "Mass density."},
      {"Young's modulus",
       1e-6,
       1e15,
       "Pa",
       "With Poisson's ratio in place of bulk and shear modulus."},
      {"Poisson's ratio",
       -0.999,
       0.499999, // no more digits: deal.II prints and rereads six
       "-",
       "See Young's modulus; tissues that are less compressible need Bulk "
       "modulus and Shear modulus."},
      {"Bulk modulus",
       1e-6,
       1e15,
       "Pa",
       "Ratio of pressure to compression at small strains."},
      {"Shear modulus", 0., 1e15, "Pa", "Instantaneous shear modulus G_0."},
      {"Relaxing shear modulus",
       0.,
       1e15,
       "Pa",
       "The part of G_0 that relaxes to zero; new tissues: 0."},
      {"Relaxation time",
       0.,
       1e6,
       "s",
       "Time in which the relaxing part decays to 1/e; 0: at once."},
      {"Gas part",
       0.,
       1.,
       "-",
       "Fraction of the undeformed volume that is gas. The gas stiffens under "
       "compression while the rest is incompressible; Bulk modulus is then the "
       "modulus at small strains. 0: pressure is proportional to the change of "
       "volume; new tissues: 0."},
      {"Gas exponent",
       0.1,
       10.,
       "-",
       "Polytropic exponent of the gas: 1.4 for adiabatic air, 1 for isothermal "
       "air; where the library has no gas: 1.4."},
      {"Modulus without gas",
       1e-6,
       1e15,
       "Pa",
       "Bulk modulus when all gas is squeezed out, not below Bulk modulus; "
       "where the library has no gas: 2.2e9."}};
    return list;
  }

  double young_of(const SolidMaterial &material)
  {
    const double k = material.bulk_modulus, g = material.instantaneous_shear;
    return 9. * k * g / (3. * k + g);
  }

  double poisson_of(const SolidMaterial &material)
  {
    const double k = material.bulk_modulus, g = material.instantaneous_shear;
    return (3. * k - 2. * g) / (2. * (3. * k + g));
  }

  /// Digits of a property in words; rounded Poisson's ratios become 0.5.
  int digits_of(const std::string &name)
  {
    return name == "Poisson's ratio" ? 8 : 4;
  }

  /// The property of a material, by the name of its entry.
  double value_of(const SolidMaterial &material, const std::string &name)
  {
    const GasFilling &gas = material.gas;
    if (name == "Density")
      return material.density;
    if (name == "Young's modulus")
      return young_of(material);
    if (name == "Poisson's ratio")
      return poisson_of(material);
    if (name == "Bulk modulus")
      return material.bulk_modulus;
    if (name == "Shear modulus")
      return material.instantaneous_shear;
    if (name == "Relaxing shear modulus")
      return material.relaxing_shear;
    if (name == "Relaxation time")
      return material.is_viscoelastic() ? material.relaxation_time : 0.;
    if (name == "Gas part")
      return gas.gas_fraction();
    if (name == "Gas exponent")
      return gas.exists() ? gas.exponent() : usual_exponent;
    return gas.exists() ? gas.max_stiffness() * material.bulk_modulus
                        : usual_modulus;
  }
} // namespace


void OwnTissues::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Tissue *");
  for (const Property &property : properties())
    declare_number_or_word(prm,
                           property.name,
                           of_library,
                           property.smallest,
                           property.largest,
                           property.unit,
                           property.sentence);
}


void OwnTissues::parse_parameters(ParameterHandler &prm,
                                  const std::string &section)
{
  for (const std::string &name : item_names(prm, section + "/Tissue"))
  {
    const Section outer(prm, section);
    const Section inner(prm, "Tissue " + name);
    const std::string known = resolve_name(name, tissue_names());
    Entries entries{Tissue::none, section + "/Tissue " + name, {}};
    if (known == name_of(Tissue::none))
      throw InputError(entries.path + ": \"none\" is not a tissue");
    for (const Property &property : properties())
      if (const auto value = read_number(prm, property.name, of_library))
        entries.values[property.name] = *value;
    entries.refuse_contradictions();
    if (known.empty() || is_new(find_tissue(known)))
      entries.refuse_incomplete(name);
    entries.tissue = add_tissue(known.empty() ? name : known);
    if (find(entries.tissue) != nullptr)
      throw InputError(entries.path + ": a second section of this tissue");
    entries_.push_back(entries);
  }
}


void OwnTissues::Entries::refuse_contradictions() const
{
  for (const std::string elastic : {"Young's modulus", "Poisson's ratio"})
    for (const std::string modulus : {"Bulk modulus", "Shear modulus"})
      if (has(elastic) && has(modulus))
        throw InputError(path + ": " + elastic + " and " + modulus +
                         " contradict each other; set Young's modulus and "
                         "Poisson's ratio, or Bulk modulus and Shear modulus");
}


void OwnTissues::Entries::refuse_incomplete(const std::string &name) const
{
  std::vector<std::string> missing;
  if (!has("Density"))
    missing.emplace_back("Density");
  const bool has_elastic = has("Young's modulus") || has("Poisson's ratio");
  for (const std::string &entry :
       has_elastic
         ? std::vector<std::string>{"Young's modulus", "Poisson's ratio"}
         : std::vector<std::string>{"Bulk modulus", "Shear modulus"})
    if (!has(entry))
      missing.push_back(entry);
  if (missing.empty())
    return;
  const std::vector<std::string> known{tissue_names().begin() + 1,
                                       tissue_names().end()};
  const std::string meant = nearest(name, known);
  throw InputError(
    path + ": no tissue of the library has this name" +
    (meant.empty() ? "" : "; did you mean \"" + meant + "\"?") +
    " (known are " + join(known, ", ") + "), and a new tissue needs " +
    join(missing, ", ") +
    (has_elastic ? "" : " (or Young's modulus and Poisson's ratio)"));
}


const OwnTissues::Entries *OwnTissues::find(const Tissue tissue) const
{
  const auto found =
    std::find_if(entries_.begin(), entries_.end(), [&](const Entries &one) {
      return one.tissue == tissue;
    });
  return found == entries_.end() ? nullptr : &*found;
}


std::vector<Tissue> OwnTissues::tissues() const
{
  std::vector<Tissue> list;
  for (const Entries &one : entries_)
    list.push_back(one.tissue);
  return list;
}


void OwnTissues::Entries::set_moduli(SolidMaterial &material) const
{
  if (has("Young's modulus") || has("Poisson's ratio"))
  {
    const double young = value_or("Young's modulus", young_of(material)),
                 poisson = value_or("Poisson's ratio", poisson_of(material));
    material.bulk_modulus = young / (3. * (1. - 2. * poisson));
    material.instantaneous_shear = young / (2. * (1. + poisson));
    return;
  }
  material.bulk_modulus = value_or("Bulk modulus", material.bulk_modulus);
  material.instantaneous_shear =
    value_or("Shear modulus", material.instantaneous_shear);
}


void OwnTissues::Entries::set_relaxation(SolidMaterial &material) const
{
  const bool relaxes = material.is_viscoelastic();
  material.relaxing_shear =
    value_or("Relaxing shear modulus", material.relaxing_shear);
  material.relaxation_time =
    value_or("Relaxation time", material.relaxation_time);
  if (material.relaxing_shear > material.instantaneous_shear)
    throw InputError(
      path + ": Relaxing shear modulus = " + brief(material.relaxing_shear) +
      " Pa" + (has("Relaxing shear modulus") ? "" : " of the library") +
      " exceeds the instantaneous shear modulus, " +
      brief(material.instantaneous_shear) +
      " Pa; set it to at most that, 0 for an elastic tissue");
  if (material.is_viscoelastic() && !relaxes && !has("Relaxation time"))
    throw InputError(path + ": Relaxing shear modulus needs Relaxation time");
  if (!material.is_viscoelastic() && has("Relaxation time") &&
      !has("Relaxing shear modulus"))
    throw InputError(path + ": Relaxation time has no effect, since nothing "
                            "relaxes; set Relaxing shear modulus");
}


void OwnTissues::Entries::set_gas(SolidMaterial &material) const
{
  const double fraction = value_of(material, "Gas part");
  const double exponent =
    value_or("Gas exponent", value_of(material, "Gas exponent"));
  // Before the bulk modulus changes.
  const double modulus =
    value_or("Modulus without gas", value_of(material, "Modulus without gas"));
  set_moduli(material);
  const double wanted = value_or("Gas part", fraction);
  for (const std::string name : {"Gas exponent", "Modulus without gas"})
    if (wanted == 0. && has(name) && !has("Gas part"))
      throw InputError(path + ": " + name +
                       " has no effect without gas; set Gas part");
  material.gas = GasFilling();
  if (wanted == 0.)
    return;
  if (!(modulus >= material.bulk_modulus))
    throw InputError(path + "/Modulus without gas = " + brief(modulus) +
                     " Pa must be at least the bulk modulus, " +
                     brief(material.bulk_modulus) + " Pa");
  material.gas = GasFilling(wanted, exponent, modulus / material.bulk_modulus);
}


SolidMaterial OwnTissues::apply(const Tissue tissue,
                                const SolidMaterial &library) const
{
  const Entries *const entries = find(tissue);
  if (entries == nullptr && is_new(tissue))
    throw InputError("\"" + name_of(tissue) +
                     "\" is no tissue of the library, and no subsection "
                     "Tissue " +
                     name_of(tissue) + " gives its properties");
  if (entries == nullptr)
    return library;
  SolidMaterial material = is_new(tissue) ? SolidMaterial() : library;
  material.density = entries->value_or("Density", material.density);
  entries->set_gas(material);
  entries->set_relaxation(material);
  material.check(entries->path);
  return material;
}


std::string OwnTissues::Change::in_words() const
{
  return entry + " = " + brief(value, digits_of(entry)) +
         (unit == "-" ? "" : " " + unit);
}


std::vector<OwnTissues::Change>
OwnTissues::changes(const Tissue tissue, const SolidMaterial &library) const
{
  const Entries *const entries = find(tissue);
  std::vector<Change> list;
  if (entries == nullptr)
    return list;
  for (const Property &property : properties())
    if (entries->has(property.name))
    {
      list.push_back(
        {property.name, property.unit, entries->values.at(property.name), {}});
      if (!is_new(tissue))
        list.back().before = value_of(library, property.name);
    }
  return list;
}


std::string OwnTissues::changes_in_words(const Tissue tissue,
                                         const SolidMaterial &library) const
{
  std::vector<std::string> words;
  for (const Change &change : changes(tissue, library))
    words.push_back(
      change.in_words() +
      (change.before
         ? " instead of " + brief(*change.before, digits_of(change.entry))
         : ""));
  return join(words, ", ");
}


SolidMaterial find_solid_material(const std::string &set,
                                  const Tissue tissue,
                                  const OwnTissues &own)
{
  return own.apply(tissue,
                   is_new(tissue)
                     ? SolidMaterial()
                     : solid_material(find_tissue_properties(set, tissue)));
}
} // namespace contrecoup
