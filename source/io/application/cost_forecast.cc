// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/application/cost_forecast.h>
#include <contrecoup/io/run/cost_cache.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace contrecoup
{
namespace io
{
  namespace
  {
    const char *const levels_variable = "CONTRECOUP_CHECK_LEVELS";
    /// Largest number of coarsenings of a trial.
    constexpr unsigned int most_levels = 10;
    /// Limits for the trials of long runs: fraction of the run's processor
    /// time, and number of budgets.
    constexpr double long_run_part = 0.01, most_budgets = 5.;

    const TrialStage &stage_like(const Trial &trial, const TrialStage &stage)
    {
      static const TrialStage none;
      for (const TrialStage &other : trial.stages)
        if (other.dimension == stage.dimension)
          return other;
      return none;
    }

    /// Time of a step with @p cells, see forecast_cost() [s].
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
      // In short trials, noise hides the part that does not grow.
      const double least = last_seconds * std::pow(cells / last_cells, 0.85);
      return std::clamp(last_seconds + slope * (cells - last_cells),
                        std::min(least, whole),
                        std::max(least, whole));
    }

    /// Number of cells of the scene from those of two trials and from the
    /// solver's initial cells, all of the same stage. Extrapolates the cells
    /// that adaptation adds, see forecast_cost(), or all cells where
    /// adaptation removes some.
    double extrapolate_cells(const double before,
                             const Trial &before_trial,
                             const double last,
                             const Trial &last_trial,
                             const double known,
                             const double dimension)
    {
      const bool adds = last >= last_trial.known_cells;
      const double begin = adds ? last_trial.known_cells : 0.;
      const double begin_before = adds ? before_trial.known_cells : 0.;
      const unsigned int gap = before_trial.levels - last_trial.levels;
      const double added_before = std::max(0., before - begin_before);
      const bool is_first =
        last - begin > added_before * std::pow(2., dimension * gap);
      return (adds ? known : 0.) +
             io::extrapolate(added_before,
                             last - begin,
                             last_trial.levels,
                             dimension - 1.,
                             is_first ? dimension - 1. : dimension,
                             gap);
    }

    /// Whether the trial had the same mesh from its first step to its last.
    bool has_constant_mesh(const Trial &trial)
    {
      return trial.stages.size() == 1 &&
             trial.stages[0].cell_steps ==
               trial.stages[0].steps * trial.stages[0].largest_cells;
    }

    /// Adjusts a forecast for meshes that never change: the solver's estimate
    /// of the cells then holds but for what the last trial shows, and fields
    /// have a value for each cell.
    void use_known_cells(const Trial &last,
                         const double known,
                         const double field_bytes,
                         CostEstimate &cost)
    {
      const double cells = last.stages[0].largest_cells;
      const double wanted = std::round(known * cells / last.known_cells);
      cost.seconds *= wanted / cost.cells;
      cost.output += last.field_bytes * wanted / cells - field_bytes;
      cost.cells = wanted;
      cost.unknowns = std::round(wanted * last.unknowns_per_cell);
    }

    /// @param known initial cells of the scene by the solver's estimate
    CostEstimate
    extrapolate(const Trial &before, const Trial &last, const double known)
    {
      const unsigned int n = last.levels, gap = before.levels - n;
      CostEstimate result;
      double dimension = 1.;
      for (const TrialStage &stage : last.stages)
      {
        const TrialStage &earlier = stage_like(before, stage);
        dimension = stage.dimension;
        const bool is_last = &stage == &last.stages.back();
        const double steps =
          earlier.largest_cells == stage.largest_cells
            ? extrapolate_to_limit(earlier.steps, stage.steps, n, gap)
            : io::extrapolate(earlier.steps, stage.steps, n, 0., 1., gap);
        const double cells_before =
          earlier.cell_steps / std::max(1., earlier.steps);
        const double cells_last = stage.cell_steps / stage.steps;
        const double cells =
          is_last
            ? extrapolate_cells(
                cells_before, before, cells_last, last, known, dimension)
            : io::extrapolate(
                cells_before, cells_last, n, dimension - 1., dimension, gap);
        result.steps += steps;
        result.seconds += steps * step_seconds(earlier, stage, cells);
      }
      const auto grown = [&](double Trial::*number,
                             const double low,
                             const double high) {
        return io::extrapolate(before.*number, last.*number, n, low, high, gap);
      };
      if (!last.stages.empty())
      {
        const TrialStage &stage = last.stages.back();
        result.cells =
          std::round(extrapolate_cells(stage_like(before, stage).largest_cells,
                                       before,
                                       stage.largest_cells,
                                       last,
                                       known,
                                       dimension));
      }
      result.unknowns = std::round(result.cells * last.unknowns_per_cell);
      result.seconds += grown(&Trial::setup_seconds, 0., dimension) +
                        grown(&Trial::output_seconds, 0., dimension);
      const double fields = grown(&Trial::field_bytes, 0., dimension);
      result.output = fields + grown(&Trial::table_bytes, 0., 1.) +
                      grown(&Trial::load_bytes, dimension - 1., dimension);
      if (has_constant_mesh(last) && last.known_cells > 0. && n > 0)
        use_known_cells(last, known, fields, result);
      return result;
    }

    /// Cells of the last stage, whose mesh is the largest in memory.
    double largest_cells(const Trial &trial)
    {
      return trial.stages.empty() ? 0. : trial.stages.back().largest_cells;
    }

    /// Memory for a mesh of @p cells, see forecast_cost() [byte].
    double extrapolate_memory(const std::vector<Trial> &trials,
                              const double cells)
    {
      const Trial &first = trials.front(), &last = trials.back();
      const double more = largest_cells(last) - largest_cells(first);
      const double found =
        more > 0. ? (last.peak_memory - first.peak_memory) / more : 0.;
      // Adaptation needs up to twice the memory; more is noise.
      const double per_cell =
        std::clamp(found, last.memory_per_cell, 2. * last.memory_per_cell);
      return last.peak_memory + per_cell * (cells - largest_cells(last));
    }

    /// Uses the last two trials, or the only one; for memory also the first.
    CostEstimate extrapolate(const std::vector<Trial> &trials,
                             const double known)
    {
      Trial none;
      none.levels = trials.back().levels + 1;
      CostEstimate result =
        extrapolate(trials.size() > 1 ? trials[trials.size() - 2] : none,
                    trials.back(),
                    known);
      result.memory = extrapolate_memory(trials, result.cells);
      return result;
    }

    std::string description_of(const Trial &trial)
    {
      std::vector<std::string> stages;
      for (const TrialStage &stage : trial.stages)
        stages.push_back(brief(stage.steps) + " steps in " +
                         std::to_string(stage.dimension) + "-D with " +
                         brief(stage.largest_cells) + " cells at most");
      return "  cells " + brief(std::pow(2., trial.levels)) +
             " times as large: " + join(stages, ", ") + "; " +
             duration(trial.seconds) + ", " +
             bytes(trial.field_bytes + trial.table_bytes + trial.load_bytes);
    }

    /// Levels by which the first trial must be coarser to cost next to
    /// nothing, plus two, because the solver's estimate may be too low.
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

    /// Processor time for the trials of --check [s].
    double trial_seconds()
    {
      const char *text = std::getenv("CONTRECOUP_CHECK_SECONDS");
      return text ? std::strtod(text, nullptr) : 4.;
    }

    /// Levels of the first and the last trial from the environment variable
    /// CONTRECOUP_CHECK_LEVELS = "first last". Counted quantities are then the
    /// same on every machine.
    std::optional<std::pair<int, int>> trial_levels()
    {
      const char *text = std::getenv(levels_variable);
      if (text == nullptr)
        return std::nullopt;
      std::istringstream stream(text);
      std::pair<int, int> levels;
      if (!(stream >> levels.first >> levels.second) || levels.second < 0 ||
          levels.first < levels.second ||
          levels.first > static_cast<int>(most_levels))
        throw InputError(std::string(levels_variable) + " = \"" +
                         std::string(text) +
                         "\": two levels are needed, the first from " +
                         std::to_string(most_levels) + " to the last, 0");
      return levels;
    }
  } // namespace

  double extrapolate(const double before,
                     const double last,
                     const unsigned int levels,
                     const double low,
                     const double high,
                     const unsigned int gap)
  {
    if (!(before > 0.))
      return last * std::pow(2., 0.5 * (low + high) * levels);
    const double rate = std::log2(std::max(1., last / before)) / gap;
    if (rate <= low || rate >= high)
      return last * std::pow(2., std::min(rate, high) * levels);
    const double slow = std::pow(2., low * gap),
                 fast = std::pow(2., high * gap);
    const double b = (last - slow * before) / (fast - slow);
    const double a = before - b;
    return a * std::pow(2., low * (levels + gap)) +
           b * std::pow(2., high * (levels + gap));
  }

  double extrapolate_to_limit(const double before,
                              const double last,
                              const unsigned int levels,
                              const unsigned int gap)
  {
    const double shrinkage = std::pow(2., -static_cast<double>(gap));
    const double rest = 1. - std::pow(2., -static_cast<double>(levels));
    return last + (last - before) * shrinkage / (1. - shrinkage) * rest;
  }

  CostEstimate forecast_cost(const ApplicationDescription &description,
                             const dealii::ParameterHandler &prm,
                             const CostEstimate &rough,
                             const double budget,
                             Collective &collective)
  {
    std::vector<Trial> trials;
    double spent = 0., expected = 0.;
    CostEstimate result = rough;
    const auto set = trial_levels();
    const auto [begin, end] = set.value_or(std::pair<int, int>(
      description.coarsen ? first_levels(rough, budget) : 0, 0));
    for (int levels = begin; levels >= end; --levels)
    {
      // Extrapolation needs at least two trials.
      const double allowed = set ? std::numeric_limits<double>::infinity()
                                 : std::clamp(long_run_part * result.seconds,
                                              budget,
                                              most_budgets * budget);
      if (trials.size() > 1 && spent + expected > allowed)
        break;
      const auto trial =
        try_run(description, prm, levels, 2. * allowed, collective);
      if (!trial)
        continue;
      log_line(description_of(*trial));
      // The cost of fields is about the same in all trials.
      const double steady = trial->field_seconds;
      const double before =
        trials.empty() ? 0. : trials.back().seconds - steady;
      trials.push_back(*trial);
      result = extrapolate(trials, rough.cells);
      spent += trial->seconds;
      const double most = std::pow(
        2., trial->stages.empty() ? 1. : trial->stages.back().dimension + 1.);
      const double growth =
        before > 0. ? std::pow((trial->seconds - steady) / before,
                               1. / (trials[trials.size() - 2].levels - levels))
                    : 0.5 * most;
      expected =
        steady + (trial->seconds - steady) * std::clamp(growth, 2., most);
    }
    return trials.empty() ? rough : result;
  }

  CostEstimate
  cached_or_forecast_cost(const ApplicationDescription &description,
                          const dealii::ParameterHandler &prm,
                          const CostEstimate &rough,
                          Collective &collective)
  {
    const double budget = description.trial_share * trial_seconds();
    if (!(budget > 0.))
      return rough;
    const MPI_Comm all = collective.communicator();
    const char *levels = std::getenv(levels_variable);
    const CostCache cache(
      description.name + " on " +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(all)) +
      " ranks, " + brief(budget) + " s, levels " +
      (levels ? levels : "by time") + "\n" + parameter_text(prm, false));
    const bool first = dealii::Utilities::MPI::this_mpi_process(all) == 0;
    const std::optional<CostEstimate> known =
      first ? cache.read() : std::nullopt;
    if (dealii::Utilities::MPI::max(known ? 1 : 0, all) > 0)
    {
      log_line("The cost is known from trial runs on this machine, kept in " +
               cache.file());
      return known.value_or(rough);
    }
    const std::string trials =
      "Calibrating by trial runs on coarser meshes, some " + brief(budget) +
      " s ...";
    log_line(trials);
    Log::instance().status(trials);
    const CostEstimate cost =
      forecast_cost(description, prm, rough, budget, collective);
    if (first)
      cache.write(cost);
    return cost;
  }
} // namespace io
} // namespace contrecoup
