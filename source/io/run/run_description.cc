// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/run/run_description.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Calls @p visit with name and value of each member of the state.
    template <typename State, typename Visitor>
    void visit_members(State &state, const Visitor &visit)
    {
      visit("step", state.step);
      visit("time", state.time);
      visit("step_size", state.step_size);
      visit("free_step", state.unbounded_step);
      visit("retries", state.retries);
      visit("updates", state.updates);
      visit("largest_cells", state.largest_cells);
      visit("field_index", state.field_index);
      visit("history_step", state.history_step);
      visit("probe_step", state.probe_step);
      visit("field_step", state.field_step);
    }

    Json json_of(const RunStarts &starts)
    {
      Json estimates = Json::object();
      for (const auto &[name, value] : starts.estimates)
        estimates[name] = std::isfinite(value) ? Json(value) : Json(nullptr);
      return {{"wall_seconds", starts.wall_seconds},
              {"core_seconds", starts.core_seconds},
              {"loop_seconds", starts.loop_seconds},
              {"loop_rank_seconds", starts.loop_rank_seconds},
              {"timers", starts.timers},
              {"peak_memory", starts.peak_memory},
              {"estimates", estimates},
              {"warnings", starts.warnings},
              {"interruptions", starts.interruptions}};
    }

    RunStarts starts_of(const Json &json)
    {
      RunStarts starts;
      json.at("wall_seconds").get_to(starts.wall_seconds);
      json.at("core_seconds").get_to(starts.core_seconds);
      json.at("loop_seconds").get_to(starts.loop_seconds);
      json.at("loop_rank_seconds").get_to(starts.loop_rank_seconds);
      json.at("timers").get_to(starts.timers);
      json.at("peak_memory").get_to(starts.peak_memory);
      for (const auto &item : json.at("estimates").items())
        starts.estimates[item.key()] =
          item.value().is_null() ? std::numeric_limits<double>::quiet_NaN()
                                 : item.value().get<double>();
      json.at("warnings").get_to(starts.warnings);
      json.at("interruptions").get_to(starts.interruptions);
      return starts;
    }

    /// @throws InputError unless the checkpoint has the format of this build
    void require_same_format(const Json &json, const std::string &build)
    {
      const Json format = json.value("format", Json());
      if (format == formats::checkpoint.number)
        return;
      throw InputError(
        "the checkpoint was written by " + build + " in format " +
        (format.is_null() ? "0" : format.dump()) + "; this is " + this_build() +
        " and reads format " + std::to_string(formats::checkpoint.number) +
        ": go on with the former, or begin anew with --overwrite");
    }
  } // namespace

  std::string this_build()
  {
    return version() + " (" + git_revision() + ")";
  }

  std::string to_text(const RunDescription &description)
  {
    Json state = Json::object();
    visit_members(description.state, [&](const char *name, const auto &value) {
      state[name] = value;
    });
    Json fields = Json::array();
    for (const CollectionEntry &entry : description.fields)
      fields.push_back({entry.time, entry.part, entry.file});
    Json first = Json::array();
    for (const NamedValue &value : description.first_values)
      first.push_back({value.name, value.unit, value.value, value.conserved});
    const Json text = {{"application", description.application},
                       {"version", version()},
                       {"git_revision", git_revision()},
                       {"format", formats::checkpoint.number},
                       {"state", state},
                       {"starts", json_of(description.starts)},
                       {"history_bytes", description.history_bytes},
                       {"probes_bytes", description.probes_bytes},
                       {"fields", fields},
                       {"first_values", first},
                       {"parameters", description.parameters}};
    return text.dump(1) + "\n";
  }

  RunDescription from_text(const std::string &text)
  {
    try
    {
      const Json json = Json::parse(text);
      RunDescription description;
      json.at("application").get_to(description.application);
      description.build = json.at("version").get<std::string>() + " (" +
                          json.at("git_revision").get<std::string>() + ")";
      require_same_format(json, description.build);
      json.at("history_bytes").get_to(description.history_bytes);
      json.at("probes_bytes").get_to(description.probes_bytes);
      for (const Json &entry : json.at("fields"))
        description.fields.push_back({entry.at(0), entry.at(1), entry.at(2)});
      json.at("parameters").get_to(description.parameters);
      description.starts = starts_of(json.at("starts"));
      visit_members(description.state, [&](const char *name, auto &value) {
        json.at("state").at(name).get_to(value);
      });
      for (const Json &value : json.at("first_values"))
        description.first_values.push_back(
          {value.at(0), value.at(1), value.at(2), value.at(3)});
      return description;
    }
    catch (const nlohmann::json::exception &error)
    {
      throw InputError("\"run.json\" of the checkpoint is damaged: " +
                       std::string(error.what()));
    }
  }

  void require_same_scene(const std::map<std::string, std::string> &before,
                          const std::map<std::string, std::string> &now,
                          const std::vector<std::string> &exempt)
  {
    const auto is_exempt = [&](const std::string &entry) {
      for (const std::string &name : exempt)
        if (entry == name ||
            (name.back() == '/' && entry.compare(0, name.size(), name) == 0))
          return true;
      return false;
    };
    const std::string problem = "the checkpoint belongs to another scene: ";
    for (const auto &[entry, value] : now)
    {
      if (is_exempt(entry))
        continue;
      const auto other = before.find(entry);
      if (other == before.end())
        throw InputError(problem + "it has no entry \"" + entry + "\"");
      if (other->second != value)
        throw InputError(problem + "\"" + entry + "\" was \"" + other->second +
                         "\" and is now \"" + value + "\"");
    }
    for (const auto &[entry, value] : before)
      if (!is_exempt(entry) && now.find(entry) == now.end())
        throw InputError(problem + "its entry \"" + entry + "\" = \"" + value +
                         "\" is now missing");
  }
} // namespace io
} // namespace contrecoup
