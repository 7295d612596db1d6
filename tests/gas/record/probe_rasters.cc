// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/record/recorders.h>
#include <contrecoup/io/file/vtk_input.h>
#include <contrecoup/numerics/injury/load_injury.h>

#include "../../set_entries.h"
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
class Rasters
{
public:
  Rasters(const std::vector<std::string> &lines,
          const MPI_Comm communicator = MPI_COMM_WORLD)
    : run(std::vector<std::string>{"Domain/Coarse leaves=2, 2, 2",
                                   "Domain/Initial refinement=2",
                                   "Adaptation/Active=true",
                                   "Adaptation/Largest level=3"} +
            finite_volume(4),
          communicator)
  {
    dealii::ParameterHandler prm;
    Recorders<dim>::declare_parameters(prm);
    set_entries(prm, lines);
    rasters.parse_parameters(prm, run);
  }

  /// Text of what save() would write.
  std::string saved()
  {
    rasters.reduce_over_ranks();
    std::ostringstream stream;
    rasters.save(stream, "");
    return stream.str();
  }

  GasRun<dim> run;
  ProbeRasters<dim> rasters;
};


std::string refusal(const std::string &line,
                    const std::vector<std::string> &others = {})
{
  std::vector<std::string> lines = others;
  lines.push_back(line);
  try
  {
    Rasters<2> rasters(lines);
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

/// A load and what it is, by the whole history.
struct History
{
  std::vector<double> times, overpressures;
  double load = 0.;
};


/// Lets probes record gas in which every place sees Friedlander's wave [Pa,
/// s], with a wind that later exceeds that of a shock.
History record_wave(Rasters<2> &scene,
                    const double peak,
                    const double duration,
                    const double step,
                    const unsigned int n_steps = 800)
{
  const double ambient = 101325.;
  History history{{0.}, {0.}, 0.};
  for (unsigned int i = 0; i < n_steps; ++i)
  {
    const double s = i * step / duration;
    const double overpressure = peak * (1. - s) * std::exp(-s);
    const double dynamic = i < 100 ? 0.3 * overpressure : 200e3;
    scene.run.set_state([&](const Point<2> &) {
      GasState<2> state;
      state.density = 1.2;
      state.pressure = ambient + overpressure;
      state.velocity[0] = std::sqrt(2. * dynamic / state.density);
      return state;
    });
    scene.run.time = (i + 1) * step;
    if (i == 0)
      scene.rasters.mesh_changed(scene.run.snapshot());
    scene.rasters.add_step(scene.run.snapshot(step));
    history.times.push_back(scene.run.time);
    history.overpressures.push_back(overpressure);
    if (overpressure > 0.)
      history.load =
        std::max(history.load,
                 overpressure +
                   std::min(dynamic, dynamic_pressure(overpressure, ambient)));
  }
  return history;
}


/// A field of a plane that is the same everywhere.
double uniform(const io::VtkInput &plane, const std::string &name)
{
  const auto values = plane.numbers(name);
  for (const double one : values)
    EXPECT_NEAR(one, values[0], 1e-9 * std::abs(values[0])) << name;
  return values[0];
}
} // namespace


TEST(ProbeRasters, WriteLinesAndPlanes)
{
  Rasters<3> scene({"Probes/Lines=0.1,0.5,0.5 : 0.9,0.5,0.5 : 9",
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
  scene.rasters.mesh_changed(scene.run.snapshot());
  scene.rasters.add_step(scene.run.snapshot(1e-3));
  const std::string folder = make_folder();
  scene.rasters.write(scene.run.snapshot(), folder);
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
            "arrival [s],duration [s],cut_off [-]");
  unsigned int n_rows = 0;
  while (std::getline(line, text))
  {
    std::vector<double> row;
    std::stringstream words(text);
    for (std::string word; std::getline(words, word, ',');)
      row.push_back(std::stod(word));
    ASSERT_EQ(row.size(), 8U);
    EXPECT_NEAR(row[0], 0.1 + 0.1 * n_rows, 1e-8);
    // Off by half a subcell at most, where probes stand at a leaf's rim.
    EXPECT_NEAR(row[3], 1e5 * row[0], 1e5 / 64.);
    EXPECT_NEAR(row[4], 1e-3 * row[3], 1e-8 * row[3]);
    EXPECT_NEAR(row[5], 1.5e-3, 1e-9);
    EXPECT_NEAR(row[6], 0.5e-3, 1e-9);
    EXPECT_EQ(row[7], 1.);
    ++n_rows;
  }
  EXPECT_EQ(n_rows, 9U);
  const io::VtkInput plane(folder + "/gauges_plane_1.vti");
  EXPECT_EQ(plane.extent(), "0 3 0 0 0 4");
  EXPECT_EQ(
    plane.names(),
    (std::vector<std::string>{
      "peak_overpressure", "impulse", "arrival", "duration", "cut_off"}));
  const auto peaks = plane.numbers("peak_overpressure");
  ASSERT_EQ(peaks.size(), 20U);
  for (unsigned int i = 0; i < 20; ++i)
    EXPECT_NEAR(peaks[i], 1e5 * (0.2 + 0.2 * (i % 4)), 1e5 / 64.);
  std::filesystem::remove_all(folder);
}


// Injuries that were accumulated step by step are those of the whole history.
TEST(ProbeRasters, InjuriesAreThoseOfTheHistory)
{
  const double peak = 300e3, step = 1e-5;
  Rasters<2> scene({"Probes/Gauge planes=0.2,0.1 : 0.8,0.9 : 2, 3",
                    "Probes/Injury=true",
                    "Loads/Body mass=70"},
                   MPI_COMM_SELF);
  const History history = record_wave(scene, peak, 4.005e-3, step);
  EXPECT_GT(history.load, 1.3 * peak * (1. - 1e-9));
  const std::string folder = make_folder();
  scene.rasters.write(scene.run.snapshot(), folder);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
  {
    const io::VtkInput plane(folder + "/gauges_plane_1.vti");
    const double phase =
      first_pulse(history.times, history.overpressures).duration;
    const LoadInjury whole =
      load_injury(history.times, history.overpressures, {peak, phase}, 70.);
    EXPECT_NEAR(uniform(plane, "eardrum_rupture"), whole.eardrum_rupture, 1e-9);
    EXPECT_GT(whole.chest_wall_velocity, 7.);
    EXPECT_NEAR(uniform(plane, "chest_wall_velocity"),
                whole.chest_wall_velocity,
                1e-6 * whole.chest_wall_velocity);
    // The middles of the first and the last step bound the positive phase.
    const double duration = uniform(plane, "duration");
    EXPECT_NEAR(duration, phase, 1.01 * step);
    const double exposure =
      history.load / lung_median_lethal_overpressure(duration, 70., 101325.);
    EXPECT_NEAR(uniform(plane, "lung_exposure"), exposure, 1e-6 * exposure);
    EXPECT_NEAR(uniform(plane, "lung_exposure"),
                whole.lung_exposure * history.load / peak,
                3e-3 * exposure);
    EXPECT_NEAR(uniform(plane, "lung_lethality"),
                lung_lethality_probability(exposure),
                1e-6);
  }
  std::filesystem::remove_all(folder);
}


// A run that ends while the chest wall gets faster has a lower limit of its
// velocity, and says where the blast continues.
TEST(ProbeRasters, MarkVelocitiesThatTheEndCutsOff)
{
  for (const unsigned int n_steps : {20U, 800U})
  {
    Rasters<2> scene(
      {"Probes/Gauge planes=0.2,0.1 : 0.8,0.9 : 2, 3", "Probes/Injury=true"},
      MPI_COMM_SELF);
    record_wave(scene, 300e3, 4.005e-3, 1e-5, n_steps);
    const bool is_cut = n_steps < 800;
    const auto gaps = scene.rasters.gaps(scene.run.time);
    EXPECT_EQ(gaps.size(), is_cut ? 1U : 0U);
    if (is_cut)
    {
      EXPECT_NE(gaps[0].find("0.2 ms; cut off in the positive phase: all 6"),
                std::string::npos)
        << gaps[0];
    }
    const std::string folder = make_folder();
    scene.rasters.write(scene.run.snapshot(), folder);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      const io::VtkInput plane(folder + "/gauges_plane_1.vti");
      for (const char *name : {"cut_off", "chest_wall_velocity_cut_off"})
        EXPECT_EQ(uniform(plane, name), is_cut ? 1. : 0.) << name;
      for (const char *name : {"lung_exposure", "first_phase_fraction"})
        EXPECT_EQ(std::isnan(plane.numbers(name)[0]), is_cut) << name;
    }
    std::filesystem::remove_all(folder);
  }
}


// The record of a first stage says nothing of the motion of a chest.
TEST(ProbeRasters, ChestsAreUnknownWhereAnEarlierStageHadTheBlast)
{
  Rasters<2> scene({"Probes/Lines=0.1,0.5 : 0.9,0.5 : 2", "Probes/Injury=true"},
                   MPI_COMM_SELF);
  BlastRecord<double> known;
  known.peak = 100e3;
  known.arrival = 1e-3;
  known.impulse = known.running = 100.;
  known.end = 3e-3;
  scene.run.time = 4e-3;
  scene.rasters.inherit(
    [&](const Point<2> &place) -> std::optional<BlastRecord<double>> {
      if (place[0] < 0.5)
        return known;
      return std::nullopt;
    },
    scene.run.snapshot());
  const std::string folder = make_folder();
  scene.rasters.write(scene.run.snapshot(), folder);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
  {
    std::ifstream line(folder + "/gauges_line_1.csv");
    std::string text;
    std::getline(line, text);
    EXPECT_EQ(text,
              "x [m],y [m],peak_overpressure [Pa],impulse [Pa s],arrival [s],"
              "duration [s],cut_off [-],lung_exposure [-],lung_lethality [-],"
              "eardrum_rupture [-],chest_wall_velocity [m/s],"
              "first_phase_fraction [-],chest_wall_velocity_cut_off [-]");
    std::getline(line, text);
    EXPECT_EQ(text.substr(text.size() - 10), ",nan,1,nan");
    std::vector<double> row;
    std::stringstream words(text);
    for (std::string word; std::getline(words, word, ',');)
      row.push_back(std::stod(word));
    // 78.5 kg are the default.
    EXPECT_EQ(row[6], 0.);
    EXPECT_NEAR(row[7],
                standing_load(100e3, 101325.) /
                  lung_median_lethal_overpressure(2e-3, 78.5, 101325.),
                1e-6);
    std::getline(line, text);
    EXPECT_EQ(text, "0.9,0.5,nan,nan,nan,nan,nan,nan,nan,nan,nan,nan,nan");
  }
  std::filesystem::remove_all(folder);
}


TEST(ProbeRasters, RanksAndCheckpointsDoNotChangeABit)
{
  const std::vector<std::string> lines = {
    "Probes/Injury=true",
    "Probes/Lines=0,0 : 1,1 : 23; 0.5,0 : 0.5,1 : 17",
    "Probes/Gauge planes=0,0 : 1,1 : 6, 7"};
  const auto start = [&](const MPI_Comm communicator) {
    auto scene = std::make_unique<Rasters<2>>(lines, communicator);
    scene->run.set_state([](const Point<2> &p) {
      GasState<2> state;
      state.density = 1.2;
      state.pressure = p.norm() < 0.4 ? 2e6 : 101325.;
      return state;
    });
    scene->rasters.mesh_changed(scene->run.snapshot());
    return scene;
  };
  const auto go = [](Rasters<2> &scene, const unsigned int n) {
    for (unsigned int i = 0; i < n; ++i)
    {
      const auto result = scene.run.step();
      scene.rasters.add_step(scene.run.snapshot(result.step));
      if (i % 3 == 2 && scene.run.adapt())
        scene.rasters.mesh_changed(scene.run.snapshot());
    }
  };
  const auto alone = start(MPI_COMM_SELF), together = start(MPI_COMM_WORLD);
  go(*alone, 12);
  go(*together, 12);
  const std::string middle = together->saved();
  EXPECT_EQ(alone->saved(), middle);

  // Records that were saved and loaded continue alike.
  go(*alone, 12);
  Rasters<2> fresh(lines);
  std::istringstream stream(middle);
  fresh.rasters.load(stream, "");
  EXPECT_TRUE(stream);
  EXPECT_EQ(fresh.saved(), middle);
  std::swap(together->rasters, fresh.rasters);
  together->rasters.mesh_changed(together->run.snapshot());
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
  EXPECT_EQ(refusal("Probes/Injury=true", {"Probes/Lines=0,0 : 1,1 : 3"}), "");
  EXPECT_EQ(refusal("Probes/Injury=true", {"Probes/Points=0.5, 0.5"}), "");
}
