// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/bounds.h>
#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/text.h>
#include <contrecoup/study/study_parameters.h>

#include <filesystem>
#include <thread>

namespace contrecoup::study
{
namespace
{
  void declare_what(ParameterHandler &prm)
  {
    declare_string(prm,
                   "Title",
                   "",
                   "A few words above tables and pictures; empty: the name of "
                   "the parameter file.");
    declare_string(prm,
                   "Application",
                   "blast",
                   "The application whose accuracy is studied: the name of a "
                   "program beside this one.");
    declare_file(prm,
                 "Parameter file",
                 "",
                 "The application's parameter file, which all variants start "
                 "from.");
    declare_string(prm,
                   "Settings",
                   "",
                   "Entries that all variants override: "
                   "\"Section/Entry=value; ...\".");
    declare_string(prm,
                   "Columns",
                   "",
                   "Numbers of summary.json that study.csv and study.md have "
                   "as well, for the reference run too: dotted paths as in "
                   "\"assumptions.loads_chest_peak; ...\".");
    declare_selection(prm,
                      "Mode",
                      "work precision",
                      {"work precision", "stability map"},
                      "Whether error is drawn against cost, or what became of "
                      "each variant over the plane of two factors.");
    declare_selection(prm,
                      "Design",
                      "full grid",
                      {"full grid", "one at a time", "latin hypercube"},
                      "Which combinations are run: all; the first value of "
                      "every factor and those that differ from it in one; or "
                      "random ones, spread evenly over each factor.");
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
                    "Start of the random numbers of a Latin hypercube.");
  }

  void declare_how(ParameterHandler &prm)
  {
    declare_integer(prm,
                    "Ranks",
                    "1",
                    1,
                    100000,
                    "MPI ranks of each run; more than one are started by "
                    "mpirun.");
    declare_integer(prm,
                    "Cores",
                    "1",
                    0,
                    100000,
                    "Cores that all runs side by side may take together; 0: "
                    "all of this machine. Runs side by side share memory "
                    "and caches, which shows in their cost.");
    declare_double(prm,
                   "Time limit",
                   "0",
                   0.,
                   bounds::time,
                   "s",
                   "Wall time after which a run is ended and counts as timed "
                   "out; 0: none.");
    declare_selection(prm,
                      "Cost",
                      "core seconds",
                      {"core seconds", "wall seconds", "updates", "memory"},
                      "What a run costs: processor time of all its ranks, "
                      "wall time, unknowns or elements updated in all steps "
                      "and stages, whatever the machine, "
                      "or peak memory.");
  }
} // namespace

void StudyParameters::declare_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Study");
    declare_what(prm);
    declare_how(prm);
  }
  ErrorMeasure::declare_parameters(prm);
  const Section section(prm, "Vary *");
  Factor::declare_parameters(prm);
}

void StudyParameters::parse_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Study");
    title = prm.get("Title");
    application = prm.get("Application");
    parameter_file = prm.get("Parameter file");
    settings = parse_settings(prm.get("Settings"), "Study/Settings");
    columns.clear();
    for (const std::string &column : split(prm.get("Columns"), ';'))
      if (!column.empty())
        columns.push_back(column);
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
