// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/log.h>
#include <contrecoup/base/text.h>
#include <contrecoup/base/version.h>
#include <contrecoup/coupling/scene_plan.h>
#include <contrecoup/coupling/scene_run.h>
#include <contrecoup/io/checked_file.h>
#include <contrecoup/io/plan_table.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace contrecoup::coupling
{
namespace
{
  using Json = nlohmann::ordered_json;

  Json list(const dealii::Point<3> &point)
  {
    return {point[0], point[1], point[2]};
  }


  /// A number with its unit for people; "unknown" without one.
  std::string told(const double value, const std::string &unit)
  {
    return std::isfinite(value)
             ? brief(value, 3) + (unit == "-" ? "" : " " + unit)
             : "unknown";
  }


  Json plan_rows(const std::vector<Assumption> &plan)
  {
    Json rows = Json::array();
    for (const Assumption &item : plan)
      rows.push_back({{"item", item.name},
                      {"decision", item.decision},
                      {"quantity", item.quantity},
                      {"estimate", told(item.value, item.unit)},
                      {"entry", item.entry}});
    return rows;
  }


  Json audit_rows(const std::vector<Assumption> &plan,
                  const std::vector<Assumption> &audit)
  {
    Json rows = Json::array();
    for (const Assumption &item : audit)
    {
      const Assumption *planned = io::find_assumption(plan, item.name);
      Json row = {
        {"item", item.name},
        {"decision", item.decision},
        {"quantity", item.quantity},
        {"estimate", planned ? told(planned->value, item.unit) : "unknown"},
        {"found", told(item.value, item.unit)},
        {"limit",
         std::isnan(item.limit) ? ""
                                : (item.is_least ? "at least " : "at most ") +
                                    told(item.limit, item.unit)},
        {"holds", nullptr},
        {"entry", item.entry}};
      if (std::isfinite(item.value) && !std::isnan(item.limit))
        row["holds"] = !item.fails();
      rows.push_back(row);
    }
    return rows;
  }
} // namespace


void SceneRun::print_plan()
{
  log_line(
    "scene " + version() + " (" + git_revision() + "): " + brief(scene_.mass) +
    " kg of " + scene_.explosive + ", " + brief(layout_->distance) +
    " m from the " + description_.kind() + ", " + brief(layout_->charge[2]) +
    " m above the ground; cells of " + brief(1e3 * layout_->cell_size(scene_)) +
    " mm at the skin" +
    (scene_.wants_injury()
       ? ", elements of " + brief(1e3 * scene_.accuracy.element_size) + " mm"
       : ""));
  log_line("  expected in free air: the front reaches the body at " +
           brief(1e3 * layout_->arrival, 3) + " ms with " +
           brief(1e-3 * layout_->overpressure, 3) + " kPa");
  for (const std::string &remark : body_->remarks())
    log_line("  " + remark);
  for (const std::string &line : io::plan_lines(plan_))
    log_line(line);
}


std::vector<Assumption> SceneRun::whole_plan() const
{
  std::vector<Assumption> plan = plan_;
  for (const Assumption &item : stage_plan(path("blast")))
    plan.push_back(item);
  return plan;
}


void SceneRun::print_audit()
{
  for (const std::string &line : io::audit_lines(
         whole_plan(), scene_audit(scene_, *layout_, command_.output_folder)))
    log_line(line);
}


void SceneRun::write_scene()
{
  Json stages = Json::array();
  for (const SceneStage &stage : stages_)
  {
    const StageRecord &record = stage.record();
    const bool is_reused =
      std::find(reused_.begin(), reused_.end(), stage.name()) != reused_.end();
    stages.push_back({{"name", stage.name()},
                      {"status", is_reused ? "reused" : record.status},
                      {"folder", stage.name()},
                      {"wall_seconds", record.wall_seconds},
                      {"core_seconds", record.core_seconds},
                      {"peak_memory", record.peak_memory},
                      {"disk", record.disk},
                      {"hash", record.key}});
  }
  Json places = Json::array();
  for (const TissuePlace &place : places_)
    places.push_back({{"name", place.name}, {"place", list(place.place)}});
  std::string call = "scene " + command_.parameter_file;
  for (const std::string &text : command_.overrides)
    call += " --set \"" + text + "\"";
  const auto plan = whole_plan();
  const Json json = {
    {"application", "scene"},
    {"version", version()},
    {"git_revision", git_revision()},
    {"title", scene_.title},
    {"question", scene_.question},
    {"accuracy", scene_.accuracy.name},
    {"explosive", scene_.explosive},
    {"charge_mass", scene_.mass},
    {"charge_place", list(layout_->charge)},
    {"distance", layout_->distance},
    {"height", layout_->charge[2]},
    {"body", description_.kind()},
    {"body_box",
     {list(layout_->body.get_boundary_points().first),
      list(layout_->body.get_boundary_points().second)}},
    {"domain", {list(layout_->lower), list(layout_->upper)}},
    {"symmetry", layout_->is_half ? "y" : "none"},
    {"end_time", scene_.end_time},
    {"cell_size_at_body", layout_->cell_size(scene_)},
    {"element_size", scene_.accuracy.element_size},
    {"tissue_places", places},
    {"command", call},
    {"ranks",
     dealii::Utilities::MPI::n_mpi_processes(collective_.communicator())},
    {"stages", stages},
    {"plan", plan_rows(plan)},
    {"audit",
     audit_rows(plan, scene_audit(scene_, *layout_, command_.output_folder))},
    {"remarks", body_->remarks()}};
  io::write_file(path("scene.json"),
                 [&](std::ostream &out) { out << json.dump(2) << "\n"; });
}


void SceneRun::draw_report()
{
  const std::string script = std::string(CONTRECOUP_PLOT_FOLDER) + "/report.py";
  const std::string command =
    "\"" + script + "\" \"" + command_.output_folder + "\" > /dev/null 2>&1";
  log_line(std::system(command.c_str()) == 0
             ? "report in " + path("report.html")
             : "no report: \"" + script + "\" failed");
}
} // namespace contrecoup::coupling
