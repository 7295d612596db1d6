// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameter_tree.h>
#include <contrecoup/geometry/body_description.h>
#include <contrecoup/io/checked_file.h>
#include <contrecoup/io/checkpoint.h>
#include <contrecoup/io/load_reader.h>

#include "fuzz.h"

#include <filesystem>

using namespace contrecoup;

namespace
{
void prepare_parameters(const std::string &folder)
{
  io::write_file(folder + "/other.prm",
                 [](std::ostream &out) { out << "set Stature = 1.8\n"; });
  io::write_file(folder + "/run.prm", [](std::ostream &out) {
    out << "# A man.\nset Kind = phantom\nsubsection Phantom\n"
           "  include other.prm\n  set Mass = 80 # kg\nend\n"
           "set Shift = 0, 1.5, \\\n  2\nset Scale = 1.1\n";
  });
}

void read_parameters(const std::string &path)
{
  dealii::ParameterHandler prm;
  BodyDescription::declare_parameters(prm);
  apply_assignments(read_assignments(path), prm);
  BodyDescription body;
  body.parse_parameters(prm);
  parameter_text(prm, true);
}


void prepare_loads(const std::string &folder)
{
  io::LoadFile loads(folder + "/loads.h5");
  loads.create({{0., 0., 0., 1., 0., 0.}, {-1., 0., 0., 1., 0., 0.}, {1., 2.}},
               {{"application", "fuzz"}});
  loads.append({1e-3, 2e-3}, {100.F, 10.F, 300.F, 30.F});
}

void read_loads(const std::string &path)
{
  const io::LoadReader reader(path);
  for (std::size_t i = 0; i < reader.times().size(); i += 64)
    reader.read(i, std::min<std::size_t>(64, reader.times().size() - i));
}


void prepare_checkpoint(const std::string &folder)
{
  Collective collective(MPI_COMM_SELF);
  io::Checkpoints(folder, collective)
    .write("{\"step\": 3}", [](const std::string &here) {
      io::write_file(here + "/state",
                     [](std::ostream &out) { out << "the state"; });
    });
}

/// Of the folder that the file is in, which has but this checkpoint.
void read_checkpoint(const std::string &path)
{
  Collective collective(MPI_COMM_SELF);
  io::Checkpoints(
    std::filesystem::path(path).parent_path().parent_path().string(),
    collective)
    .newest();
}
} // namespace


int main(int argc, char **argv)
{
  return fuzz::run(
    argc,
    argv,
    {{"parameters", "run.prm", prepare_parameters, read_parameters},
     {"loads", "loads.h5", prepare_loads, read_loads},
     {"checkpoint_marker",
      "0001/complete.json",
      prepare_checkpoint,
      read_checkpoint},
     {"checkpoint_state", "0001/state", prepare_checkpoint, read_checkpoint}});
}
