// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>

#include <optional>
#include <utility>

namespace contrecoup
{
namespace io
{
  /// Environment variable that names the levels of trials.
  constexpr const char *trial_levels_variable = "CONTRECOUP_CHECK_LEVELS";

  /// Levels of the first and the last trial, "first last" in that variable, if
  /// it is set. Counted quantities are then the same on every machine.
  /// @throws InputError
  std::optional<std::pair<int, int>> trial_levels();

  /// Processor time for the trials of --check, from the environment variable
  /// CONTRECOUP_CHECK_SECONDS [s].
  double trial_seconds();

  /// Levels by which the first trial must be coarser to cost next to nothing,
  /// plus two, because the solver's estimate may be too low.
  /// @param budget time for the trials [s]
  unsigned int first_trial_levels(const CostEstimate &rough, double budget);
} // namespace io
} // namespace contrecoup
