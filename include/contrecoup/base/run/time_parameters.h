// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <cstdint>

namespace contrecoup
{
/// End of a run and times of output: subsections "Time" and "Output".
struct TimeParameters
{
  double end_time = 1.;
  double largest_step = 0.;                  ///< 0: no bound
  std::uint64_t largest_number_of_steps = 0; ///< 0: no bound
  std::uint64_t steps_in_this_run = 0;       ///< 0: no bound
  double minutes_in_this_run = 0.;           ///< wall time, 0: no bound
  std::uint64_t history_every_steps = 1;
  double history_interval = 0.; ///< 0: by steps
  std::uint64_t probes_every_steps = 1;
  bool fields = true;
  double fields_interval = 0.;              ///< 0: start and end only
  std::uint64_t fields_every_steps = 0;     ///< 0: off
  std::uint64_t checkpoint_every_steps = 0; ///< 0: off
  double checkpoint_every_minutes = 0.;     ///< 0: off
  bool checkpoint_at_the_end = false;

  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);
};

} // namespace contrecoup
