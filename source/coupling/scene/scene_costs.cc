// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/memory.h>
#include <contrecoup/coupling/scene/scene_costs.h>

#include <algorithm>
#include <optional>

namespace contrecoup::coupling
{
namespace
{
  /// Share of the usual time for trial runs; a coarser stage needs fewer.
  constexpr double coarser_trial_share = 0.25;

  /// Time to draw a report [s]: 11.4 s were measured for the quickstart.
  constexpr double drawing_seconds = 12.;

  /// Cost estimate of a task; nothing where an optional one cannot be run.
  std::optional<CostEstimate>
  cost_of(SceneTask &task, const bool with_trials, Collective &collective)
  {
    if (!task.description().is_optional)
      return task.check(with_trials ? 1. : 0., collective);
    try
    {
      return task.check(with_trials ? coarser_trial_share : 0., collective);
    }
    catch (const InputError &error)
    {
      log_line("WARNING: no estimate of the numerical error: " +
               std::string(error.what()));
      return {};
    }
  }

  /// Stages begin with what the forecasts of all have left in memory.
  void keep_memory(StageCosts &costs, Collective &collective)
  {
    forget_peak_memory();
    const double here = peak_memory(MPI_COMM_SELF),
                 all = peak_memory(collective.communicator());
    for (auto &[name, cost] : costs)
      if (cost.memory > 0.)
        cost.memory = std::max(cost.memory, name == "anatomy" ? here : all);
  }
} // namespace


StageCosts estimate_costs(std::vector<SceneTask> &tasks,
                          const double report_bytes,
                          const bool with_trials,
                          Collective &collective)
{
  StageCosts costs;
  for (SceneTask &task : tasks)
  {
    if (task.is_finished())
      continue;
    const LogPart part("forecast", task.description().is_optional);
    log_line("stage " + task.name() + ":");
    const std::optional<CostEstimate> cost =
      cost_of(task, with_trials, collective);
    if (!cost)
      break;
    costs.emplace_back(task.name(), *cost);
  }
  keep_memory(costs, collective);
  if (costs.empty() || report_bytes == 0.)
    return costs;
  CostEstimate drawing;
  drawing.seconds = drawing_seconds;
  drawing.output = report_bytes;
  costs.emplace_back("report", drawing);
  return costs;
}


double size_of_report(const PlannedScene &scene)
{
  if (!scene.parameters().draws_report)
    return 0.;
  const double loads = scene.person().axes() ? 2.9e6 : 1.2e6;
  return loads + (scene.parameters().wants_injury() ? 9e5 : 0.) + 1e5;
}
} // namespace contrecoup::coupling
