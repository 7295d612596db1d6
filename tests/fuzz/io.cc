// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/plane_file.h>
#include <contrecoup/io/file/vtk_input.h>
#include <contrecoup/io/output/checkpoint.h>
#include <contrecoup/io/output/history.h>
#include <contrecoup/io/output/history_reader.h>
#include <contrecoup/io/output/load_reader.h>
#include <contrecoup/io/output/manifest.h>
#include <contrecoup/io/run/cost_cache.h>
#include <contrecoup/io/run/run_description.h>

#include "fuzz.h"

#include <cstdlib>
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
  loads.create(
    {{0., 0., 0., 1., 0., 0.}, {-1., 0., 0., 1., 0., 0.}, {1., 2.}, {}},
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

void prepare_history(const std::string &folder)
{
  io::HistoryFile history(folder + "/history.csv");
  history.start();
  for (const double x : {0.1, 1. / 3.})
    history.add_row({{"time", "s", x}, {"left ear", "Pa", 7. * x}});
}

void read_history(const std::string &path)
{
  io::read_history(path).column("left ear", path);
}


void prepare_array(const std::string &folder)
{
  io::PlaneSamples plane;
  plane.axes = {{0, 2}};
  plane.n_points = {{2, 3}};
  plane.fields = {{"pressure", "Pa", {1., 2., 3., 4., 5., 6.}}};
  io::write_plane(folder + "/plane.vti", plane);
}

void read_array(const std::string &path)
{
  const io::VtkInput plane(path);
  for (const std::string &name : plane.names())
    plane.numbers(name);
}


void prepare_cost(const std::string &folder)
{
  setenv("XDG_CACHE_HOME", folder.c_str(), 1);
  const io::CostCache cache("a scene");
  cache.write({{1., 2., 3., 4., 5., 6., ""}});
  std::filesystem::copy_file(cache.file(), folder + "/cost.json");
}

/// A damaged cache of costs counts as missing.
void read_cost(const std::string &path)
{
  setenv(
    "XDG_CACHE_HOME", std::filesystem::path(path).parent_path().c_str(), 1);
  const io::CostCache cache("a scene");
  std::filesystem::copy_file(
    path, cache.file(), std::filesystem::copy_options::overwrite_existing);
  cache.read();
}


void prepare_run(const std::string &folder)
{
  io::RunDescription run;
  run.application = "blast";
  run.parameters = {{"Time/End time", "1"}};
  run.fields = {{0.5, "", "fields_1"}};
  run.first_values = {{"mass", "kg", 1., true}};
  io::write_file(folder + "/run.json",
                 [&](std::ostream &out) { out << io::to_text(run); });
}

void read_run(const std::string &path)
{
  io::from_text(io::read_file(path));
}


io::FileNames names_of_run()
{
  return {{"loads.h5", "fields/plane_*.vti"}, {"log.txt", "inner/"}};
}

void prepare_manifest(const std::string &folder)
{
  for (const char *file : {"/loads.h5", "/log.txt", "/foreign.txt"})
    io::write_file(folder + file,
                   [](std::ostream &out) { out << "some content"; });
  std::filesystem::create_directories(folder + "/inner");
  io::Manifest(folder + "/inner").begin("blast", {{"a.csv"}, {}}, {});
  io::Manifest manifest(folder);
  manifest.begin("scene", names_of_run(), {{{"Time/End time", "1"}}, {}});
  io::write_file(folder + "/loads.h5",
                 [](std::ostream &out) { out << "the loads"; });
  manifest.set_status("finished");
}

/// A damaged one must not claim what is elsewhere, where it would be removed.
void read_manifest(const std::string &path)
{
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const io::Manifest manifest(folder);
  manifest.foreign_files(names_of_run());
  manifest.damage();
  const std::string inside = std::filesystem::canonical(folder).string() + "/";
  for (const std::string &file : manifest.own_files())
    if (std::filesystem::weakly_canonical(folder + "/" + file)
          .string()
          .compare(0, inside.size(), inside) != 0)
      throw std::runtime_error("it claims " + file);
}


/// Reads the newest checkpoint of the file's folder, which has but this one.
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
     {"history", "history.csv", prepare_history, read_history},
     {"array", "plane.vti", prepare_array, read_array},
     {"cost", "cost.json", prepare_cost, read_cost},
     {"run", "run.json", prepare_run, read_run},
     {"manifest", "manifest.json", prepare_manifest, read_manifest},
     {"checkpoint_marker",
      "0001/complete.json",
      prepare_checkpoint,
      read_checkpoint},
     {"checkpoint_state", "0001/state", prepare_checkpoint, read_checkpoint}});
}
