// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/scene/coarser_run.h>
#include <contrecoup/coupling/scene/stage_results.h>

#include <map>

namespace contrecoup::coupling
{
namespace
{
  bool ends_with(const std::string &text, const std::string &end)
  {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
  }

  /// Whether an entry is a refinement level of cells of the gas.
  bool is_level(const std::string &path)
  {
    return (begins_with(path, "Rigid body/") && ends_with(path, "/Levels")) ||
           (begins_with(path, "Adaptation/") &&
            (ends_with(path, "/Largest level") ||
             ends_with(path, "/Smallest level") ||
             ends_with(path, "/Fine box levels")));
  }
} // namespace


std::vector<Assignment> CoarserRun::blast(const dealii::ParameterHandler &prm)
{
  const std::map<std::string, std::string> values = parameter_values(prm);
  const auto change = [](const std::string &path, const std::string &value) {
    return parse_override(path + "=" + value);
  };
  if (std::stoul(values.at("Rigid body/Levels")) == 0)
    throw InputError("Scene/Error estimate: cells of the largest size at the "
                     "skin (Blast/Rigid body/Levels = 0) have no coarser ones; "
                     "set Scene/Cell size to at most 0.08 m or Scene/Error "
                     "estimate = false");
  std::vector<Assignment> changes;
  for (const auto &[path, value] : values)
    if (is_level(path) && value != "0")
      changes.push_back(change(path, std::to_string(std::stoul(value) - 1)));
  if (values.at("First stage/Kind") == "axisymmetric")
    changes.push_back(change(
      "First stage/Cell size",
      exact(cell_ratio * std::stod(values.at("First stage/Cell size")))));
  // Planes of gauges come with the fields, and their areas have errors, too.
  const std::vector<std::pair<std::string, std::string>> no_fields =
    values.at("Probes/Gauge planes").empty()
      ? std::vector<std::pair<std::string, std::string>>{{"Output/Fields",
                                                          "false"}}
      : std::vector<std::pair<std::string, std::string>>{
          {"Output/Fields interval", "0"},
          {"Output/Fields every steps", "0"},
          {"Output/Volume fields", "false"},
          {"Pictures/Planes", ""}};
  for (const auto &[path, value] : no_fields)
    changes.push_back(change(path, value));
  changes.push_back(change("Output/Pictures", "false"));
  return changes;
}


std::vector<Assignment>
CoarserRun::biomechanics(const dealii::ParameterHandler &prm)
{
  const double size = std::stod(parameter_values(prm).at("Mesh/Element size"));
  return {parse_override("Mesh/Element size=" + exact(element_ratio * size)),
          parse_override("Output/Fields=false"),
          // More hourglass energy than the audit of the scene allows is an
          // error of the coarser mesh that the estimate has to show.
          parse_override("Energy audit/Largest hourglass part=1")};
}


std::vector<std::string>
CoarserRun::same_correction_of_loads(const std::string &folder)
{
  const double factor = stage_check(folder, "loads_impulse_factor");
  const std::string loads = "Loads/Recorded/";
  return {"--set",
          factor == 1. ? loads + "Keep impulse=false"
                       : loads + "Largest correction=1"};
}
} // namespace contrecoup::coupling
