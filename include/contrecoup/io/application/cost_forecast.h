// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/application/trial_run.h>
#include <contrecoup/io/run/cost_cache.h>

namespace contrecoup
{
namespace io
{
  /**
   * Predicts the cost of a scene on this machine from trial runs on coarser
   * meshes. Each trial has cells half as large as the previous one. The last
   * trial is the finest within @p budget seconds of processor time, or within
   * up to five budgets if they are a hundredth of the scene's cost, or if all
   * trials before were too coarse for the mesh to change. A scene cheaper than
   * that is run as it is, which gives the exact cost.
   *
   * The last two trials give, for each number of dimensions d that the mesh
   * has during the run:
   * - the number of steps as a + b 2^level, because the step size is
   *   proportional to the cell size; or as a - b 2^-level for a stage whose
   *   cells do not depend on the level, because it ends where coarser cells
   *   begin;
   * - the number of cells of a mesh that changes by extrapolate_cells(), and
   *   of others from the solver's estimate @p rough;
   * - the time of a step as a + b cells.
   *
   * Memory is that of the last trial plus, for each further cell, the increase
   * since the first trial, bounded to between once and twice the solver's
   * estimate: adaptation holds two meshes at once, and a body comes with the
   * mesh. Fields of the mesh grow with cells, what is recorded on a body like
   * its facets, tables like steps; pictures are those of the last trial.
   *
   * Unknown (zero) are cells, memory and output of a mesh that changes where
   * the last two trials refine nearly everything or have other stages, or where
   * there is one alone, the steps where the trials before the last one do
   * not predict its steps within a factor of 1.4, or are too few for that and
   * the last one stopped before half of its last stage, and the time if neither
   * is known. A trial that does not come to the last stage
   * of the run tells nothing, nor does one that its time limit stops before its
   * mesh is as large as it gets, by the trial before it; output is that of
   * trials that come to their end.
   *
   * If the environment variable CONTRECOUP_CHECK_LEVELS names the levels of a
   * first and a last trial, these are run regardless of time, so that cells,
   * steps, memory and output do not depend on the machine's speed.
   *
   * @param rough estimate of the solver without trial runs; used where trials
   * give no information
   */
  TriedCost forecast_cost(const ApplicationDescription &description,
                          const dealii::ParameterHandler &prm,
                          const CostEstimate &rough,
                          double budget,
                          Collective &collective);

  /// Forecast within CONTRECOUP_CHECK_SECONDS (environment variable, default 4
  /// s), or the cached cost of an earlier run on this machine. Logs which.
  TriedCost cached_or_forecast_cost(const ApplicationDescription &description,
                                    const dealii::ParameterHandler &prm,
                                    const CostEstimate &rough,
                                    Collective &collective);
} // namespace io
} // namespace contrecoup
