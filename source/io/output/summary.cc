// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/version.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/output/summary.h>
#include <contrecoup/io/run/plan_table.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <tuple>

namespace contrecoup
{
namespace io
{
  namespace
  {
    Json number(const double value)
    {
      return std::isfinite(value) ? Json(value) : Json(nullptr);
    }

    Json by_name(const std::vector<NamedValue> &values)
    {
      Json object = Json::object();
      for (const NamedValue &value : values)
        object[value.name] = number(value.value);
      return object;
    }

    Json with_units(const std::vector<NamedValue> &values)
    {
      Json object = Json::object();
      for (const NamedValue &value : values)
        object[value.name] = {{"value", number(value.value)},
                              {"unit", value.unit}};
      return object;
    }

    Json conservation(const std::vector<NamedValue> &first,
                      const std::vector<NamedValue> &last)
    {
      Json object = Json::object();
      for (const NamedValue &begin : first)
        for (const NamedValue &end : last)
          if (begin.conserved && begin.name == end.name)
          {
            object[begin.name + "_first"] = number(begin.value);
            object[begin.name + "_last"] = number(end.value);
            object[begin.name + "_relative_change"] =
              end.value == begin.value
                ? Json(0.)
                : number((end.value - begin.value) / std::abs(begin.value));
          }
      return object;
    }

    Json assumptions(const Summary &summary)
    {
      Json object = Json::object();
      for (const Assumption &item : summary.audit)
      {
        const Assumption *planned = find_assumption(summary.plan, item.name);
        const std::optional<bool> keeps = holds(item, planned);
        object[item.name] = {
          {"decision", item.decision},
          {"quantity", item.quantity},
          {"unit", item.unit},
          {"estimate", planned ? number(planned->value) : Json(nullptr)},
          {"measured", number(item.value)},
          {item.is_lower_limit ? "at_least" : "at_most", number(item.limit)},
          {"holds", keeps ? Json(*keeps) : Json(nullptr)},
          {"entry", item.entry}};
      }
      return object;
    }

    Json performance(const Summary &summary)
    {
      const RunStarts &starts = summary.starts;
      const double updates = summary.state.updates;
      return {{"wall_seconds", number(starts.loop_seconds)},
              {"core_seconds", number(starts.core_seconds)},
              {"updates", number(updates)},
              {"updates_per_second", number(updates / starts.loop_seconds)},
              {"updates_per_second_per_core",
               number(updates / starts.loop_rank_seconds)},
              {"largest_cells", summary.state.largest_cells},
              {"peak_memory_bytes", number(starts.peak_memory)}};
    }
  } // namespace

  void describe(Simulation &simulation, Summary &summary)
  {
    std::tie(summary.cells, summary.unknowns) = simulation.size();
    summary.errors = simulation.errors();
    summary.results = simulation.results();
    summary.checks = simulation.checks();
    summary.audit = simulation.audit();
  }

  std::string to_text(const Summary &summary)
  {
    Json timers = Json::object();
    for (const auto &[name, seconds] : summary.starts.timers)
      timers[name] = number(seconds);
    Json json = {{"application", summary.application},
                 {"format", formats::summary.number},
                 {"version", version()},
                 {"git_revision", git_revision()},
                 {"status", summary.status}};
    if (!summary.message.empty())
      json["message"] = summary.message;
    json["time"] = number(summary.state.time);
    json["steps"] = summary.state.step;
    Json interruptions = Json::array();
    for (const auto &[step, at] : summary.starts.interruptions)
      interruptions.push_back({{"step", step}, {"time", number(at)}});
    json["resumed_from_step"] =
      interruptions.empty() ? Json(nullptr) : interruptions.back()["step"];
    json["interruptions"] = interruptions;
    json["retries"] = summary.state.retries;
    json["ranks"] = summary.ranks;
    json["cells"] = summary.cells;
    json["unknowns"] = summary.unknowns;
    json["wall_seconds"] = number(summary.starts.wall_seconds);
    json["performance"] = performance(summary);
    json["conservation"] =
      conservation(summary.first_values, summary.last_values);
    json["errors"] = by_name(summary.errors);
    json["results"] = with_units(summary.results);
    json["checks"] = with_units(summary.checks);
    json["assumptions"] = assumptions(summary);
    json["warnings"] = summary.starts.warnings;
    json["timers"] = timers;
    return json.dump(2) + "\n";
  }
} // namespace io
} // namespace contrecoup
