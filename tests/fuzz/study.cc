// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/io/output/history.h>
#include <contrecoup/study/error_measure.h>
#include <contrecoup/study/outcome.h>

#include "fuzz.h"
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

using namespace contrecoup;

namespace
{
const std::string who = study::identity("blast", "1", 2, {{"A/B", "1"}});

void prepare_outcome(const std::string &folder)
{
  study::Outcome outcome;
  outcome.kind = "timed out";
  outcome.reason = "it was ended at the time limit";
  outcome.wall_seconds = 1.5;
  outcome.time_limit = 1.;
  study::write_outcome(folder + "/outcome.json", outcome, who);
}

void read_outcome(const std::string &path)
{
  study::read_outcome(path, who, 1.);
}


void prepare_summary(const std::string &folder)
{
  std::ofstream(folder + "/summary.json")
    << "{\"status\": \"finished\", \"retries\": 2,\n"
       " \"message\": \"x\", \"performance\": {\"core_seconds\": 1.5}}\n";
}

/// Judges the run as one that ended well, and as one that was refused.
void read_summary(const std::string &path)
{
  const std::string folder = path.substr(0, path.rfind('/'));
  study::judge({0, 0}, false, folder, folder + "/errors");
  study::judge({1, 0}, false, folder, folder + "/errors");
}


/// The deviation of a run from a reference run.
double deviation(const std::string &quantity,
                 const std::string &name,
                 const std::string &run,
                 const std::string &reference)
{
  dealii::ParameterHandler prm;
  study::ErrorMeasure::declare_parameters(prm);
  const auto assign = [](const std::string &entry, const std::string &value) {
    return Assignment{{"Error"}, entry, value, "fuzz"};
  };
  apply_assignments({assign("Kind", "reference run"),
                     assign("Quantity", quantity),
                     assign("Name", name),
                     assign("Reference folder", reference)},
                    prm);
  study::ErrorMeasure measure;
  measure.parse_parameters(prm);
  return measure.value(run, {{"conservation", {{"mass_last", 1.}}}});
}

void prepare_reference(const std::string &folder)
{
  std::filesystem::create_directories(folder + "/reference");
  std::ofstream(folder + "/reference/summary.json")
    << "{\"status\": \"finished\",\n \"conservation\": {\"mass_first\": 1,"
       " \"mass_last\": 1.25e-3}}\n";
}

void read_reference(const std::string &path)
{
  const std::string folder = std::filesystem::path(path).parent_path().string();
  deviation("summary", "conservation.mass_last", folder, folder);
}


void prepare_probes(const std::string &folder)
{
  std::filesystem::create_directories(folder + "/reference");
  std::ofstream(folder + "/reference/summary.json") << "{}\n";
  for (const char *file : {"/probes.csv", "/reference/probes.csv"})
  {
    io::HistoryFile history(folder + file);
    history.start();
    for (const double x : {0.1, 0.2, 1. / 3., 0.5})
      history.add_row({{"time", "s", x}, {"left ear", "Pa", x * (1. - x)}});
  }
}

/// Each measure of the damaged table, which is the run's, against a whole one.
void read_probes(const std::string &path)
{
  const std::string folder = std::filesystem::path(path).parent_path().string();
  for (const char *quantity : {"probe peak",
                               "probe lowest",
                               "probe impulse",
                               "probe arrival",
                               "probe curve"})
    deviation(quantity, "left ear", folder, folder + "/reference");
}
} // namespace


int main(int argc, char **argv)
{
  return fuzz::run(argc,
                   argv,
                   {{"outcome", "outcome.json", prepare_outcome, read_outcome},
                    {"summary", "summary.json", prepare_summary, read_summary},
                    {"reference_summary",
                     "reference/summary.json",
                     prepare_reference,
                     read_reference},
                    {"probes", "probes.csv", prepare_probes, read_probes}});
}
