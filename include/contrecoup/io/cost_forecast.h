// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/trial_run.h>

namespace contrecoup
{
namespace io
{
  /**
   * Predicts what a scene costs on this machine from trial runs of the same
   * scene on coarser meshes: each has cells half as large as the one before,
   * the last is the finest that @p budget seconds of processor time allow, and
   * up to five times as many where that is a hundredth of what the scene takes.
   * A scene that costs less than that is run as it is, which tells exactly.
   *
   * From the last two trials follow, for each number of dimensions d that the
   * mesh has during the run: the number of steps as a + b 2^level, for the
   * step size falls with that of the cells, or where a stage keeps its cells
   * as a - b 2^-level, for it ends where coarser cells begin; the cells as
   * those that @p rough says the scene begins with, at a body for instance, and
   * what the run adds to them as a 2^((d-1) level) + b 2^(d level), since
   * fronts that the mesh follows are surfaces and the rest is volume, with b =
   * 0 where it only begins to add some; and the time of a step as a + b cells.
   * Memory is what the last trial took and, for each further cell, what it took
   * more than the first, between once and twice what the solver says:
   * adaptation holds two meshes at once, and a body comes with the mesh. Fields
   * grow as cells do, tables as steps, and recorded loads with the facets of a
   * surface and the times at which they are taken.
   *
   * Where the environment's CONTRECOUP_CHECK_LEVELS is set to the levels of a
   * first and a last trial, these are run instead, however long they take, so
   * that cells, steps, memory and output do not depend on the machine's speed.
   *
   * @param rough what the solver says without trial runs; kept where these
   *   tell nothing
   */
  CostEstimate forecast_cost(const ApplicationDescription &description,
                             const dealii::ParameterHandler &prm,
                             const CostEstimate &rough,
                             double budget,
                             Collective &collective);

  /**
   * The same within the environment's CONTRECOUP_CHECK_SECONDS, 4 s unless
   * set, or as an earlier run on this machine found it. Says which.
   */
  CostEstimate known_cost(const ApplicationDescription &description,
                          const dealii::ParameterHandler &prm,
                          const CostEstimate &rough,
                          Collective &collective);

  /**
   * The value at @p levels levels after the last of a quantity
   * a 2^(low level) + b 2^(high level) with a, b >= 0 that was @p before @p gap
   * levels earlier and is @p last now. Without a value before (0) it grows by
   * the mean exponent; a quantity that grows more slowly than a 2^(low level)
   * goes on at its own rate, one that falls stays.
   */
  double extrapolate(double before,
                     double last,
                     unsigned int levels,
                     double low,
                     double high,
                     unsigned int gap = 1);

  /**
   * The value at @p levels levels after the last of a quantity a + b 2^-level
   * that was @p before @p gap levels earlier and is @p last now.
   */
  double extrapolate_to_limit(double before,
                              double last,
                              unsigned int levels,
                              unsigned int gap = 1);
} // namespace io
} // namespace contrecoup
