// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/base/run/time_control.h>
#include <contrecoup/io/run/run_description.h>

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Content of summary.json.
  struct Summary
  {
    std::string application;
    std::string status;  ///< finished, stopped, failed
    std::string message; ///< why it failed
    RunState state;
    RunStarts starts;
    unsigned int ranks = 1;
    std::uint64_t cells = 0;
    std::uint64_t unknowns = 0;
    std::vector<NamedValue> first_values;
    std::vector<NamedValue> last_values;
    std::vector<NamedValue> errors;
    std::vector<NamedValue> results;
    std::vector<NamedValue> checks;
    std::vector<Assumption> plan;  ///< with estimates
    std::vector<Assumption> audit; ///< with measurements
  };

  /// Takes over size, errors, results, checks and audit. Collective.
  void describe(Simulation &simulation, Summary &summary);

  /**
   * Text of summary.json, of all starts. "wall_seconds" at the top has setup
   * and output, that under "performance" is of the time loop alone, as are the
   * rates of updates; "core_seconds" there is the processor time of all ranks,
   * "largest_cells" the largest number of cells. For each conserved quantity Q
   * of the history, "conservation" has Q_first, Q_last and Q_relative_change =
   * (last - first) / |first|. Values that are not finite become null.
   * "resumed_from_step" is the step of the checkpoint from which this start
   * resumed, null for a new run; "interruptions" has step and time of each such
   * checkpoint. "results" and "checks" have an object with value and unit for
   * each name. "assumptions" has for each item of the audit an object with
   * decision, quantity, unit, estimate, measured value, limit, whether it holds
   * (null without a limit, and without a measured value unless the estimate
   * breaks the limit), and the entry that changes the decision.
   */
  std::string to_text(const Summary &summary);
} // namespace io
} // namespace contrecoup
