// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/materials/custom_explosive.h>
#include <contrecoup/materials/jwl_check.h>

#include <algorithm>

namespace contrecoup
{
namespace
{
  constexpr double largest = 1e15;

  /// Entry for one number of an explosive.
  struct Entry
  {
    const char *name;
    const char *unit;
    double smallest, largest;
    double Explosive::*direct;  ///< the number, or null
    double JwlParameters::*jwl; ///< else the number among the JWL constants
    const char *sentence;

    double &in(Explosive &explosive) const
    {
      return direct != nullptr ? explosive.*direct : explosive.jwl.*jwl;
    }
  };

  const std::vector<Entry> &entries()
  {
    using Jwl = JwlParameters;
    static const std::vector<Entry> list{
      {"A", "Pa", 0., largest, nullptr, &Jwl::A, "JWL constant A"},
      {"B",
       "Pa",
       -largest,
       largest,
       nullptr,
       &Jwl::B,
       "JWL constant B, negative only if the sound speed stays real as the "
       "products expand or, without energy release, as the explosive is "
       "compressed"},
      {"R1", "-", 1e-3, 1e3, nullptr, &Jwl::R1, "JWL constant R1"},
      {"R2", "-", 1e-3, 1e3, nullptr, &Jwl::R2, "JWL constant R2"},
      {"Omega", "-", 1e-3, 10., nullptr, &Jwl::omega, "JWL constant omega"},
      {"Density",
       "kg/m^3",
       1e-6,
       1e6,
       nullptr,
       &Jwl::reference_density,
       "Density of the unburned explosive"},
      {"Energy density",
       "J/m^3",
       0.,
       largest,
       nullptr,
       &Jwl::energy_density,
       "Energy E_0 released per volume of unburned explosive"},
      {"Specific heat",
       "J/(kg K)",
       1e-6,
       1e9,
       nullptr,
       &Jwl::specific_heat,
       "c_v of the products, which weights their mixture with air and gives "
       "the temperature"},
      {"Detonation speed",
       "m/s",
       0.,
       1e6,
       &Explosive::detonation_speed,
       nullptr,
       "Published detonation speed, compared with that of the constants where "
       "charges burn; 0, and empty with other constants than those of Like: "
       "none"},
      {"Detonation pressure",
       "Pa",
       0.,
       largest,
       &Explosive::cj_pressure,
       nullptr,
       "Published Chapman-Jouguet pressure, compared likewise"}};
    return list;
  }


  double energy_per_mass(const Explosive &explosive)
  {
    return explosive.jwl.energy_density / explosive.jwl.reference_density;
  }


  /// Adapts values to the energy per mass where it is not that of @p base.
  void adapt_to_energy(const Explosive &base, Explosive &explosive)
  {
    const double before = energy_per_mass(base);
    const double energy = energy_per_mass(explosive);
    if (energy == before)
      return;
    const double ratio = energy / before;
    explosive.tnt = {ratio * base.tnt.pressure,
                     ratio * base.tnt.impulse,
                     false,
                     "that of " + base.title + " times the ratio of energies"};
    Afterburn &afterburn = explosive.afterburn;
    afterburn.largest = std::max(0., afterburn.largest + before - energy);
    afterburn.energy = std::min(afterburn.energy, afterburn.largest);
  }
} // namespace


const std::vector<std::string> &CustomExplosive::entry_names()
{
  static const std::vector<std::string> names = []() {
    std::vector<std::string> result;
    for (const Entry &entry : entries())
      result.push_back(entry.name);
    return result;
  }();
  return names;
}


void CustomExplosive::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_selection(prm,
                    "Like",
                    "tnt",
                    explosive_names(),
                    "Explosive of the library that has the values of the "
                    "empty entries beside.");
  for (const Entry &entry : entries())
    declare_list(prm,
                 entry.name,
                 "",
                 0,
                 1,
                 entry.smallest,
                 entry.largest,
                 entry.unit,
                 std::string(entry.sentence) + "; empty: as Like.");
}


void CustomExplosive::parse_parameters(const dealii::ParameterHandler &prm,
                                       const std::string &section)
{
  like = prm.get("Like");
  Explosive base = find_explosive(like);
  explosive = base;
  explosive.name = explosive.title = "custom";
  explosive.source = section;
  changes.clear();
  bool has_other_constants = false;
  for (const Entry &entry : entries())
  {
    double &value = entry.in(explosive);
    const double before = entry.in(base);
    // A published speed belongs to the published constants.
    if (entry.jwl == nullptr && has_other_constants)
      value = 0.;
    const std::vector<double> given = read_list(prm, entry.name);
    if (given.empty())
      continue;
    value = given[0];
    if (value == before)
      continue;
    changes.push_back({entry.name, entry.unit, value, before});
    has_other_constants = has_other_constants || entry.jwl != nullptr;
  }
  if (changes.empty())
    log_line("WARNING: " + section + ": no entry differs from " + base.title +
             ", so that the explosive is " + base.title);
  adapt_to_energy(base, explosive);
  require_real_sound_speed(explosive.jwl, section);
}


Explosive read_explosive(dealii::ParameterHandler &prm)
{
  const std::string name = prm.get("Explosive");
  if (name != "custom")
    return find_explosive(name);
  const Section section(prm, "Custom explosive");
  CustomExplosive custom;
  custom.parse_parameters(prm, "Material/Custom explosive");
  return custom.explosive;
}


void check_afterburn(const Explosive &explosive,
                     const double energy,
                     const std::string &entry)
{
  constexpr double least = 1e4;
  const double most = explosive.afterburn.largest;
  if (energy == 0. || energy == explosive.afterburn.energy ||
      (energy >= least && energy <= most))
    return;
  throw InputError(entry + " = " + brief(energy) + " J/kg: the products of " +
                   explosive.title + " release at most " + brief(most) +
                   " J/kg when all of them burn in air; allowed: 0 for none" +
                   (most < least ? ""
                                 : ", or a number from " + brief(least) +
                                     " to " + brief(most)));
}
} // namespace contrecoup
