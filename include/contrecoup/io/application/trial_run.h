// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/collective.h>
#include <contrecoup/io/application/application.h>
#include <contrecoup/io/file/temporary_folder.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Measurements of a trial run while its mesh had the same dimension.
  struct TrialStage
  {
    unsigned int dimension = 0;
    double begin = 0.;         ///< simulated time at its first step [s]
    double steps = 0.;         ///< number of steps
    double first_step = 0.;    ///< its size [s]
    double cell_steps = 0.;    ///< sum of the number of cells over all steps
    double largest_cells = 0.; ///< largest number of cells
    /// processor time of the slowest rank, without setup [s]
    double seconds = 0.;

    /// Whether the mesh was the same from the first step to the last.
    bool is_constant() const
    {
      return cell_steps == steps * largest_cells;
    }
  };

  /// Measurements of a trial run.
  struct Trial
  {
    unsigned int levels = 0; ///< number of coarsenings
    std::vector<TrialStage> stages;
    double setup_seconds = 0.;    ///< of all stages [s]
    double output_seconds = 0.;   ///< for field output [s]
    double volume_bytes = 0.;     ///< of fields of all cells [byte]
    double plane_bytes = 0.;      ///< of fields with a resolution of their own
    double surface_bytes = 0.;    ///< of recorded loads and fields on a skin
    double table_bytes = 0.;      ///< of tables with a row for steps [byte]
    double other_bytes = 0.;      ///< of files as large for any mesh [byte]
    double checkpoint_bytes = 0.; ///< of one checkpoint [byte]
    double known_cells = 0.;      ///< initial cells by the solver's estimate
    double unknowns_per_cell = 0.;
    double memory_per_cell = 0.; ///< by the solver's estimate [byte]
    double peak_memory = 0.;     ///< of all ranks [byte]
    double seconds = 0.;         ///< processor time of the trial itself [s]
    double field_seconds = 0.;   ///< part of `seconds` for fields [s]
    double time = 0.;            ///< to which it came, simulated [s]
    double time_of_largest = 0.; ///< simulated, of the most cells [s]
    /// Completed part of the simulated time of its last stage, less than one
    /// if its time limit stopped it.
    double part = 1.;
    /// Whether it ended or was stopped in a first stage.
    bool lacks_stage = false;
    /// Holds what the trial wrote, on the first rank only.
    std::shared_ptr<TemporaryFolder> folder;

    /// Least part from which what is missing is extrapolated.
    static constexpr double least_part = 0.02;

    /// Whether a stage in space had but a few steps, as on cells that are too
    /// large to be refined, and so tells nothing of a finer one.
    bool has_few_steps() const
    {
      return std::any_of(
        stages.begin(), stages.end(), [](const TrialStage &stage) {
          return stage.dimension > 1 && stage.steps < 10.;
        });
    }

    /// Whether the mesh of the last stage changed, after enough steps in all.
    bool tells_of_finer() const
    {
      return !stages.empty() && !stages.back().is_constant() &&
             !has_few_steps();
    }

    bool is_stopped() const
    {
      return part < 1.;
    }

    /// Steps of the last stage, but for the last one, which is cut, over those
    /// that its first step would need.
    double step_growth() const;

    double output_bytes() const
    {
      return volume_bytes + plane_bytes + surface_bytes + table_bytes +
             other_bytes;
    }
  };

  /// The largest step_growth() of the last two trials; coarser ones have a few
  /// steps alone.
  inline double largest_step_growth(const std::vector<Trial> &trials)
  {
    double growth = 1.;
    for (std::size_t i = trials.size(); i > 0 && i + 2 > trials.size(); --i)
      growth = std::max(growth, trials[i - 1].step_growth());
    return growth;
  }

  /**
   * Runs a scene with 2^@p levels times larger cells to its end, silently,
   * with its output in a temporary folder. If the trial is
   * stopped after @p longest seconds of processor time, its cost is
   * extrapolated in proportion to the simulated time of its last stage.
   * Collective.
   * @param prm all entries of the scene
   * @return nothing if the scene cannot be that coarse, or if the trial failed
   */
  std::optional<Trial> try_run(const ApplicationDescription &description,
                               const dealii::ParameterHandler &prm,
                               unsigned int levels,
                               double longest,
                               Collective &collective);

  /// The plan of the scene with cells 8 times as large, or fewer times if it
  /// cannot be so coarse; empty if not at all. Collective.
  std::vector<Assumption> coarse_plan(const ApplicationDescription &description,
                                      const dealii::ParameterHandler &prm,
                                      Collective &collective);

  /// Draws the pictures of a trial that came to its end as the run would,
  /// silently; returns the wall time [s] and the size [byte]. Collective.
  std::pair<double, double>
  try_drawing(const ApplicationDescription &description,
              const Trial &trial,
              Collective &collective);
} // namespace io
} // namespace contrecoup
