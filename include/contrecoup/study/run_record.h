// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <limits>
#include <string>
#include <vector>

namespace contrecoup::study
{
/**
 * Facts and costs of a run. For a scene, whose output folder has a summary for
 * each stage, numbers are the sums over its stages, and the memory is the
 * largest. NaN: not known.
 */
struct RunRecord
{
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  std::string status;  ///< finished, stopped, failed; empty: no record
  std::string message; ///< reason of a failure
  double cells = unknown, unknowns = unknown, steps = unknown;
  double retries = unknown;
  double wall_seconds = unknown; ///< [s]
  double core_seconds = unknown;
  double updates = unknown;
  double memory = unknown;           ///< [byte]
  std::vector<std::string> warnings; ///< each once; of scenes of all stages
};

/// Reads the record of the run in @p folder from its summary.json, or from
/// manifest.json and scene.json. Never throws.
RunRecord read_record(const std::string &folder);
} // namespace contrecoup::study
