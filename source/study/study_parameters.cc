// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/study/study_parameters.h>

#include <filesystem>
#include <thread>

namespace contrecoup::study
{
namespace
{
  void declare_what(ParameterHandler &prm)
  {
    declare_string(
      prm,
      "Title",
      "",
      "Title of tables and pictures; empty: name of the parameter file.");
    declare_string(
      prm,
      "Application",
      "blast",
      "Application under study: a program in the folder of this one.");
    declare_file(
      prm,
      "Parameter file",
      "",
      "Parameter file of the application, from which all variants start.");
    declare_string(
      prm,
      "Settings",
      "",
      "Entries overridden in all variants: \"Section/Entry=value; ...\".");
    declare_string(
      prm,
      "Columns",
      "",
      selecting("Outputs of the runs for tables and curves, separated by "
                "\";\": results.NAME, a path in summary.json; "
                "STAGE/results.NAME, that of a stage of a scene; "
                "FILE.json:PATH; FILE.csv:ROW:COLUMN, of a history "
                "FILE.csv:FEATURE:COLUMN with first, last, largest, "
                "smallest, peak, lowest, impulse or arrival. \"*\" stands "
                "for any letters; \"ADDRESS as TITLE\" names a column; "
                "\"ADDRESS if any\" may be missing in runs."));
    declare_selection(prm,
                      "Mode",
                      "work precision",
                      {"work precision", "stability map"},
                      "work precision: error against cost; stability map: "
                      "outcome of each variant over two factors.");
    declare_selection(prm,
                      "Design",
                      "full grid",
                      {"full grid", "one at a time", "latin hypercube"},
                      "Combinations that are run: all; the first value of "
                      "every factor and those that differ from it in one "
                      "factor; or random ones, spread evenly over each "
                      "factor.");
  }

  void declare_samples(ParameterHandler &prm)
  {
    const UsedWith used("Study/Design = latin hypercube");
    declare_integer(prm,
                    "Samples",
                    "16",
                    1,
                    100000,
                    "Number of variants of a Latin hypercube.");
    declare_integer(prm,
                    "Seed",
                    "1",
                    0,
                    std::numeric_limits<int>::max(),
                    "Seed of the random numbers of a Latin hypercube.");
  }

  void declare_how(ParameterHandler &prm)
  {
    declare_integer(prm,
                    "Ranks",
                    "1",
                    1,
                    100000,
                    "MPI ranks of each run; mpirun starts more than one.");
    declare_integer(prm,
                    "Cores",
                    "1",
                    0,
                    100000,
                    "Cores for all concurrent runs; 0: all of this machine. "
                    "Concurrent runs share memory bandwidth and caches, "
                    "which affects their cost.");
    declare_double(prm,
                   "Time limit",
                   "0",
                   0.,
                   bounds::time,
                   "s",
                   "Wall time after which a run is ended and counts as "
                   "timed out; 0: none.");
    declare_selection(prm,
                      "Cost",
                      "core seconds",
                      {"core seconds", "wall seconds", "updates", "memory"},
                      "Cost of a run: processor time of all ranks, wall "
                      "time, number of updated unknowns or elements in all "
                      "steps and stages (independent of the machine), or "
                      "peak memory.");
  }
} // namespace

void StudyParameters::declare_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Study");
    declare_what(prm);
    declare_samples(prm);
    declare_how(prm);
  }
  ErrorMeasure::declare_parameters(prm);
  const Section section(prm, "Vary *");
  Factor::declare_parameters(prm);
}

void StudyParameters::require_effect() const
{
  for (const auto &setting : settings)
    for (const Factor &factor : factors)
      for (std::size_t i = 0; i < factor.entries.size(); ++i)
        if (factor.entries[i] == setting.first && factor.always_sets(i))
          throw InputError(
            "Study/Settings: \"" + setting.first +
            "\" has no effect, since \"Vary " + factor.name +
            "\" sets it in each run" +
            (error.reference_settings()
               ? "; what the reference run alone has stands in Error/Reference"
               : ""));
}

void StudyParameters::parse_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Study");
    title = prm.get("Title");
    application = prm.get("Application");
    parameter_file = prm.get("Parameter file");
    settings = parse_settings(prm.get("Settings"), "Study/Settings");
    columns = parse_columns(prm.get("Columns"));
    mode = prm.get("Mode");
    design.kind = prm.get("Design");
    design.samples = read_unsigned(prm, "Samples");
    design.seed = read_unsigned(prm, "Seed");
    ranks = read_unsigned(prm, "Ranks");
    cores = read_unsigned(prm, "Cores");
    time_limit = read_double(prm, "Time limit");
    cost = prm.get("Cost");
  }
  error.parse_parameters(prm);
  factors = parse_factors(prm);
  require_effect();
  if (!std::filesystem::is_regular_file(parameter_file))
    throw InputError("Study/Parameter file: cannot read \"" + parameter_file +
                     "\"");
  if (cores == 0)
    cores = std::max(1U, std::thread::hardware_concurrency());
  if (ranks > cores)
    throw InputError("Study/Ranks = " + std::to_string(ranks) +
                     " is more than Study/Cores = " + std::to_string(cores));
  bool refines = false;
  for (const Factor &factor : factors)
    refines = refines || factor.refinement != Refinement::none;
  if (error.is_self_convergence() && !refines)
    throw InputError("Error/Kind = self convergence needs a subsection \"Vary "
                     "*\" with a Refinement");
  if (mode == "stability map" &&
      (factors.size() != 2 || design.kind != "full grid"))
    throw InputError("Study/Mode = stability map needs two subsections \"Vary "
                     "*\" and Study/Design = full grid");
}
} // namespace contrecoup::study
