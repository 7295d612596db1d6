// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/model_bias.h>
#include <contrecoup/coupling/scene/coarser_run.h>
#include <contrecoup/coupling/scene/stage_results.h>
#include <contrecoup/coupling/scene/table_comparison.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

namespace contrecoup::coupling
{
namespace
{
  /// Scatter of measurements about the tables. With an equivalence that was not
  /// measured it is larger: published ones of the same explosive differ by 20
  /// to 30 % of its mass, which changes the peak by a fifth.
  constexpr double scatter = 0.1, scatter_of_estimate = 0.2;

  /// Order of convergence by which the coarser run estimates errors.
  constexpr double order = 0.7;

  double error_of_tables(const SceneParameters &scene)
  {
    return scene.explosive.tnt.is_published ? scatter : scatter_of_estimate;
  }


  std::string read_if_any(const std::string &file)
  {
    return std::filesystem::exists(file) ? io::read_file(file) : "";
  }


  /// An injury at the first probe; NaN: none.
  double injury_of(const std::string &folder, const std::string &measure)
  {
    const std::string table = read_if_any(folder + "/probe_injury.csv");
    const std::string beginning = "\n" + measure + "," + first_probe + ",";
    const std::size_t place = table.find(beginning);
    return place == std::string::npos
             ? unknown
             : std::strtod(table.c_str() + place + beginning.size(), nullptr);
  }


  /// Relative numerical error by both runs, not below a least one, as they can
  /// agree by chance.
  double error_of(const double fine, const double coarse)
  {
    constexpr double least = 0.02;
    const double error = std::abs(coarse / fine - 1.) /
                         (std::pow(CoarserRun::cell_ratio, order) - 1.);
    return error < least ? least : error;
  }


  /// Error of a result of a gauge on the skin by both runs, at least the median
  /// over all gauges; NaN where a run ends before the phase that an impulse
  /// needs. @param folder of the scene
  double error_on_skin(const std::string &folder,
                       const std::string &name_of_gauge,
                       const std::string &result)
  {
    const auto fine = stage_results(folder + "/blast"),
               coarse = stage_results(folder + "/coarser_blast");
    std::vector<double> errors;
    double own = unknown;
    for (const auto &[name, value] : fine)
    {
      const std::size_t end =
        name.size() - std::min(name.size(), result.size());
      const std::string gauge = name.substr(0, end);
      if (gauge.rfind("loads_", 0) != 0 || gauge + result != name ||
          coarse.count(name) == 0 ||
          (result == "impulse" &&
           fine.count(gauge + "cut_off") + coarse.count(gauge + "cut_off") > 0))
        continue;
      errors.push_back(error_of(value, coarse.at(name)));
      if (gauge == name_of_gauge)
        own = errors.back();
    }
    std::sort(errors.begin(), errors.end());
    const std::size_t n = errors.size();
    // A NaN stays one.
    return n == 0 ? own
                  : std::max(own, 0.5 * (errors[(n - 1) / 2] + errors[n / 2]));
  }


  /// Compares a quantity whose numerical error is at least @p least_error.
  /// @p may_exceed, @p may_be_less: whether what the tables leave out explains
  /// a difference.
  ComparedQuantity compare(const std::string &name,
                           const std::string &unit,
                           const std::pair<double, double> &fine_and_coarse,
                           const std::pair<double, double> &tables_and_error,
                           const double least_error,
                           const bool may_exceed,
                           const bool may_be_less)
  {
    const auto [run, coarse] = fine_and_coarse;
    const auto [tables, error] = tables_and_error;
    const double difference = error_of(run, coarse);
    const double least = std::fmax(difference, least_error);
    const double allowed = error * tables + std::fmax(least * run, 0.);
    return {name,
            unit,
            run,
            std::isfinite(difference) ? least : unknown,
            tables,
            error,
            std::abs(run - tables) > allowed &&
              !(run > tables ? may_exceed : may_be_less)};
  }


  bool is_of_injury(const std::string &name)
  {
    return name == "lung_lethality" || name == "lung_exposure" ||
           name == "eardrum_rupture";
  }


