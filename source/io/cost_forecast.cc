// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/log.h>
#include <contrecoup/base/memory.h>
#include <contrecoup/base/parameter_tree.h>
#include <contrecoup/base/text.h>
#include <contrecoup/io/cost_cache.h>
#include <contrecoup/io/cost_forecast.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Trials are doubled at most so often.
    constexpr unsigned int most_levels = 10;

    const TrialStage &stage_like(const Trial &trial, const TrialStage &stage)
    {
      static const TrialStage none;
      for (const TrialStage &other : trial.stages)
        if (other.dimension == stage.dimension)
          return other;
      return none;
    }

    /// Seconds of a step with @p cells, see forecast_cost().
    double step_seconds(const TrialStage &before,
                        const TrialStage &last,
                        const double cells)
    {
      const double last_cells = last.cell_steps / last.steps;
      const double last_seconds = last.seconds / last.steps;
      const double whole = last_seconds * cells / last_cells;
      if (!(before.steps > 0.))
        return whole;
      const double cells_before = before.cell_steps / before.steps;
      const double seconds_before = before.seconds / before.steps;
      if (!(last_cells > cells_before))
        return whole;
      const double slope =
        (last_seconds - seconds_before) / (last_cells - cells_before);
      // A part that does not grow is seen in short trials through noise.
      const double least = last_seconds * std::pow(cells / last_cells, 0.85);
      return std::clamp(last_seconds + slope * (cells - last_cells),
                        std::min(least, whole),
                        std::max(least, whole));
    }

    CostEstimate extrapolate(const Trial &before, const Trial &last)
    {
      const unsigned int n = last.levels;
      CostEstimate result;
      double dimension = 1.;
      for (const TrialStage &stage : last.stages)
      {
        const TrialStage &earlier = stage_like(before, stage);
        dimension = stage.dimension;
        const double steps =
          io::extrapolate(earlier.steps, stage.steps, n, 0., 1.);
        const double cells =
          io::extrapolate(earlier.cell_steps / std::max(1., earlier.steps),
                          stage.cell_steps / stage.steps,
                          n,
                          dimension - 1.,
                          dimension);
        result.steps += steps;
        result.seconds += steps * step_seconds(earlier, stage, cells);
      }
      const auto grown =
        [&](double Trial::*number, const double low, const double high) {
          return io::extrapolate(before.*number, last.*number, n, low, high);
        };
      result.cells = grown(&Trial::largest_cells, dimension - 1., dimension);
      result.cells = std::round(result.cells);
      result.unknowns = std::round(result.cells * last.unknowns_per_cell);
      result.seconds += grown(&Trial::setup_seconds, 0., dimension) +
                        grown(&Trial::output_seconds, 0., dimension);
      result.output = grown(&Trial::field_bytes, 0., dimension) +
                      grown(&Trial::table_bytes, 0., 1.);
      result.memory = result.cells * last.memory_per_cell;
      return result;
    }

    std::string description_of(const Trial &trial)
    {
      double steps = 0.;
      for (const TrialStage &stage : trial.stages)
        steps += stage.steps;
      return "  cells " + brief(std::pow(2., trial.levels)) +
             " times as large: " + brief(steps) + " steps, " +
             brief(trial.largest_cells) + " cells at most, " +
             duration(trial.seconds) + ", " +
             bytes(trial.field_bytes + trial.table_bytes);
    }

    /// Levels by which a first trial must be coarser to cost next to nothing,
    /// and two more, for what the solver says without trials may be too little
    /// and growth shows in two trials at least.
    unsigned int first_levels(const CostEstimate &rough, const double budget)
    {
      unsigned int levels = 0;
      double seconds = rough.seconds;
      while (seconds > 0.005 * budget && levels < most_levels)
      {
        seconds /= 8.;
        ++levels;
      }
      return levels > 0 ? std::min(levels + 2, most_levels) : 0;
    }

    /// Processor time that trial runs of --check may take [s].
    double trial_seconds()
    {
      const char *text = std::getenv("CONTRECOUP_CHECK_SECONDS");
      return text ? std::strtod(text, nullptr) : 4.;
    }
  } // namespace

  double extrapolate(const double before,
                     const double last,
                     const unsigned int levels,
                     const double low,
                     const double high)
  {
    if (!(before > 0.))
      return last * std::pow(2., 0.5 * (low + high) * levels);
    const double rate = std::log2(std::max(1., last / before));
    if (rate <= low || rate >= high)
      return last * std::pow(2., std::min(rate, high) * levels);
    const double slow = std::pow(2., low), fast = std::pow(2., high);
    const double b = (last - slow * before) / (fast - slow);
    const double a = before - b;
    return a * std::pow(slow, levels + 1.) + b * std::pow(fast, levels + 1.);
  }

  CostEstimate forecast_cost(const ApplicationDescription &description,
                             const dealii::ParameterHandler &prm,
                             const CostEstimate &rough,
                             const double budget,
                             Collective &collective)
  {
    std::vector<Trial> trials;
    double spent = 0., expected = 0.;
    for (int levels = description.coarsen
                        ? static_cast<int>(first_levels(rough, budget))
                        : 0;
         levels >= 0;
         --levels)
    {
      const double allowed = trials.size() == 1 ? 2. * budget : budget;
      if (!trials.empty() && spent + expected > allowed)
        break;
      const auto trial =
        try_run(description, prm, levels, 2. * budget, collective);
      if (!trial)
        continue;
      log_line(description_of(*trial));
      // Fields cost much the same in all trials.
      const double steady = trial->field_seconds;
      const double before =
        trials.empty() ? 0. : trials.back().seconds - steady;
      trials.push_back(*trial);
      spent += trial->seconds;
      const double most = std::pow(
        2., trial->stages.empty() ? 1. : trial->stages.back().dimension + 1.);
      const double growth =
        before > 0. ? (trial->seconds - steady) / before : 0.5 * most;
      expected =
        steady + (trial->seconds - steady) * std::clamp(growth, 2., most);
    }
    if (trials.empty())
      return rough;
    const Trial none;
    CostEstimate result = extrapolate(
      trials.size() > 1 ? trials[trials.size() - 2] : none, trials.back());
    // What the process holds besides the largest mesh of the trials.
    double largest = 0.;
    for (const Trial &trial : trials)
      largest = std::max(largest, trial.largest_cells * trial.memory_per_cell);
    result.memory += peak_memory(collective.communicator()) - largest;
    return result;
  }

  CostEstimate known_cost(const ApplicationDescription &description,
                          const dealii::ParameterHandler &prm,
                          const CostEstimate &rough,
                          Collective &collective)
  {
    const double budget = trial_seconds();
    if (!(budget > 0.))
      return rough;
    const MPI_Comm all = collective.communicator();
    const CostCache cache(
      description.name + " on " +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(all)) +
      " ranks, " + brief(budget) + " s\n" + parameter_text(prm, false));
    const bool first = dealii::Utilities::MPI::this_mpi_process(all) == 0;
    const std::optional<CostEstimate> known =
      first ? cache.read() : std::nullopt;
    if (dealii::Utilities::MPI::max(known ? 1 : 0, all) > 0)
    {
      log_line("The cost is known from trial runs on this machine, kept in " +
               cache.file());
      return known.value_or(rough);
    }
    log_line("Calibrating by trial runs on coarser meshes, some " +
             brief(budget) + " s ...");
    const CostEstimate cost =
      forecast_cost(description, prm, rough, budget, collective);
    if (first)
      cache.write(cost);
    return cost;
  }
} // namespace io
} // namespace contrecoup
