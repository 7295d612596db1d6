// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/memory.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/application/cost_forecast.h>
#include <contrecoup/io/application/cost_laws.h>
#include <contrecoup/io/application/trial_limits.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Limits for the trials of long runs: fraction of the run's processor
    /// time, and number of budgets.
    constexpr double long_run_part = 0.01, most_budgets = 5.;
    /// Largest factor between the steps of a trial and what those before it
    /// predict for which the forecast is believed.
    constexpr double largest_misprediction = 1.4;
    /// Part of its last stage to which a stopped trial must come if nothing
    /// confirms the steps of the rest: those of a blast grow as it weakens.
    constexpr double least_confirmed_part = 0.5;
    /// Largest growth of cells with levels for which layers are refined, over
    /// the dimension; it is 1 where everything is, and 3/4 in the end.
    constexpr double most_growth = 0.85;

    const TrialStage &stage_like(const Trial &trial, const TrialStage &stage)
    {
      static const TrialStage none;
      for (const TrialStage &other : trial.stages)
        if (other.dimension == stage.dimension)
          return other;
      return none;
    }

    double mean_cells(const TrialStage &stage)
    {
      return stage.cell_steps / std::max(1., stage.steps);
    }

    /// Time of a step with @p cells, see forecast_cost() [s].
    double step_seconds(const TrialStage &before,
                        const TrialStage &last,
                        const double cells)
    {
      return grow_with_cells(mean_cells(before),
                             before.seconds / std::max(1., before.steps),
                             mean_cells(last),
                             last.seconds / last.steps,
                             cells,
                             0.85);
    }

    /// Powers of refinement with which steps of a stage of the last trial grow.
    Powers powers_of_steps(const std::vector<Trial> &trials,
                           const TrialStage &stage)
    {
      const std::size_t n = trials.size();
      if (n < 3)
        return {};
      const Trial &first = trials[n - 3], &middle = trials[n - 2];
      return io::powers_of_steps(stage_like(first, stage).steps,
                                 stage_like(middle, stage).steps,
                                 stage.steps,
                                 first.levels - middle.levels,
                                 middle.levels - trials.back().levels);
    }

    /// The last two trials, and the solver's estimate of the scene's cells.
    struct Trials
    {
      const std::vector<Trial> &all;
      const Trial &before, &last;
      double known;
      bool adapts; ///< whether the mesh of the last stage changes
      const dealii::ParameterHandler &prm; ///< of the scene

      unsigned int gap() const
      {
        return before.levels - last.levels;
      }

      /// Extrapolates a number of cells of a stage of the last trial.
      double cells(const TrialStage &stage,
                   const double cells_before,
                   const double cells_last) const
      {
        const bool is_last = &stage == &last.stages.back();
        if (!stage.is_constant() || (is_last && adapts))
          return extrapolate_cells(
            cells_before, cells_last, last.levels, stage.dimension, gap());
        if (is_last && last.known_cells > 0. && last.levels > 0)
          return known * cells_last / last.known_cells;
        return io::extrapolate(
          cells_before, cells_last, last.levels, 0., stage.dimension, gap());
      }

      double grown(double Trial::*number, const Powers &powers) const
      {
        const auto [low, high] = powers;
        return io::extrapolate(
          before.*number, last.*number, last.levels, low, high, gap());
      }
    };

    /// Bytes of what has values in each cell, for a mesh of @p cells.
    double bytes_of_cells(const Trials &trials,
                          double Trial::*bytes,
                          const double cells)
    {
      const TrialStage &stage = trials.last.stages.back();
      // Adaptation keeps parts that compress well.
      return grow_with_cells(mean_cells(stage_like(trials.before, stage)),
                             trials.before.*bytes,
                             mean_cells(stage),
                             trials.last.*bytes,
                             cells,
                             0.);
    }

    /// Number of checkpoints that a run of this cost leaves.
    double count_checkpoints(const dealii::ParameterHandler &prm,
                             const CostEstimate &cost)
    {
      constexpr double most_kept = 2.;
      const std::vector<std::string> output{"Output"};
      const double steps = prm.get_integer(output, "Checkpoint every steps");
      const double minutes = prm.get_double(output, "Checkpoint every minutes");
      double written = prm.get_bool(output, "Checkpoint at the end") ? 1. : 0.;
      if (steps > 0.)
        written += std::floor(cost.steps / steps);
      if (minutes > 0.)
        written += std::floor(cost.seconds / 60. / minutes);
      return std::min(written, most_kept);
    }

    /// Results on disk, without pictures [byte].
    double output_of(const Trials &trials, const double cells)
    {
      const double dimension = trials.last.stages.back().dimension;
      return bytes_of_cells(trials, &Trial::volume_bytes, cells) +
             trials.last.plane_bytes +
             trials.grown(&Trial::surface_bytes, {dimension - 1., dimension}) +
             trials.grown(
               &Trial::table_bytes,
               powers_of_steps(trials.all, trials.last.stages.back())) +
             std::max(trials.before.other_bytes, trials.last.other_bytes);
    }

    CostEstimate extrapolate(const Trials &trials)
    {
      CostEstimate result;
      const Trial &last = trials.last;
      const unsigned int n = last.levels, gap = trials.gap();
      double cells = 0., dimension = 1.;
      for (const TrialStage &stage : last.stages)
      {
        const TrialStage &earlier = stage_like(trials.before, stage);
        dimension = stage.dimension;
        const Powers powers = powers_of_steps(trials.all, stage);
        const double steps =
          earlier.largest_cells == stage.largest_cells
            ? extrapolate_to_limit(earlier.steps, stage.steps, n, gap)
            : io::extrapolate(earlier.steps,
                              stage.steps,
                              n,
                              earlier.steps > 0. ? powers.low : 1.,
                              powers.high,
                              gap);
        cells = trials.cells(stage, mean_cells(earlier), mean_cells(stage));
        result.cells = std::round(
          trials.cells(stage, earlier.largest_cells, stage.largest_cells));
        result.steps += steps;
        result.seconds += steps * step_seconds(earlier, stage, cells);
      }
      // Nodes of a skin are fewer for each cell of finer meshes.
      result.unknowns = std::round(
        result.cells *
        (trials.before.unknowns_per_cell > 0.
           ? extrapolate_to_limit(
               trials.before.unknowns_per_cell, last.unknowns_per_cell, n, gap)
           : last.unknowns_per_cell));
      result.seconds += trials.grown(&Trial::setup_seconds, {0., dimension}) +
                        trials.grown(&Trial::output_seconds, {0., dimension});
      if (!last.stages.empty())
        result.output =
          output_of(trials, cells) +
          count_checkpoints(trials.prm, result) *
            bytes_of_cells(trials, &Trial::checkpoint_bytes, cells);
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
                             const double known,
                             const bool adapts,
                             const dealii::ParameterHandler &prm)
    {
      Trial none;
      none.levels = trials.back().levels + 1;
      CostEstimate result =
        extrapolate({trials,
                     trials.size() > 1 ? trials[trials.size() - 2] : none,
                     trials.back(),
                     known,
                     adapts,
                     prm});
      result.memory = extrapolate_memory(trials, result.cells);
      return result;
    }

    double all_steps(const Trial &trial)
    {
      double steps = 0.;
      for (const TrialStage &stage : trial.stages)
        steps += stage.steps;
      return steps;
    }

    /// Whether a trial that its time limit stopped tells what it missed: it
    /// came to its last stage and, if the mesh @p adapts, to the time at which
    /// that of the trial before it was largest.
    bool tells_end(const Trial &trial,
                   const std::vector<Trial> &before,
                   const bool adapts)
    {
      if (trial.lacks_stage || trial.part < Trial::least_part)
        return false;
      return !adapts || (!before.empty() &&
                         before.back().stages.size() == trial.stages.size() &&
                         before.back().time_of_largest <= trial.time);
    }

    /// Whether trials before the last one predict its steps; one level that is
    /// left is believed without, if the last one tells of it.
    bool knows_steps(const std::vector<Trial> &trials,
                     const bool adapts,
                     const dealii::ParameterHandler &prm)
    {
      const Trial &last = trials.back();
      if (trials.size() < 3)
        return last.levels <= 1 && last.part >= least_confirmed_part &&
               (!adapts || !last.has_few_steps());
      std::vector<Trial> earlier(trials.begin(), trials.end() - 1);
      for (Trial &trial : earlier)
        trial.levels -= last.levels;
      const double predicted =
        extrapolate(earlier, last.known_cells, adapts, prm).steps;
      return std::abs(std::log(predicted / all_steps(last))) <
             std::log(largest_misprediction);
    }

    /// Whether both last trials refine layers, not everything still, and began
    /// in the same stages: cells of another run say nothing.
    bool knows_cells(const std::vector<Trial> &trials)
    {
      if (trials.size() < 2)
        return false;
      const Trial &before = trials[trials.size() - 2], &last = trials.back();
      if (before.stages.size() != last.stages.size())
        return false;
      const double rate =
        std::log2(largest_cells(last) / std::max(1., largest_cells(before))) /
        (before.levels - last.levels);
      return rate < most_growth * last.stages.back().dimension;
    }

    /// Leaves out of @p cost what the trials do not predict.
    void leave_out_unknown(CostEstimate &cost,
                           const std::vector<Trial> &trials,
                           const bool adapts,
                           const dealii::ParameterHandler &prm)
    {
      const Trial &last = trials.back();
      if (last.levels == 0 || last.stages.empty())
        return;
      if (!knows_steps(trials, adapts, prm))
        cost.steps = 0.;
      if (adapts && !knows_cells(trials))
        cost.cells = cost.unknowns = cost.memory = cost.output = 0.;
      if (!(cost.steps > 0.) || !(cost.cells > 0.))
        cost.seconds = 0.;
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
             duration(trial.seconds) + ", " + bytes(trial.output_bytes()) +
             (trial.is_stopped() ? ", stopped" : "") +
             (trial.lacks_stage ? " before its last stage" : "");
    }

    /// Known part of the cost without trials: no time, nor the steps of a
    /// gas, whose speeds are known when it has begun to move, nor the size of a
    /// mesh that changes.
    CostEstimate without_trials(const ApplicationDescription &description,
                                const dealii::ParameterHandler &prm,
                                const CostEstimate &rough,
                                Collective &collective)
    {
      CostEstimate cost = rough;
      cost.memory += peak_memory(collective.communicator());
      cost.seconds = 0.;
      if (!description.adapts)
        return cost;
      cost.steps = 0.;
      if (description.adapts(prm))
        cost.cells = cost.unknowns = cost.memory = 0.;
      return cost;
    }

    /// Time of a trial that is one level finer than the last [s].
    double seconds_of_next(const std::vector<Trial> &trials)
    {
      const Trial &last = trials.back();
      // The cost of fields is about the same in all trials.
      const double steady = last.field_seconds;
      const double changing = last.seconds - steady;
      const double most = std::pow(
        2., last.stages.empty() ? 1. : last.stages.back().dimension + 1.);
      double growth = 0.5 * most;
      if (trials.size() > 1)
      {
        const Trial &coarser = trials[trials.size() - 2];
        if (coarser.seconds > steady)
          growth = std::pow(changing / (coarser.seconds - steady),
                            1. / (coarser.levels - last.levels));
      }
      return steady + changing * std::clamp(growth, 2., most);
    }

    /// Takes the output from trials that came to their end, as a stopped one
    /// lacks fields and pictures, and adds the drawing.
    void complete_output(const ApplicationDescription &description,
                         const dealii::ParameterHandler &prm,
                         std::vector<Trial> trials,
                         const double known,
                         const bool adapts,
                         Collective &collective,
                         CostEstimate &cost)
    {
      if (trials.back().is_stopped())
      {
        trials.pop_back();
        if (adapts && cost.output > 0.)
          cost.output = knows_cells(trials)
                          ? extrapolate(trials, known, adapts, prm).output
                          : 0.;
      }
      if (description.pictures.empty() || !prm.get_bool({"Output"}, "Pictures"))
        return;
      if (trials.empty())
      {
        cost.output = 0.;
        return;
      }
      const auto [seconds, size] =
        try_drawing(description, trials.back(), collective);
      cost.seconds += cost.seconds > 0. ? seconds : 0.;
      cost.output += cost.output > 0. ? size : 0.;
    }
  } // namespace

  TriedCost forecast_cost(const ApplicationDescription &description,
                          const dealii::ParameterHandler &prm,
                          const CostEstimate &rough,
                          const double budget,
                          Collective &collective)
  {
    std::vector<Trial> trials;
    double spent = 0., expected = 0.;
    TriedCost result{rough};
    const bool adapts = description.adapts && description.adapts(prm);
    const auto set = trial_levels();
    const auto [begin, end] = set.value_or(std::pair<int, int>(
      description.coarsen ? first_trial_levels(rough, budget) : 0, 0));
    for (int levels = begin; levels >= end; --levels)
    {
      // Extrapolation needs at least two trials, the last with refined cells
      // where the mesh changes.
      const bool is_informed =
        !adapts || trials.empty() || trials.back().tells_of_finer();
      const double allowed =
        set ? std::numeric_limits<double>::infinity()
            : std::clamp(is_informed ? long_run_part * result.seconds
                                     : most_budgets * budget,
                         budget,
                         most_budgets * budget);
      if (trials.size() > 1 && spent + expected > allowed)
        break;
      const auto trial =
        try_run(description, prm, levels, 2. * allowed, collective);
      if (!trial)
        continue;
      log_line(description_of(*trial));
      if (trial->is_stopped() && !tells_end(*trial, trials, adapts))
        break; // finer ones would not come as far either
      // A finer one may come to the last stage before the end.
      if (trial->lacks_stage && levels > 0)
        continue;
      trials.push_back(*trial);
      static_cast<CostEstimate &>(result) =
        extrapolate(trials, rough.cells, adapts, prm);
      spent += trial->seconds;
      expected = seconds_of_next(trials);
    }
    if (trials.empty())
      return {without_trials(description, prm, rough, collective)};
    result.is_exact = trials.back().levels == 0 && !trials.back().is_stopped();
    result.step_growth = largest_step_growth(trials);
    // Coarse trials have other nodes for each cell than the run.
    if (rough.unknowns > 0. && !adapts)
      result.unknowns = std::round(rough.unknowns * result.cells / rough.cells);
    leave_out_unknown(result, trials, adapts, prm);
    complete_output(
      description, prm, trials, rough.cells, adapts, collective, result);
    return result;
  }

  TriedCost cached_or_forecast_cost(const ApplicationDescription &description,
                                    const dealii::ParameterHandler &prm,
                                    const CostEstimate &rough,
                                    Collective &collective)
  {
    const double budget = description.trial_share * trial_seconds();
    if (!(budget > 0.))
      return {without_trials(description, prm, rough, collective)};
    const MPI_Comm all = collective.communicator();
    const char *levels = std::getenv(trial_levels_variable);
    const CostCache cache(
      description.name + " on " +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(all)) +
      " ranks, " + brief(budget) + " s, levels " +
      (levels ? levels : "by time") + "\n" + parameter_text(prm, false));
    const bool first = dealii::Utilities::MPI::this_mpi_process(all) == 0;
    const std::optional<TriedCost> known = first ? cache.read() : std::nullopt;
    if (dealii::Utilities::MPI::max(known ? 1 : 0, all) > 0)
    {
      log_line("The cost is known from trial runs on this machine, kept in " +
               cache.file());
      return known.value_or(TriedCost{rough});
    }
    const std::string trials =
      "Calibrating by trial runs on coarser meshes, some " + brief(budget) +
      " s ...";
    log_line(trials);
    Log::instance().status(trials);
    const TriedCost cost =
      forecast_cost(description, prm, rough, budget, collective);
    if (first)
      cache.write(cost);
    return cost;
  }
} // namespace io
} // namespace contrecoup
