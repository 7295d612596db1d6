// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/study/outcome.h>

#include "fuzz.h"

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

/// Of the run that ended well, and of one that was refused.
void read_summary(const std::string &path)
{
  const std::string folder = path.substr(0, path.rfind('/'));
  study::judge({0, 0}, false, folder, folder + "/errors");
  study::judge({1, 0}, false, folder, folder + "/errors");
}
} // namespace


int main(int argc, char **argv)
{
  return fuzz::run(
    argc,
    argv,
    {{"outcome", "outcome.json", prepare_outcome, read_outcome},
     {"summary", "summary.json", prepare_summary, read_summary}});
}
