// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/scene_plan.h>
#include <contrecoup/coupling/task/task_files.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>
#include <contrecoup/io/output/history.h>

#include "fuzz.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace contrecoup;

namespace
{
std::string folder_of(const std::string &path)
{
  return std::filesystem::path(path).parent_path().string();
}

void prepare_record(const std::string &folder)
{
  coupling::TaskFiles(folder, "blast")
    .write_record(false, {"0123-key", "finished", 1.5, 3., 1e9, 2e6});
}

/// A damaged record counts as a stage that has not begun.
void read_record(const std::string &path)
{
  const coupling::TaskFiles files(folder_of(path), "blast");
  const coupling::TaskRecord record = files.read_record(false);
  files.complete_replace();
  if (record.status.empty() && !record.key.empty())
    throw std::runtime_error("it took a part of the record");
}


void prepare_summary(const std::string &folder)
{
  std::filesystem::create_directories(folder + "/blast");
  std::ofstream(folder + "/blast/summary.json")
    << "{\"status\": \"finished\", \"assumptions\":\n"
       " {\"non_ideal\": {\"decision\": \"jwl\", \"quantity\": \"part\",\n"
       "  \"unit\": \"-\", \"estimate\": 0.1, \"measured\": 0.2,\n"
       "  \"at_most\": 0.5, \"entry\": \"Material/Equation of state\"}}}\n";
}

void read_summary(const std::string &path)
{
  coupling::blast_plan(std::filesystem::path(folder_of(path)).parent_path());
}


void prepare_probes(const std::string &folder)
{
  std::filesystem::create_directories(folder + "/biomechanics");
  io::HistoryFile history(folder + "/biomechanics/probes.csv");
  history.start();
  for (const double x : {0.1, 1. / 3.})
    history.add_row({{"time", "s", x},
                     {"brain displacement_x", "m", 0.1 * x},
                     {"brain displacement_y", "m", 0.2 * x},
                     {"brain displacement_z", "m", 0.3 * x}});
}

/// Reads the results of the stages as a scene does in the end.
void read_results(const std::string &path)
{
  coupling::SceneParameters scene;
  scene.accuracy = coupling::SceneParameters::accuracies.front();
  scene.question = "injury";
  scene.symmetry = "auto";
  scene.explosive = find_explosive("tnt");
  scene.tissues = "physiological";
  scene.mass = 1.;
  scene.end_time = 0.01;
  scene.place = dealii::Point<3>(2., 0., 1.);
  const RoundedBox body(
    dealii::Point<3>(0., 0., 0.88), dealii::Point<3>(0.15, 0.25, 0.88), 0.05);
  static const coupling::SceneLayout layout(scene, body);
  static const auto plan = coupling::scene_plan(scene, layout, {}, 70., true);
  coupling::scene_audit(
    scene, layout, plan, std::filesystem::path(folder_of(path)).parent_path());
}
} // namespace


int main(int argc, char **argv)
{
  return fuzz::run(
    argc,
    argv,
    {{"stage_record", "blast.stage.json", prepare_record, read_record},
     {"stage_summary", "blast/summary.json", prepare_summary, read_summary},
     {"stage_results", "blast/summary.json", prepare_summary, read_results},
     {"stage_probes",
      "biomechanics/probes.csv",
      prepare_probes,
      read_results}});
}
