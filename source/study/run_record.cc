// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/io/file/file_format.h>
#include <contrecoup/study/run_record.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace contrecoup::study
{
namespace
{
  using io::read_json;
  const io::Json &member_of(const io::Json &object, const char *const name)
  {
    static const io::Json none;
    return object.is_object() && object.contains(name) ? object[name] : none;
  }

  double number(const io::Json &object, const char *const name)
  {
    const io::Json &value = member_of(object, name);
    return value.is_number() ? value.get<double>() : RunRecord::unknown;
  }

  std::string text(const io::Json &object, const char *const name)
  {
    const io::Json &value = member_of(object, name);
    return value.is_string() ? value.get<std::string>() : "";
  }

  /// Adds the warnings of a summary or of scene.json that are not known yet.
  void add_warnings(const io::Json &summary, RunRecord &record)
  {
    for (const io::Json &warning : member_of(summary, "warnings"))
      if (warning.is_string() &&
          std::find(record.warnings.begin(), record.warnings.end(), warning) ==
            record.warnings.end())
        record.warnings.push_back(warning);
  }

  RunRecord of_summary(const io::Json &summary)
  {
    const io::Json &performance = member_of(summary, "performance");
    RunRecord record;
    record.status = text(summary, "status");
    record.message = text(summary, "message");
    record.cells = number(summary, "cells");
    record.unknowns = number(summary, "unknowns");
    record.steps = number(summary, "steps");
    record.retries = number(summary, "retries");
    record.wall_seconds = number(summary, "wall_seconds");
    record.core_seconds = number(performance, "core_seconds");
    record.updates = number(performance, "updates");
    record.memory = number(performance, "peak_memory_bytes");
    add_warnings(summary, record);
    return record;
  }

  void add(const double value, double &sum)
  {
    if (!std::isnan(value))
      sum = std::isnan(sum) ? value : sum + value;
  }

  /// Adds a stage, a row of scene.json.
  void
  add_stage(const std::string &folder, const io::Json &stage, RunRecord &record)
  {
    const io::Json summary =
      read_json(folder + "/" + text(stage, "folder") + "/summary.json",
                io::formats::summary);
    const RunRecord own = of_summary(summary);
    // A coarser run warns of what its larger cells and elements do.
    if (text(stage, "name").rfind("coarser_", 0) != 0)
      add_warnings(summary, record);
    for (double RunRecord::*const value : {&RunRecord::cells,
                                           &RunRecord::unknowns,
                                           &RunRecord::steps,
                                           &RunRecord::retries,
                                           &RunRecord::updates})
      add(own.*value, record.*value);
    add(number(stage, "wall_seconds"), record.wall_seconds);
    add(number(stage, "core_seconds"), record.core_seconds);
    record.memory = std::fmax(record.memory, number(stage, "peak_memory"));
  }
} // namespace

RunRecord read_record(const std::string &folder)
{
  const io::Json summary =
    read_json(folder + "/summary.json", io::formats::summary);
  if (summary.is_object())
    return of_summary(summary);
  RunRecord record;
  record.status =
    text(read_json(folder + "/manifest.json", io::formats::manifest), "status");
  const io::Json scene = read_json(folder + "/scene.json", io::formats::scene);
  const io::Json &stages = member_of(scene, "stages");
  if (stages.is_array())
    for (const io::Json &stage : stages)
      add_stage(folder, stage, record);
  add_warnings(scene, record);
  return record;
}
} // namespace contrecoup::study
