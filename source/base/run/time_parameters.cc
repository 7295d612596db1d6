// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>

namespace contrecoup
{
namespace
{
  constexpr int many = std::numeric_limits<int>::max();

  void declare_time(ParameterHandler &prm)
  {
    const Section section(prm, "Time");
    declare_double(prm,
                   "End time",
                   "1",
                   1e-15,
                   bounds::time,
                   "s",
                   "Simulated time at the end, above 0.");
    declare_double(prm,
                   "Largest step",
                   "0",
                   0.,
                   bounds::time,
                   "s",
                   "Upper bound of the step size; 0: only the bound of the "
                   "solver.");
    declare_integer(
      prm,
      "Largest number of steps",
      "0",
      0,
      many,
      "The run is finished after this number of steps; 0: no bound.");
    declare_integer(prm,
                    "Steps in this run",
                    "0",
                    0,
                    many,
                    "Writes a checkpoint and stops after this number of "
                    "steps from start or resume; 0: no bound.");
    declare_double(prm,
                   "Minutes in this run",
                   "0",
                   0.,
                   1e6,
                   "min",
                   "Writes a checkpoint and stops after this wall time from "
                   "start or resume; 0: no bound.");
  }

  void declare_tables(ParameterHandler &prm)
  {
    const Section section(prm, "Output");
    declare_integer(prm,
                    "History every steps",
                    "1",
                    1,
                    many,
                    "Steps between rows of history.csv.");
    declare_double(
      prm,
      "History interval",
      "0",
      0.,
      bounds::time,
      "s",
      "Simulated time between rows of history.csv, met exactly; 0: by steps.");
    declare_integer(prm,
                    "Probes every steps",
                    "1",
                    1,
                    many,
                    "Steps between rows of probes.csv.");
  }

  void declare_fields(ParameterHandler &prm)
  {
    const Section section(prm, "Output");
    declare_bool(
      prm,
      "Fields",
      "true",
      "Whether fields are written; if so, at least at start and end.");
    declare_double(
      prm,
      "Fields interval",
      "0",
      0.,
      bounds::time,
      "s",
      used_with("Output/Fields = true",
                "Simulated time between field outputs, met exactly; 0: "
                "none between start and end."));
    declare_integer(prm,
                    "Fields every steps",
                    "0",
                    0,
                    many,
                    used_with("Output/Fields = true",
                              "Steps between field outputs; 0: not by steps."));
  }

  void declare_checkpoints(ParameterHandler &prm)
  {
    const Section section(prm, "Output");
    declare_integer(prm,
                    "Checkpoint every steps",
                    "0",
                    0,
                    many,
                    "Steps between checkpoints; 0: not by steps.");
    declare_double(prm,
                   "Checkpoint every minutes",
                   "30",
                   0.,
                   1e6,
                   "min",
                   "Wall time between checkpoints; 0: not by wall time.");
    declare_bool(prm,
                 "Checkpoint at the end",
                 "false",
                 "Whether a finished run writes a checkpoint, for resuming "
                 "with a later end time.");
  }
} // namespace

void TimeParameters::declare_parameters(ParameterHandler &prm)
{
  declare_time(prm);
  declare_tables(prm);
  declare_fields(prm);
  declare_checkpoints(prm);
}

void TimeParameters::parse_parameters(ParameterHandler &prm)
{
  {
    Section section(prm, "Time");
    end_time = read_double(prm, "End time");
    largest_step = read_double(prm, "Largest step");
    largest_number_of_steps = read_unsigned(prm, "Largest number of steps");
    steps_in_this_run = read_unsigned(prm, "Steps in this run");
    minutes_in_this_run = read_double(prm, "Minutes in this run");
  }
  Section section(prm, "Output");
  history_every_steps = read_unsigned(prm, "History every steps");
  history_interval = read_double(prm, "History interval");
  probes_every_steps = read_unsigned(prm, "Probes every steps");
  fields = prm.get_bool("Fields");
  fields_interval = read_double(prm, "Fields interval");
  fields_every_steps = read_unsigned(prm, "Fields every steps");
  checkpoint_every_steps = read_unsigned(prm, "Checkpoint every steps");
  checkpoint_every_minutes = read_double(prm, "Checkpoint every minutes");
  checkpoint_at_the_end = prm.get_bool("Checkpoint at the end");
  for (const double interval : {history_interval, fields_interval})
    if (interval > 0. && end_time / interval > 1e9)
      throw InputError("an output interval of " + brief(interval) +
                       " s makes more than 1e9 outputs until the end time " +
                       brief(end_time) + " s");
}
} // namespace contrecoup
