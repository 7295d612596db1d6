// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/record/probe_rasters.h>
#include <contrecoup/io/file/vtk_input.h>

#include "gas_run.h"
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
template <int dim>
class Gauges
{
public:
  Gauges(const std::vector<std::string> &lines,
         const MPI_Comm communicator = MPI_COMM_WORLD)
    : run(std::vector<std::string>{"Domain/Coarse leaves=2, 2, 2",
                                   "Domain/Initial refinement=2",
                                   "Adaptation/Active=true",
                                   "Adaptation/Largest level=3"} +
            finite_volume(4),
          communicator)
  {
    dealii::ParameterHandler prm;
    ProbeRasters<dim>::declare_parameters(prm);
    std::vector<Assignment> assignments;
    for (const std::string &line : lines)
      assignments.push_back(parse_override(line));
    apply_assignments(assignments, prm);
    gauges.parse_parameters(prm, run);
  }

  /// Text of what save() would write.
  std::string saved()
  {
    gauges.reduce_over_ranks();
    std::ostringstream stream;
    gauges.save(stream, "");
    return stream.str();
  }

  GasRun<dim> run;
  ProbeRasters<dim> gauges;
};


std::string refusal(const std::string &line)
{
  try
  {
    Gauges<2> gauges({line});
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}


/// A temporary folder.
std::string make_folder()
{
  const auto path = std::filesystem::temp_directory_path() /
                    ("contrecoup_gauges_" + std::to_string(getpid()));
  std::filesystem::create_directory(path);
  return path.string();
}
} // namespace


TEST(ProbeRasters, WriteLinesAndPlanes)
{
  Gauges<3> scene({"Probes/Lines=0.1,0.5,0.5 : 0.9,0.5,0.5 : 9",
                   "Probes/Gauge planes=0.2,0.5,0.1 : 0.8,0.5,0.9 : 4, 5"},
                  MPI_COMM_SELF);
  // The pressure depends on x alone, linearly, from the background's one.
  scene.run.set_state([](const Point<3> &p) {
    GasState<3> state;
    state.density = 1.2;
    state.pressure = 101325. + 1e5 * p[0];
    return state;
  });
  scene.run.time = 2e-3;
  scene.gauges.mesh_changed(scene.run.snapshot());
  scene.gauges.add_step(scene.run.snapshot(1e-3));
  const std::string folder = make_folder();
  scene.gauges.write(scene.run.snapshot(), folder);
  // The first of all ranks alone writes.
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
  {
    std::filesystem::remove_all(folder);
    return;
  }

  std::ifstream line(folder + "/gauges_line_1.csv");
  std::string text;
  std::getline(line, text);
  EXPECT_EQ(text,
            "x [m],y [m],z [m],peak_overpressure [Pa],impulse [Pa s],"
            "arrival [s],duration [s]");
  unsigned int n_rows = 0;
  while (std::getline(line, text))
  {
    std::vector<double> row;
    std::stringstream words(text);
    for (std::string word; std::getline(words, word, ',');)
      row.push_back(std::stod(word));
    ASSERT_EQ(row.size(), 7U);
    EXPECT_NEAR(row[0], 0.1 + 0.1 * n_rows, 1e-8);
    // Off by half a subcell at most, where gauges stand at a leaf's rim.
    EXPECT_NEAR(row[3], 1e5 * row[0], 1e5 / 64.);
    EXPECT_NEAR(row[4], 1e-3 * row[3], 1e-8 * row[3]);
    EXPECT_NEAR(row[5], 1.5e-3, 1e-9);
    EXPECT_NEAR(row[6], 0.5e-3, 1e-9);
    ++n_rows;
  }
  EXPECT_EQ(n_rows, 9U);
  const io::VtkInput plane(folder + "/gauges_plane_1.vti");
  EXPECT_EQ(plane.extent(), "0 3 0 0 0 4");
  EXPECT_EQ(plane.names(),
            (std::vector<std::string>{
              "peak_overpressure", "impulse", "arrival", "duration"}));
  const auto peaks = plane.numbers("peak_overpressure");
  ASSERT_EQ(peaks.size(), 20U);
  for (unsigned int i = 0; i < 20; ++i)
    EXPECT_NEAR(peaks[i], 1e5 * (0.2 + 0.2 * (i % 4)), 1e5 / 64.);
  std::filesystem::remove_all(folder);
}


TEST(ProbeRasters, RanksAndCheckpointsDoNotChangeABit)
{
  const std::vector<std::string> lines = {
    "Probes/Lines=0,0 : 1,1 : 23; 0.5,0 : 0.5,1 : 17",
    "Probes/Gauge planes=0,0 : 1,1 : 6, 7"};
  const auto start = [&](const MPI_Comm communicator) {
    auto scene = std::make_unique<Gauges<2>>(lines, communicator);
    scene->run.set_state([](const Point<2> &p) {
      GasState<2> state;
      state.density = 1.2;
      state.pressure = p.norm() < 0.4 ? 2e6 : 101325.;
      return state;
    });
    scene->gauges.mesh_changed(scene->run.snapshot());
    return scene;
  };
  const auto go = [](Gauges<2> &scene, const unsigned int n) {
    for (unsigned int i = 0; i < n; ++i)
    {
      const auto result = scene.run.step();
      scene.gauges.add_step(scene.run.snapshot(result.step));
      if (i % 3 == 2 && scene.run.adapt())
        scene.gauges.mesh_changed(scene.run.snapshot());
    }
  };
  const auto alone = start(MPI_COMM_SELF), together = start(MPI_COMM_WORLD);
  go(*alone, 12);
  go(*together, 12);
  const std::string middle = together->saved();
  EXPECT_EQ(alone->saved(), middle);

  // Records that were saved and loaded go on alike.
  go(*alone, 12);
  Gauges<2> fresh(lines);
  std::istringstream stream(middle);
  fresh.gauges.load(stream, "");
  EXPECT_TRUE(stream);
  EXPECT_EQ(fresh.saved(), middle);
  std::swap(together->gauges, fresh.gauges);
  together->gauges.mesh_changed(together->run.snapshot());
  go(*together, 12);
  EXPECT_EQ(alone->saved(), together->saved());
}


TEST(ProbeRasters, RefuseWhatCannotBeRead)
{
  EXPECT_EQ(refusal("Probes/Lines="), "");
  EXPECT_EQ(refusal("Probes/Lines=0,0 : 1,1 : 3; 0,1 : 1,0 : 2"), "");
  EXPECT_NE(refusal("Probes/Lines=0,0 : 1,1"), "");
  EXPECT_NE(refusal("Probes/Lines=0,0 : 1,1,1 : 3"), "");
  EXPECT_NE(refusal("Probes/Lines=0,0 : 1,one : 3"), "");
  EXPECT_NE(refusal("Probes/Lines=0,0 : 1,1 : 1"), "");
  EXPECT_NE(refusal("Probes/Lines=0,0 : 1,1 : 2.5"), "");
  EXPECT_NE(refusal("Probes/Lines=0,0 : 2,1 : 3"), "");
  EXPECT_EQ(refusal("Probes/Gauge planes=0,0 : 1,1 : 3, 4"), "");
  EXPECT_NE(refusal("Probes/Gauge planes=0,0 : 1,1 : 3"), "");
  EXPECT_NE(refusal("Probes/Gauge planes=0,0 : 0,1 : 3, 4"), "");
}