  constexpr const char *largest_peak = "largest peak";

  /// A quantity at the first probe, of peaks that of the first wave, as the
  /// tables have it, or largest_peak; NaN: none.
  double value_of(const std::string &folder, const std::string &name)
  {
    if (is_of_injury(name))
      return injury_of(folder, name);
    return stage_result(folder,
                        "probe_1_" +
                          (name == "peak_overpressure" ? "first_" + name
                           : name == largest_peak      ? "peak_overpressure"
                                                       : name));
  }


  /// Whether a reflection comes to the probe after the incident wave: a wave
  /// that is larger than that comes in its time.
  bool comes_later(const Reflection &reflection, const std::string &folder)
  {
    const double delay = stage_result(folder, "probe_1_later_peak_time") -
                         value_of(folder, "arrival");
    return stage_result(folder, "probe_1_later_peak_overpressure") >
             value_of(folder, "peak_overpressure") &&
           delay >= reflection.least_delay && delay <= reflection.largest_delay;
  }


  /// Whether the first probe has the wave of the answer: it may be elsewhere by
  /// the user's entry.
  bool is_beside_body(const TableAnswer &answer, const std::string &folder)
  {
    const double reference =
      stage_result(folder, "probe_1_reference_peak_overpressure");
    return std::abs(reference / answer.in_the_open.overpressure - 1.) < 1e-3;
  }


  bool has_merged(const std::vector<Reflection> &reflections)
  {
    return std::any_of(reflections.begin(),
                       reflections.end(),
                       [](const Reflection &one) { return one.merges; });
  }


  /// Least duration of a wave that has merged with its reflection, by the
  /// tables those of a charge on the ground: near the charge it is shorter [s].
  double least_merged_duration(const SceneParameters &scene,
                               const double distance)
  {
    const IncidentWave merged(
      scene.explosive.tnt, scene.mass, scene.energy(), true);
    return (1. - error_of_tables(scene)) *
           merged.value(BlastQuantity::duration, distance);
  }


  /// Judges probabilities by the loads from which they follow; one that reads
  /// the same for both does not differ.
  /// @param ears_differ whether the load on eardrums does
  void judge_probabilities(const bool ears_differ,
                           std::vector<ComparedQuantity> &list)
  {
    const bool lungs_differ =
      std::any_of(list.begin(), list.end(), [](const ComparedQuantity &load) {
        return load.name == "lung_exposure" && load.differs;
      });
    for (ComparedQuantity &one : list)
    {
      const bool is_of_ears = one.name == "eardrum_rupture";
      if (!is_of_ears && one.name != "lung_lethality")
        continue;
      one.run_error = one.tables_error = unknown;
      one.differs = (is_of_ears ? ears_differ : lungs_differ) &&
                    percent(one.run) != percent(one.tables);
    }
  }


  /// Largest rise of the impulse at the probe by reflections that come later,
  /// by the tables: the ground and walls send no more than a charge in their
  /// place would on a wall, the body what a rigid cylinder of its width
  /// scatters back (amplitude sqrt(a / 2 r) at the distance r from its axis, by
  /// geometrical acoustics) of what a wall would; infinite where the tables
  /// end.
  double largest_rise(const SceneParameters &scene,
                      const SceneLayout &layout,
                      const std::vector<ChosenSide> &sides)
  {
    const IncidentWave wave = layout.incident_wave(scene);
    const auto impulse = [&](const double way) {
      return wave.value(BlastQuantity::impulse, way);
    };
    const double of_wall =
      wave.value(BlastQuantity::reflected_impulse, layout.distance) /
        impulse(layout.distance) -
      1.;
    const double radius =
      0.5 * std::max(layout.body.side_length(0), layout.body.side_length(1));
    const double gap =
      layout.probe->distance(nearest_place(layout.body, *layout.probe));
    double rise = std::sqrt(0.5 * radius / (radius + gap));
    for (const ReflectingPlane &plane : reflecting_planes(layout, sides))
      rise += impulse(plane.image(layout.charge).distance(*layout.probe)) /
              impulse(layout.distance);
    return std::isfinite(rise * of_wall) ? rise * of_wall
                                         : std::numeric_limits<double>::max();
  }


