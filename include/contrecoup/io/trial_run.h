// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>
#include <contrecoup/io/application.h>

#include <optional>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// What a trial run did while its mesh had one number of dimensions.
  struct TrialStage
  {
    unsigned int dimension = 0;
    double steps = 0.;         ///< [-]
    double cell_steps = 0.;    ///< sum of the cells over the steps [-]
    double largest_cells = 0.; ///< [-]
    double seconds = 0.; ///< processor time of the slowest rank, no setup [s]
  };

  /// What a trial run did and cost.
  struct Trial
  {
    unsigned int levels = 0; ///< times that its cells were doubled
    std::vector<TrialStage> stages;
    double setup_seconds = 0.;  ///< of all stages [s]
    double output_seconds = 0.; ///< for fields [s]
    double field_bytes = 0.;    ///< of all fields [byte]
    double table_bytes = 0.;    ///< of history and probes [byte]
    double load_bytes = 0.;     ///< of recorded loads [byte]
    double known_cells = 0.;    ///< that the solver said it begins with [-]
    double unknowns_per_cell = 0.;
    double memory_per_cell = 0.; ///< that the solver says [byte]
    double peak_memory = 0.;     ///< that all ranks held at once [byte]
    double seconds = 0.;         ///< that it took itself [s]
    double field_seconds = 0.;   ///< of these for fields [s]
  };

  /**
   * Runs a scene with cells 2^@p levels times larger to its end, with all its
   * output in a temporary folder that is removed; says nothing. What a run
   * that was stopped after @p longest seconds of wall time lacks is added in
   * proportion to the simulated time. Collective.
   * @param prm every entry of the scene
   * @return nothing when the scene cannot be that coarse, when it failed, or
   *   when it was stopped before a fiftieth of its time
   */
  std::optional<Trial> try_run(const ApplicationDescription &description,
                               const dealii::ParameterHandler &prm,
                               unsigned int levels,
                               double longest,
                               Collective &collective);
} // namespace io
} // namespace contrecoup
