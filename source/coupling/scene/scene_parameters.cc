// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/new_tissues.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/anatomy_parameters.h>
#include <contrecoup/coupling/application/biomechanics_application.h>
#include <contrecoup/coupling/application/blast_application.h>
#include <contrecoup/coupling/scene/scene_parameters.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/materials/custom_explosive.h>
#include <contrecoup/materials/tissue_library.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace contrecoup::coupling
{
const std::vector<SceneParameters::Accuracy> SceneParameters::accuracies = {
  {"first look",
   2,
   2,
   10.,
   0.01,
   "cells of at most 40 mm, 10 for the positive phase at the body, 10 mm "
   "elements"},
  {"fast", 3, 3, 20., 0.01, "20 mm, 20, 10 mm"},
  {"balanced", 4, 3, 40., 0.005, "10 mm, 40, 5 mm"},
  {"accurate", 5, 3, 80., 0.005, "5 mm, 80, 5 mm"},
  {"finest", 6, 3, 160., 0.0025, "2.5 mm, 160, 2.5 mm"}};


namespace
{
  void declare_accuracy(ParameterHandler &prm)
  {
    std::vector<std::string> names;
    std::string costs;
    for (const auto &accuracy : SceneParameters::accuracies)
    {
      names.push_back(accuracy.name);
      costs +=
        (costs.empty() ? "" : "; ") + accuracy.name + ": " + accuracy.cost;
    }
    declare_selection(prm,
                      "Accuracy",
                      "fast",
                      names,
                      "Sizes of the gas's cells at the skin and of the body's "
                      "elements (" +
                        costs + "); finer ones cost more and err less.");
    declare_double(prm,
                   "Cell size",
                   "0",
                   0.,
                   0.16,
                   "m",
                   "Largest edge of the gas's cells at the skin, which is 160 "
                   "mm over a power of two; 0: by accuracy, positive "
                   "phase and the body's shortest side.");
    declare_double(
      prm,
      "Element size",
      "0",
      0.,
      1.,
      "m",
      used_with("Body/Kind not mesh",
                "Edge of the body's elements; 0: that of the accuracy, but "
                "at most a sixtieth of the body's longest side."));
  }


  void declare_scene(ParameterHandler &prm)
  {
    const Section section(prm, "Scene");
    declare_string(prm, "Title", "", "Title of the report.");
    declare_selection(
      prm,
      "Question",
      "injury",
      {"loads", "injury"},
      "Result of the scene: the pressure on the body's skin only, "
      "or the response of the body as well.");
    declare_accuracy(prm);
    declare_double(prm,
                   "End time",
                   "0.012",
                   1e-9,
                   1.,
                   "s",
                   "End time of the scene since the detonation, above 0.");
    declare_selection(
      prm,
      "Symmetry",
      "auto",
      {"auto", "none", "y"},
      "Whether the gas is computed on one side of the plane "
      "y = 0 alone; auto: where body, charge and sides allow it.");
    declare_bool(prm,
                 "Forecast",
                 "true",
                 "Whether time, memory and disk of each stage are predicted "
                 "by trial runs of some seconds, with --check and before the "
                 "first stage begins.");
    declare_bool(prm,
                 "Error estimate",
                 "true",
                 "Whether a second run with cells of twice the size and "
                 "elements of 5/3 of the size follows, whose differences "
                 "estimate the numerical error of each measure; it takes "
                 "about a seventh of the processor time.");
    declare_bool(
      prm, "Report", "true", "Whether report.html is made at the end.");
  }


  std::string with_unit(const double value, const std::string &unit)
  {
    return brief(value) + (unit == "-" ? "" : " " + unit);
  }

  constexpr double smallest_cell = 0.16 / 1024.; // [m]
  /// Least elements of the preset along the body's longest side. With 25, as of
  /// 10 mm in a head of 250 mm, hourglass modes of one point of integration
  /// store 38 % of the energy.
  constexpr double least_elements = 60.;
  const std::string usual_afterburn = "by explosive";

  /// The usual energy of each explosive, as text.
  std::string usual_afterburns()
  {
    std::string text;
    for (const Explosive &explosive : explosive_library())
      text += (text.empty() ? "" : ", ") + explosive.title + " " +
              brief(explosive.afterburn.energy, 2) + " of " +
              brief(explosive.afterburn.largest, 2);
    return text + " J/kg of complete combustion";
  }


  /// Energy of afterburn by the entry [J/kg]; nothing: by explosive.
  std::optional<double> read_afterburn(const ParameterHandler &prm)
  {
    const std::string text = prm.get("Afterburn energy");
    if (text == usual_afterburn)
      return {};
    const dealii::Patterns::Double allowed(0., bounds::specific_energy);
    if (!allowed.match(text))
      throw InputError("entry \"Charge/Afterburn energy\" cannot be \"" + text +
                       "\"; allowed: " + usual_afterburn +
                       ", or a number from 0 to " +
                       brief(bounds::specific_energy) + " [J/kg]");
    return dealii::Utilities::string_to_double(text);
  }


  const std::string custom_section = "Custom explosive";

  /// Refuses values in other units: explosives have some MJ/kg.
  void require_explosive_energy(const JwlParameters &jwl,
                                const std::string &path)
  {
    constexpr double least = 3e5, most = 3e7; // [J/kg]
    const double energy = jwl.energy_density / jwl.reference_density;
    if (!(energy >= least && energy <= most))
      throw InputError(
        path + ": Energy density = " + brief(jwl.energy_density) +
        " J/m^3 over Density = " + brief(jwl.reference_density) +
        " kg/m^3 is " + brief(energy, 3) + " J/kg; allowed are " +
        brief(least) + " to " + brief(most) + " J/kg");
  }


  /// Entry for the TNT equivalence of a custom explosive.
  void declare_equivalence(ParameterHandler &prm,
                           const std::string &quantity,
                           const std::string &also)
  {
    declare_list(prm,
                 "TNT equivalence of " + quantity,
                 "",
                 0,
                 1,
                 1e-3,
                 100.,
                 "-",
                 "Mass of TNT that gives the same " + quantity + " and " +
                   also +
                   ", per mass of explosive; empty: that of Like if both have "
                   "the same energy per mass, else the ratio of energies.");
  }

  void declare_custom(ParameterHandler &prm)
  {
    declare_string(
      prm, "Name", "custom", "Name of the explosive in plan and report.");
    CustomExplosive::declare_parameters(prm);
    declare_equivalence(prm, "pressure", "arrival");
    declare_equivalence(prm, "impulse", "duration");
  }


  void declare_charge(ParameterHandler &prm)
  {
    const Section section(prm, "Charge");
    std::vector<std::string> explosives = explosive_names();
    explosives.push_back("custom");
    declare_selection(prm,
                      "Explosive",
                      "tnt",
                      explosives,
                      "Name in the library of explosives, or custom: that of "
                      "subsection Custom explosive.");
    declare_double(
      prm, "Mass", "1", 1e-9, bounds::mass, "kg", "Of the sphere, above 0.");
    declare_string(prm,
                   "Afterburn energy",
                   usual_afterburn,
                   "Energy per mass that the products release by afterburn, at "
                   "Miller's rate [J/kg, 1e4 to " +
                     brief(bounds::specific_energy) +
                     "]; 0: none; by explosive: " + usual_afterburns() + ".");
    declare_double(
      prm,
      "Distance",
      "2",
      1e-9,
      1e3,
      "m",
      used_with("Charge/Place = empty",
                "Distance from the body's surface along +x to the charge's "
                "centre; from the nearest point of the body if that line "
                "misses it; above 0."));
    declare_double(
      prm,
      "Height",
      "1",
      1e-9,
      1e3,
      "m",
      used_with("Charge/Place = empty",
                "Height of the centre above the ground z = 0, above 0."));
    declare_points(prm,
                   "Place",
                   "",
                   "m",
                   "Centre of the charge x, y, z, instead of Distance and "
                   "Height; empty: from these two.");
    const Section custom(prm, custom_section);
    const UsedWith used("Charge/Explosive = custom");
    declare_custom(prm);
  }


  void declare_tasks(ParameterHandler &prm)
  {
    {
      const Section section(prm, "Anatomy");
      AnatomyParameters::declare_parameters(prm);
    }
    const auto declare = [&](const std::string &name,
                             const io::ApplicationDescription &application) {
      const Section section(prm, name);
      TimeParameters::declare_parameters(prm);
      application.declare_parameters(prm);
    };
    declare("Blast", blast_application());
    declare("Biomechanics", biomechanics_application());
  }
} // namespace


void SceneParameters::declare_parameters(ParameterHandler &prm)
{
  declare_own(prm);
  declare_tasks(prm);
}


bool SceneParameters::is_stage(const std::string &section)
{
  return section == "Anatomy" || section == "Blast" ||
         section == "Biomechanics";
}


bool SceneParameters::is_of_stage(const Assignment &assignment)
{
  return !assignment.sections.empty() && is_stage(assignment.sections[0]);
}


void SceneParameters::declare_own(ParameterHandler &prm)
{
  declare_scene(prm);
  declare_charge(prm);
  {
    const Section section(prm, "Body");
    BodyDescription::declare_parameters(prm);
  }
  {
    const Section section(prm, "Tissues");
    declare_selection(prm,
                      "Set",
                      "paper with aerated lung",
                      tissue_set_names(),
                      "Set of the tissue library. The paper's own lung has a "
                      "constant bulk modulus of 42 kPa and is crushed by "
                      "blasts that injure.");
    OwnTissues::declare_parameters(prm);
  }
  const Section section(prm, "Injury");
  OwnThresholds::declare_parameters(prm);
}


void SceneParameters::parse_parameters(ParameterHandler &prm)
{
  changes.clear();
  parse_scene(prm);
  parse_charge(prm);
  parse_tissues(prm);
  parse_thresholds(prm);
  const Section blast(prm, "Blast");
  const Section probes(prm, "Probes");
  std::map<std::string, std::string> entries;
  for (const std::string entry : {"Points", "Lines", "Gauge planes"})
    entries["Probes/" + entry] = prm.get(entry);
  gauges = find_gauges(entries);
}


void SceneParameters::parse_tissues(ParameterHandler &prm)
{
  own_tissues = read_own_tissues(prm);
  const Section section(prm, "Tissues");
  tissues = prm.get("Set");
  for (const Tissue tissue : own_tissues.tissues())
    for (const OwnTissues::Change &change : own_tissues.changes(
           tissue,
           is_new(tissue) ? SolidMaterial()
                          : find_solid_material(tissues, tissue, {})))
      changes.push_back(
        {"Tissues/Tissue " + name_of(tissue) + "/" + change.entry,
         with_unit(change.value, change.unit),
         change.before ? with_unit(*change.before, change.unit)
                       : "none, a new tissue"});
}


void SceneParameters::parse_thresholds(ParameterHandler &prm)
{
  own_thresholds.parse_parameters(prm, "Injury");
  for (const std::string &measure : own_thresholds.measures())
    changes.push_back({own_thresholds.path(measure) + "/Thresholds",
                       own_thresholds.criterion(measure).in_words(),
                       injury_criterion(measure).in_words()});
}


void SceneParameters::parse_scene(ParameterHandler &prm)
{
  const Section section(prm, "Scene");
  title = prm.get("Title");
  question = prm.get("Question");
  const std::string name = prm.get("Accuracy");
  accuracy = *std::find_if(accuracies.begin(),
                           accuracies.end(),
                           [&](const Accuracy &a) { return a.name == name; });
  element_size = read_double(prm, "Element size");
  cell_size = read_double(prm, "Cell size");
  if (cell_size > 0. && cell_size < smallest_cell)
    throw InputError("Scene/Cell size cannot be " + brief(cell_size) +
                     " m: 0 or at least " + brief(smallest_cell) + " m");
  end_time = read_double(prm, "End time");
  symmetry = prm.get("Symmetry");
  has_forecast = prm.get_bool("Forecast");
  draws_report = prm.get_bool("Report");
  estimates_error = prm.get_bool("Error estimate");
}


void SceneParameters::parse_charge(ParameterHandler &prm)
{
  const Section section(prm, "Charge");
  parse_explosive(prm);
  mass = read_double(prm, "Mass");
  const std::optional<double> energy = read_afterburn(prm);
  if (energy)
    check_afterburn(explosive, *energy, "Charge/Afterburn energy");
  has_usual_afterburn = !energy;
  afterburn = energy.value_or(explosive.afterburn.energy);
  distance = read_double(prm, "Distance");
  height = read_double(prm, "Height");
  const auto places = read_points<3>(prm, "Place");
  if (places.size() > 1)
    throw InputError("Charge/Place: one place is wanted, " +
                     std::to_string(places.size()) + " are given");
  if (!places.empty())
    place = places[0];
  if (place && (*place)[2] <= 0.)
    throw InputError("Charge/Place: its height, the third number, must be "
                     "above 0, the ground");
}


void SceneParameters::parse_explosive(ParameterHandler &prm)
{
  const std::string chosen = prm.get("Explosive");
  const std::string path = "Charge/" + custom_section;
  if (chosen != "custom")
  {
    explosive = find_explosive(chosen);
    return;
  }
  const Section section(prm, custom_section);
  CustomExplosive custom;
  custom.parse_parameters(prm, path);
  const auto pressure = read_list(prm, "TNT equivalence of pressure");
  const auto impulse = read_list(prm, "TNT equivalence of impulse");
  explosive = custom.explosive;
  explosive.name = explosive.title = prm.get("Name");
  if (explosive.name.empty())
    throw InputError(path + "/Name is empty");
  require_explosive_energy(explosive.jwl, path);
  custom_entries = {{"Like", custom.like}};
  for (const std::string &entry : CustomExplosive::entry_names())
    if (!custom.changes.empty() && !prm.get(entry).empty())
      custom_entries.emplace_back(entry, prm.get(entry));
  for (const CustomExplosive::Change &change : custom.changes)
    changes.push_back({path + "/" + change.entry,
                       with_unit(change.value, change.unit),
                       with_unit(change.before, change.unit)});
  const auto take = [&](const std::vector<double> &given,
                        const std::string &quantity,
                        double &value) {
    if (given.empty() || given[0] == value)
      return;
    changes.push_back({path + "/TNT equivalence of " + quantity,
                       brief(given[0]),
                       brief(value) + ", " + explosive.tnt.source});
    value = given[0];
  };
  TntEquivalence tnt = explosive.tnt;
  take(pressure, "pressure", tnt.pressure);
  take(impulse, "impulse", tnt.impulse);
  if (!pressure.empty() && !impulse.empty())
    tnt = {tnt.pressure, tnt.impulse, true, "given in " + path};
  else if (!pressure.empty() || !impulse.empty())
    tnt.source += ", partly given in " + path;
  explosive.tnt = tnt;
}


double SceneParameters::energy() const
{
  const JwlParameters &jwl = explosive.jwl;
  return mass * (jwl.energy_density / jwl.reference_density + afterburn);
}


void SceneParameters::fit_elements(const dealii::BoundingBox<3> &body)
{
  if (element_size > 0.)
    return;
  const double longest =
    std::max({body.side_length(0), body.side_length(1), body.side_length(2)});
  // To a tenth of a millimetre, downwards.
  const double fitting = 1e-4 * std::floor(1e4 * longest / least_elements);
  element_size = std::min(accuracy.element_size, std::max(1e-4, fitting));
}
} // namespace contrecoup::coupling