  /// Whether a rise explains an impulse of the run, within the errors of both.
  bool explains(const double rise,
                const std::pair<double, double> &fine_and_coarse,
                const std::pair<double, double> &tables_and_error)
  {
    const auto [run, coarse] = fine_and_coarse;
    const auto [tables, error] = tables_and_error;
    return run * (1. - std::fmax(error_of(run, coarse), 0.)) <=
           (1. + rise + error) * tables;
  }


  std::string words_of(const ComparedQuantity &one)
  {
    static const std::vector<std::pair<std::string, std::string>> titles{
      {"peak_overpressure", "incident peak"},
      {"impulse", "impulse"},
      {"duration", "duration"},
      {"arrival", "arrival"},
      {"reflected_overpressure", "reflected peak"},
      {"lung_exposure", "lung load in the open over that which kills half"},
      {"lung_lethality", "death by lung injury in the open"},
      {"eardrum_rupture", "eardrum rupture in the open"}};
    std::string title;
    for (const auto &[name, words] : titles)
      if (one.name == name)
        title = words;
    if (title.empty())
      return "";
    const bool is_load = one.name == "lung_exposure";
    // Probabilities follow from the others and have no error of their own.
    const bool has_error = is_load || one.unit != "-";
    const auto text = [&](const double value) {
      if (is_load)
        return brief(value, 3);
      if (one.unit == "-")
        return percent(value);
      return one.unit == "Pa" ? brief(1e-3 * value, 3) + " kPa"
                              : brief(value, 3) + " " + one.unit;
    };
    return title + (one.is_cut ? " at least " : " ") + text(one.run) +
           (!has_error ? ""
            : std::isfinite(one.run_error)
              ? " (numerical error " + brief(100. * one.run_error, 2) + " %)"
              : " (numerical error unknown)") +
           " against " + text(one.tables);
  }
} // namespace


std::vector<Reflection>
reflections_at_probe(const SceneParameters &scene,
                     const SceneLayout &layout,
                     const std::vector<ChosenSide> &sides,
                     const std::string &folder)
{
  if (!layout.probe)
    return {};
  auto all = reflections_at(scene, layout, sides, *layout.probe);
  for (Reflection &one : all)
    one.merges = one.merges && !comes_later(one, folder + "/blast");
  return all;
}


std::vector<ComparedQuantity>
compare_with_tables(const SceneParameters &scene,
                    const SceneLayout &layout,
                    const double body_mass,
                    const std::string &folder,
                    const bool has_coarser_run,
                    const std::vector<ChosenSide> &sides)
{
  const auto answer = table_answer(scene, layout, body_mass);
  const std::string fine = folder + "/blast";
  if (!answer || !layout.probe || !is_beside_body(*answer, fine))
    return {};
  const double error = error_of_tables(scene);
  const auto values = [&](const std::string &name) {
    return std::pair<double, double>(
      value_of(fine, name),
      has_coarser_run ? value_of(folder + "/coarser_blast", name) : unknown);
  };
  // A merged wave is that of a stronger charge, and earlier.
  const bool merges =
    has_merged(reflections_at_probe(scene, layout, sides, folder));
  // Reflections may add to the largest peak.
  const ComparedQuantity largest =
    compare(largest_peak,
            "Pa",
            values(largest_peak),
            {answer->in_the_open.overpressure, error},
            unknown,
            merges || value_of(fine, largest_peak) >
                        value_of(fine, "peak_overpressure"),
            false);
  const bool is_cut = stage_result(fine, "probe_1_cut_off") > 0.;
  std::vector<ComparedQuantity> list;
  const auto add = [&](const std::string &name,
                       const std::string &unit,
                       const double tables,
                       const bool may_exceed,
                       const bool may_be_less = false) {
    if (!std::isfinite(value_of(fine, name)))
      return;
    // Errors of peak and duration can cancel in what follows from both.
    list.push_back(
      compare(name,
              unit,
              values(name),
              {tables, error},
              name == "lung_exposure" ? largest.run_error : unknown,
              may_exceed,
              may_be_less));
    list.back().is_cut = is_cut && (name == "impulse" || name == "duration");
  };
  add("peak_overpressure", "Pa", answer->in_the_open.overpressure, merges);
  const bool may_add = explains(largest_rise(scene, layout, sides),
                                values("impulse"),
                                {answer->impulse, error});
  add("impulse", "Pa s", answer->impulse, may_add, is_cut);
  const bool may_be_short =
    is_cut || (merges && value_of(fine, "duration") >=
                           least_merged_duration(scene, layout.distance));
  add("duration", "s", answer->duration, may_add, may_be_short);
  add("arrival", "s", answer->arrival, false, merges);
  add("lung_exposure", "-", answer->in_the_open.lung_exposure, may_add);
  add("lung_lethality", "-", answer->in_the_open.lung_lethality, true);
  add("eardrum_rupture", "-", answer->in_the_open.eardrum_rupture, true);
  judge_probabilities(largest.differs, list);
  return list;
}


std::vector<ComparedQuantity>
compare_skin_with_tables(const SceneParameters &scene,
                         const SceneLayout &layout,
                         const Landmark &gauge,
                         const std::string &folder,
                         const bool has_coarser_run,
                         const std::vector<ChosenSide> &sides)
{
  // Farther away, the skin may be turned from the charge.
  constexpr double nearly = 1.05;
  const double distance = gauge.place.distance(layout.charge);
  const IncidentWave wave = layout.incident_wave(scene);
  if (layout.probe || distance > nearly * layout.distance ||
      !wave.is_tabulated(distance))
    return {};
  std::string name = "loads_" + gauge.name + "_";
  std::replace(name.begin(), name.end(), ' ', '_');
  std::vector<ComparedQuantity> list;
  const auto add = [&](const std::string &quantity,
                       const std::string &unit,
                       const std::string &result,
                       const double tables,
                       const bool may_exceed,
                       const bool may_be_less) {
    const double run = stage_result(folder + "/blast", name + result);
    if (!std::isfinite(run) || !std::isfinite(tables))
      return;
    const double least_error =
      has_coarser_run ? error_on_skin(folder, name, result) : unknown;
    const double coarse =
      stage_result(folder + "/coarser_blast", name + result);
    list.push_back(compare(quantity,
                           unit,
                           {run, std::isfinite(least_error) ? coarse : unknown},
                           {tables, error_of_tables(scene)},
                           least_error,
                           may_exceed,
                           may_be_less));
    list.back().place = gauge.name;
    list.back().is_cut = result == "impulse" &&
                         stage_result(folder + "/blast", name + "cut_off") > 0.;
  };
  const bool merges =
    has_merged(reflections_at(scene, layout, sides, gauge.place));
  // Later waves may be larger.
  add("reflected_overpressure",
      "Pa",
      "first_peak",
      wave.value(BlastQuantity::reflected_overpressure, distance),
      merges,
      false);
  // Later reflections add to it, and the edges of a body relieve it.
  add("reflected_impulse",
      "Pa s",
      "impulse",
      wave.value(BlastQuantity::reflected_impulse, distance),
      true,
      true);
  add("arrival",
      "s",
      "arrival",
      wave.value(BlastQuantity::arrival, distance),
      false,
      merges);
  return list;
}


std::string warning_of(const std::vector<ComparedQuantity> &compared,
                       const Explosive &explosive,
                       const bool has_open_reflection)
{
  std::vector<std::string> parts;
  for (const ComparedQuantity &one : compared)
    if (one.differs && !words_of(one).empty())
      parts.push_back(words_of(one));
  if (parts.empty())
    return "";
  const std::string equivalence = equivalence_in_words(explosive);
  const std::string &place = compared.front().place;
  return "WARNING: " +
         (place == first_probe ? "beside the body" : "at the " + place) +
         ", run and tables of Kingery and Bulmash" +
         (equivalence.empty() ? "" : " (" + equivalence + ")") +
         " differ by more than what is known of their errors: " +
         join(parts, "; ") +
         (has_open_reflection
            ? "; what open sides send back (reflection) may be the cause"
            : "");
}
} // namespace contrecoup::coupling
