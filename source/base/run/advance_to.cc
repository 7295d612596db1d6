// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/run/advance_to.h>
#include <contrecoup/base/run/time_control.h>

namespace contrecoup
{
std::uint64_t advance_to(Simulation &simulation, const double end)
{
  TimeParameters parameters;
  parameters.end_time = end;
  const TimeControl control(parameters);
  RunState state;
  state.time = simulation.time();
  while (!control.finished(state))
  {
    const double bound = control.bound(state);
    const StepReport report = simulation.advance(bound);
    control.after_step(state, simulation.time(), report.step_size, bound);
    simulation.adapt();
  }
  return state.step;
}
} // namespace contrecoup
