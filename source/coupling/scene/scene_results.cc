// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/coupling/application/body_report.h>
#include <contrecoup/coupling/scene/coarser_run.h>
#include <contrecoup/coupling/scene/scene_plan.h>
#include <contrecoup/coupling/scene/scene_results.h>
#include <contrecoup/coupling/scene/table_comparison.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/run/plan_table.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace contrecoup::coupling
{
namespace
{
  io::Json list(const dealii::Point<3> &point)
  {
    return {point[0], point[1], point[2]};
  }


  /// Value with its unit as text; "unknown" if not finite.
  std::string value_text(const double value, const std::string &unit)
  {
    return std::isfinite(value)
             ? brief(value, 3) + (unit == "-" ? "" : " " + unit)
             : "unknown";
  }


  io::Json plan_rows(const std::vector<Assumption> &plan)
  {
    io::Json rows = io::Json::array();
    for (const Assumption &item : plan)
      rows.push_back({{"item", item.name},
                      {"decision", item.decision},
                      {"quantity", item.quantity},
                      {"estimate", value_text(item.value, item.unit)},
                      {"entry", item.entry}});
    return rows;
  }


  io::Json audit_rows(const std::vector<Assumption> &plan,
                      const std::vector<Assumption> &audit)
  {
    io::Json rows = io::Json::array();
    for (const Assumption &item : audit)
    {
      const Assumption *planned = io::find_assumption(plan, item.name);
      const std::optional<bool> keeps = io::holds(item, planned);
      io::Json row = {
        {"item", item.name},
        {"decision", item.decision},
        {"quantity", item.quantity},
        {"estimate",
         planned ? value_text(planned->value, item.unit) : "unknown"},
        {"found", value_text(item.value, item.unit)},
        {"limit",
         std::isnan(item.limit)
           ? ""
           : (item.is_lower_limit ? "at least " : "at most ") +
               value_text(item.limit, item.unit)},
        {"holds", keeps ? io::Json(*keeps) : io::Json(nullptr)},
        {"entry", item.entry}};
      rows.push_back(row);
    }
    return rows;
  }


  /// Warnings in the summary of a stage.
  io::Json warnings_of(const SceneTask &task)
  {
    const io::Json summary =
      io::read_json(task.folder() + "/summary.json", io::formats::summary);
    return summary.is_object() && summary.contains("warnings")
             ? summary["warnings"]
             : io::Json::array();
  }


  /// Cost of a stage; null if it has not run.
  io::Json cost(const double value)
  {
    return value > 0. ? io::Json(value) : io::Json();
  }


  io::Json task_rows(const std::vector<SceneTask> &tasks,
                     const std::vector<std::string> &reused)
  {
    io::Json rows = io::Json::array();
    for (const SceneTask &task : tasks)
    {
      const TaskRecord &record = task.record();
      const bool is_reused =
        std::find(reused.begin(), reused.end(), task.name()) != reused.end();
      rows.push_back({{"name", task.name()},
                      {"status", is_reused ? "reused" : record.status},
                      {"folder", task.name()},
                      {"wall_seconds", cost(record.wall_seconds)},
                      {"core_seconds", cost(record.core_seconds)},
                      {"peak_memory", cost(record.peak_memory)},
                      {"disk", cost(record.disk)},
                      {"warnings", warnings_of(task)},
                      {"hash", record.key}});
    }
    return rows;
  }


  bool is_finished(const std::vector<SceneTask> &tasks, const std::string &name)
  {
    return std::any_of(tasks.begin(), tasks.end(), [&](const SceneTask &task) {
      return task.name() == name && task.is_finished();
    });
  }


  /// Sizes of cells and elements of the coarser run over those of the scene;
  /// null where it was not made.
  io::Json coarser_run_of(const std::vector<SceneTask> &tasks)
  {
    if (!is_finished(tasks, "coarser_blast"))
      return nullptr;
    io::Json json = {{"cell_ratio", CoarserRun::cell_ratio},
                     {"element_ratio", nullptr}};
    if (is_finished(tasks, "coarser_biomechanics"))
      json["element_ratio"] = CoarserRun::element_ratio;
    return json;
  }


  /// Replaces the entries named in @p items of the blast's plan by those of
  /// the scene.
  std::vector<Assumption> named(std::vector<Assumption> items,
                                const std::vector<SceneTask> &tasks)
  {
    const std::string section = "Blast/";
    for (const SceneTask &task : tasks)
      if (task.name() == "blast")
        for (Assumption &item : items)
          if (item.entry.compare(0, section.size(), section) == 0)
          {
            const std::string entry = item.entry.substr(section.size());
            const std::string name = task.description().words(entry);
            if (name != entry)
              item.entry = name;
          }
    return items;
  }


  io::Json place_rows(const std::vector<TissuePlace> &places)
  {
    io::Json rows = io::Json::array();
    for (const TissuePlace &place : places)
      rows.push_back({{"name", place.name}, {"place", list(place.place)}});
    return rows;
  }


  /// A number; null if it is not known.
  io::Json number(const double value)
  {
    return std::isfinite(value) ? io::Json(value) : io::Json();
  }


  io::Json person_of(const Person &person)
  {
    io::Json json = {{"description", person.description()},
                     {"length", person.length()},
                     {"mass", person.mass()}};
    if (!person.axes())
      return json;
    const auto direction = [](const dealii::Tensor<1, 3> &axis) {
      return list(dealii::Point<3>(axis));
    };
    json["posture"] = person.posture();
    json["forward"] = direction(person.axes()->forward);
    json["left"] = direction(person.axes()->left);
    json["up"] = direction(person.axes()->up);
    json["side_to_charge"] = person.side_to_charge();
    json["charge_azimuth"] = person.charge_azimuth();
    json["charge_elevation"] = person.charge_elevation();
    return json;
  }


  io::Json effect_of(const TableAnswer::Effect &effect)
  {
    return {{"overpressure", effect.overpressure},
            {"eardrum_rupture", effect.eardrum_rupture},
            {"lung_exposure", effect.lung_exposure},
            {"lung_lethality", effect.lung_lethality}};
  }


  /// The answer of the tables at a place that is farther from the charge than
  /// the nearest skin; null without such a place.
  io::Json answer_at(const PlannedScene &scene,
                     const std::optional<SceneLayout> &there)
  {
    if (!there)
      return {};
    const auto answer =
      table_answer(scene.parameters(), *there, scene.person_mass());
    return {
      {"distance", there->distance},
      {"in_the_open", answer ? effect_of(answer->in_the_open) : io::Json()},
      {"before_a_wall", answer ? effect_of(answer->before_a_wall) : io::Json()},
      {"along_body", answer ? effect_of(answer->along_body) : io::Json()}};
  }


  /// The answer of the tables, null where they have none, that at the trunk if
  /// its skin tells of the lungs and at the ears, and the equivalence by which
  /// they are entered.
  io::Json tables_of(const PlannedScene &scene)
  {
    const TntEquivalence &tnt = scene.parameters().explosive.tnt;
    io::Json json = {
      {"equivalence_of_pressure", tnt.pressure},
      {"equivalence_of_impulse", tnt.impulse},
      {"is_published", tnt.is_published},
      {"source", tnt.source},
      {"burst", IncidentWave::tables_for(scene.layout().is_surface_burst)},
      {"body_mass", scene.person_mass()},
      {"answer", nullptr},
      {"trunk", answer_at(scene, scene.layout_at_trunk())},
      {"ears", answer_at(scene, scene.layout_at_ears())}};
    if (const auto answer =
          table_answer(scene.parameters(), scene.layout(), scene.person_mass()))
      json["answer"] = {{"arrival", answer->arrival},
                        {"impulse", answer->impulse},
                        {"duration", answer->duration},
                        {"in_the_open", effect_of(answer->in_the_open)},
                        {"before_a_wall", effect_of(answer->before_a_wall)},
                        {"along_body", effect_of(answer->along_body)}};
    return json;
  }


  io::Json comparison_rows(const std::vector<ComparedQuantity> &compared)
  {
    io::Json rows = io::Json::array();
    for (const ComparedQuantity &one : compared)
      rows.push_back({{"name", one.name},
                      {"place", one.place},
                      {"unit", one.unit},
                      {"run", one.run},
                      {"cut_off", one.is_cut},
                      {"run_error", number(one.run_error)},
                      {"tables", one.tables},
                      {"tables_error", number(one.tables_error)},
                      {"differs", one.differs}});
    return rows;
  }


  /// Reflections at the probe next to the body and at the nearest skin, and
  /// what each adds where it has merged with the incident wave.
  io::Json reflection_rows(const PlannedScene &scene, const std::string &folder)
  {
    const auto rise = [&](const BlastQuantity quantity) {
      return number(merged_rise(scene.parameters(), scene.layout(), quantity));
    };
    io::Json rows = io::Json::array();
    const auto add = [&](const std::string &place,
                         const std::vector<Reflection> &reflections) {
      for (const Reflection &one : reflections)
        rows.push_back({{"place", place},
                        {"by", one.plane},
                        {"least_delay", number(one.least_delay)},
                        {"largest_delay", one.largest_delay},
                        {"merges", one.merges},
                        {"peak_rise", rise(BlastQuantity::overpressure)},
                        {"impulse_rise", rise(BlastQuantity::impulse)}});
    };
    const SceneLayout &layout = scene.layout();
    add(
      first_probe,
      reflections_at_probe(scene.parameters(), layout, scene.sides(), folder));
    add("nearest skin",
        reflections_at(
          scene.parameters(), layout, scene.sides(), layout.nearest_skin));
    return rows;
  }


  io::Json change_rows(const std::vector<ChangedEntry> &changes)
  {
    io::Json rows = io::Json::array();
    for (const ChangedEntry &change : changes)
      rows.push_back({{"entry", change.entry},
                      {"value", change.value},
                      {"before", change.before}});
    return rows;
  }


  /// Units of the numbers of scene.json by their names; others have none.
  const io::Json units = {{"charge_mass", "kg"},
                          {"distance", "m"},
                          {"distance_along_x", "m"},
                          {"height", "m"},
                          {"end_time", "s"},
                          {"cell_size_at_body", "m"},
                          {"element_size", "m"},
                          {"length", "m"},
                          {"mass", "kg"},
                          {"charge_azimuth", "degrees"},
                          {"charge_elevation", "degrees"},
                          {"body_mass", "kg"},
                          {"arrival", "s"},
                          {"impulse", "Pa s"},
                          {"duration", "s"},
                          {"overpressure", "Pa"},
                          {"reflection_at_body", "s"},
                          {"least_delay", "s"},
                          {"largest_delay", "s"},
                          {"brain_cover", "m"},
                          {"lung_cover", "m"},
                          {"cover_at_least", "m"}};


  /// Compares the blast with the tables: the wave next to the body, or the load
  /// on the nearest skin. A coarser run that the scene has not
  /// made may be left from an earlier one.
  std::vector<ComparedQuantity> compared(const PlannedScene &scene,
                                         const std::vector<SceneTask> &tasks,
                                         const std::string &folder)
  {
    const bool has_coarser_run = is_finished(tasks, "coarser_blast");
    const auto beside = compare_with_tables(scene.parameters(),
                                            scene.layout(),
                                            scene.person_mass(),
                                            folder,
                                            has_coarser_run,
                                            scene.sides());
    const auto gauge = scene.nearest_gauge();
    return beside.empty() && gauge
             ? compare_skin_with_tables(scene.parameters(),
                                        scene.layout(),
                                        *gauge,
                                        folder,
                                        has_coarser_run,
                                        scene.sides())
             : beside;
  }


  /// Plan of the scene and of its blast.
  std::vector<Assumption> whole_plan(const PlannedScene &scene,
                                     const std::string &folder)
  {
    std::vector<Assumption> plan = scene.plan();
    for (const Assumption &item : blast_plan(folder))
      plan.push_back(item);
    return plan;
  }
} // namespace


void print_audit(const PlannedScene &scene,
                 const std::vector<SceneTask> &tasks,
                 const std::string &folder)
{
  const auto audit =
    scene_audit(scene.parameters(), scene.layout(), scene.plan(), folder);
  // In the words of the stage, which has given the same warnings.
  for (const std::string &line : io::audit_lines(
         named(whole_plan(scene, folder), tasks), named(audit, tasks)))
    log_line(line);
  const SceneParameters &parameters = scene.parameters();
  const std::string warning = warning_of(
    compared(scene, tasks, folder),
    parameters.explosive,
    open_reflection_at_body(parameters, scene.layout(), scene.sides()) <
      parameters.end_time);
  if (!warning.empty())
    log_line(warning);
}


void replace_estimates(const PlannedScene &scene,
                       const std::vector<SceneTask> &tasks,
                       const std::string &folder,
                       std::vector<std::string> &warnings)
{
  io::replace_estimates(
    named(whole_plan(scene, folder), tasks),
    named(scene_audit(scene.parameters(), scene.layout(), scene.plan(), folder),
          tasks),
    warnings);
}


void write_scene(const PlannedScene &scene,
                 const std::vector<SceneTask> &tasks,
                 const std::vector<std::string> &reused,
                 const std::vector<std::string> &warnings,
                 const io::CommandLine &command,
                 const unsigned int n_ranks)
{
  const SceneLayout &layout = scene.layout();
  const auto plan = named(whole_plan(scene, command.output_folder), tasks);
  const auto audit =
    named(scene_audit(
            scene.parameters(), layout, scene.plan(), command.output_folder),
          tasks);
  io::Json json = {
    {"application", "scene"},
    {"format", io::formats::scene.number},
    {"version", version()},
    {"git_revision", git_revision()},
    {"title", scene.parameters().title},
    {"question", scene.parameters().question},
    {"accuracy", scene.parameters().accuracy.name},
    {"explosive", scene.parameters().explosive.name},
    {"explosive_title", scene.parameters().explosive.title},
    {"charge_mass", scene.parameters().mass},
    {"charge_place", list(layout.charge)},
    {"probe_beside_body",
     layout.probe ? list(*layout.probe) : io::Json(nullptr)},
    {"nearest_skin", list(layout.nearest_skin)},
    {"distance", layout.distance},
    {"distance_along_x", number(layout.distance_along_x)},
    {"height", layout.charge[2]},
    {"body", scene.body_kind()},
    {"person", person_of(scene.person())},
    {"body_box",
     {list(layout.body.get_boundary_points().first),
      list(layout.body.get_boundary_points().second)}},
    {"domain", {list(layout.lower), list(layout.upper)}},
    {"symmetry", layout.is_half ? "y" : "none"},
    {"end_time", scene.parameters().end_time},
    {"cell_size_at_body", layout.cell_size()},
    {"element_size", scene.parameters().element_size},
    {"tissue_places", place_rows(scene.tissue_places())},
    {"coarser_run", coarser_run_of(tasks)},
    {"command", io::repeating_command(command, n_ranks)},
    {"ranks", n_ranks},
    {"stages", task_rows(tasks, reused)},
    {"plan", plan_rows(plan)},
    {"audit", audit_rows(plan, audit)},
    {"tables", tables_of(scene)},
    {"table_comparison",
     comparison_rows(compared(scene, tasks, command.output_folder))},
    {"reflections", reflection_rows(scene, command.output_folder)},
    {"reflection_at_body",
     number(
       open_reflection_at_body(scene.parameters(), layout, scene.sides()))},
    {"changes", change_rows(scene.parameters().changes)},
    {"warnings", warnings},
    {"remarks", scene.remarks()},
    {"units", units}};
  const auto fit = organ_fit_figures(scene.body());
  if (!fit.empty())
    json["organ_fit"] = fit;
  io::write_file(command.output_folder + "/scene.json",
                 [&](std::ostream &out) { out << json.dump(2) << "\n"; });
}
} // namespace contrecoup::coupling
