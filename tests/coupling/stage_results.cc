// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/afterburn_items.h>
#include <contrecoup/coupling/scene/coarser_run.h>
#include <contrecoup/coupling/scene/scene_plan.h>
#include <contrecoup/coupling/scene/stage_results.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/io/output/history.h>
#include <contrecoup/io/run/plan_table.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <tuple>
#include <utility>

using namespace contrecoup;
using namespace contrecoup::coupling;
using dealii::Point;

namespace
{
SceneParameters small_scene()
{
  SceneParameters scene;
  scene.accuracy = SceneParameters::accuracies.front();
  scene.question = "injury";
  scene.symmetry = "none";
  scene.explosive = find_explosive("tnt");
  scene.tissues = "physiological";
  scene.mass = 1.;
  scene.end_time = 0.01;
  scene.element_size = 0.01;
  scene.place = Point<3>(2., 0., 1.);
  return scene;
}

SceneLayout box_layout(const SceneParameters &scene)
{
  return {scene,
          RoundedBox(Point<3>(0., 0., 0.9), Point<3>(0.15, 0.25, 0.9), 0.05)};
}

/// Writes the results of a body of 2 kg without probes whose speed along
/// x grows by 3 m/s in 10 ms.
void write_biomechanics(const std::string &folder, const std::string &items)
{
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/summary.json")
    << R"({"assumptions": {)" << items << R"(},
          "results": {"peak": {"value": 9, "unit": "Pa"}},
          "checks": {"loads_impulse_factor": {"value": 1.05, "unit": "-"}}})";
  io::HistoryFile history(folder + "/history.csv");
  history.start();
  for (int step = 0; step <= 10; ++step)
    history.add_row({{"time", "s", 1e-3 * step},
                     {"mass", "kg", 2.},
                     {"momentum_x", "N s", 0.6 * step},
                     {"momentum_y", "N s", 0.},
                     {"momentum_z", "N s", 0.}});
}

const std::string strained_gelatin =
  R"("strain": {"decision": "any rotation, small strains",
     "quantity": "strain of gelatin", "unit": "-", "estimate": null,
     "at_most": 0.1, "measured": 0.49, "holds": false,
     "entry": "Elements/Kinematics"})";

Assumption item_of(const std::vector<Assumption> &items,
                   const std::string &name)
{
  const Assumption *item = io::find_assumption(items, name);
  if (item == nullptr)
    throw std::runtime_error("no item " + name);
  return *item;
}
} // namespace


TEST(StageResults, FindTheMotionOfABodyWithoutProbes)
{
  const io::TemporaryFolder folder;
  EXPECT_TRUE(std::isnan(measure_motion(folder.path(), 1.).displacement));
  write_biomechanics(folder.path(), "");
  EXPECT_EQ(stage_result(folder.path(), "peak"), 9.);
  EXPECT_TRUE(std::isnan(stage_result(folder.path(), "loads_impulse_factor")));
  const BodyMotion motion = measure_motion(folder.path(), 8e-3);
  EXPECT_NEAR(motion.speed, 3., 1e-12);
  EXPECT_NEAR(motion.displacement, 0.5 * 300. * 8e-3 * 8e-3, 1e-12);
  // A probe moves farther than the centre of mass, and swings faster.
  io::HistoryFile probes(folder.path() + "/probes.csv");
  probes.start();
  for (const double time : {0., 1e-3, 9e-3})
    probes.add_row({{"time", "s", time},
                    {"probe_1_displacement_x", "m", 30. * time},
                    {"probe_1_displacement_y", "m", 40. * time},
                    {"probe_1_displacement_z", "m", 0.},
                    {"probe_1_velocity_x", "m/s", 0.},
                    {"probe_1_velocity_y", "m/s", 50.},
                    {"probe_1_velocity_z", "m/s", 0.}});
  probes.flush();
  // Between rows it goes straight.
  EXPECT_NEAR(measure_motion(folder.path(), 8e-3).displacement, 0.4, 1e-12);
  EXPECT_NEAR(measure_motion(folder.path(), 8e-3).speed, 3., 1e-12);
}


TEST(SceneAudit, JudgesStrainAndMotionOfAnyBody)
{
  const SceneParameters scene = small_scene();
  const SceneLayout layout = box_layout(scene);
  const io::TemporaryFolder folder;
  write_biomechanics(folder.path() + "/biomechanics", strained_gelatin);
  const auto audit = [&](const std::vector<Assignment> &wrote) {
    return scene_audit(scene,
                       layout,
                       scene_plan(scene, layout, wrote, 2., false),
                       folder.path());
  };
  const Assumption strain = item_of(audit({}), "strain");
  EXPECT_EQ(strain.value, 0.49);
  EXPECT_TRUE(strain.fails());
  EXPECT_EQ(strain.quantity, "strain of gelatin");
  EXPECT_EQ(strain.entry, "Biomechanics/Elements/Kinematics");
  EXPECT_GT(item_of(audit({}), "rigid_body").value, 0.);
  EXPECT_EQ(item_of(audit({}), "rigid_body").entry, "");
  const Assumption held = item_of(
    audit({parse_override("Biomechanics/Supports/Support neck/Where=z < 1")}),
    "rigid_body");
  EXPECT_EQ(held.value, item_of(audit({}), "rigid_body").value);
  EXPECT_EQ(held.entry, "Biomechanics/Supports");
  EXPECT_EQ(held.quantity,
            "displacement of the held body during the positive phase over its "
            "depth");
  EXPECT_NEAR(item_of(audit({}), "gravity_of_body").value,
              9.81 * scene.end_time / 3.,
              1e-12);
  // The box stands on the ground.
  const Assumption ground = item_of(audit({}), "ground_of_body");
  EXPECT_EQ(ground.value, layout.body.lower_bound(2));
  EXPECT_EQ(ground.entry, "Biomechanics/Ground/Active");
  const auto with_ground =
    audit({parse_override("Biomechanics/Ground/Active=true")});
  EXPECT_EQ(io::find_assumption(with_ground, "ground_of_body"), nullptr);
  // Where loads are the question nothing moves the body, which is said.
  SceneParameters of_loads = scene;
  of_loads.question = "loads";
  const auto rows = scene_audit(of_loads,
                                layout,
                                scene_plan(of_loads, layout, {}, 2., false),
                                folder.path());
  EXPECT_TRUE(std::isnan(item_of(rows, "rigid_body").value));
  EXPECT_EQ(item_of(rows, "rigid_body").limit,
            item_of(audit({}), "rigid_body").limit);
  // A law for large strains has no such limit.
  const std::vector<Assignment> wrote{
    parse_override("Biomechanics/Elements/Kinematics=neo-hookean"),
    parse_override("Biomechanics/Gravity/Acceleration=0, 0, -9.81")};
  const auto large = audit(wrote);
  const Assumption planned =
    item_of(scene_plan(scene, layout, wrote, 2., false), "strain");
  EXPECT_TRUE(std::isnan(planned.limit));
  EXPECT_EQ(planned.decision, "any rotation and strain");
  EXPECT_EQ(item_of(large, "gravity_of_body").decision, "0, 0, -9.81 m/s^2");
}


// The tables have the phase of 1 kg next to the box, but not that of 1 mg.
TEST(ScenePlan, KnowsCellsInAPositivePhaseOfTheTablesAlone)
{
  SceneParameters scene = small_scene();
  for (const double mass : {1., 1e-6})
  {
    scene.mass = mass;
    const SceneLayout layout = box_layout(scene);
    EXPECT_EQ(
      std::isfinite(
        item_of(scene_plan(scene, layout, {}, 2., false), "resolution").value),
      mass == 1.);
  }
}


// A plate of 1 m by 2 m and 0.2 m below, next to or behind the charge.
TEST(ScenePlan, MovesABodyByTheAreaThatTheChargeSees)
{
  SceneParameters scene = small_scene();
  const auto moved = [&](const Point<3> &half, const Point<3> &place) {
    scene.place = place;
    const SceneLayout layout(scene,
                             RoundedBox(Point<3>(0., 0., half[2]), half, 0.01));
    return item_of(scene_plan(scene, layout, {}, 70., false), "rigid_body")
      .value;
  };
  const double before = moved({0.1, 0.5, 1.}, {2.1, 0., 1.});
  EXPECT_NEAR(moved({0.5, 0.1, 1.}, {0., 2.1, 1.}), before, 1e-6 * before);
  EXPECT_NEAR(moved({1., 0.5, 0.1}, {0., 0., 2.2}), before, 1e-6 * before);
  EXPECT_NEAR(
    moved({0.5, 0.1, 1.}, {2.5, 0., 1.}), 0.2 * before, 1e-6 * before);
}


// By the study of their bias, at 1.5 m/kg^(1/3) the positive phase of PETN is
// 48 % shorter than that of the tables, and that of TNT 6 % longer.
TEST(ScenePlan, CountsCellsInThePositivePhaseOfTheModel)
{
  SceneParameters scene = small_scene();
  scene.place = Point<3>(1.65, 0., 1.);
  scene.has_usual_afterburn = true;
  for (const auto &[name, bias] :
       {std::pair("tnt", 0.06), {"petn 1.77", -0.48}})
  {
    scene.explosive = find_explosive(name);
    const SceneLayout layout = box_layout(scene);
    const double phase = layout.incident_wave(scene).value(
      BlastQuantity::duration, layout.distance);
    const Assumption cells =
      item_of(scene_plan(scene, layout, {}, 70., false), "resolution");
    EXPECT_NEAR(cells.value,
                340. * (1. + bias) * phase / layout.cell_size(),
                1e-6 * cells.value)
      << name;
    // Finer cells hold what coarser ones would not.
    EXPECT_FALSE(cells.fails()) << name;
  }
}


// Without afterburn the plan tells what it would add, which is nothing for a
// balanced explosive alone.
TEST(ScenePlan, TellsWhatAfterburnThatIsLeftOutWouldAdd)
{
  for (const char *const name : {"tnt", "anfo"})
  {
    SceneParameters scene = small_scene();
    scene.explosive = find_explosive(name);
    const SceneLayout layout = box_layout(scene);
    for (const char *const item : {"afterburn_peak", "afterburn_impulse"})
    {
      const auto rise = [&](const double energy) {
        scene.afterburn = energy;
        return item_of(scene_plan(scene, layout, {}, 2., false), item).value;
      };
      const double usual = scene.explosive.afterburn.energy;
      EXPECT_EQ(rise(0.) > 0.05, usual > 0.) << name;
      EXPECT_NEAR(rise(0.), rise(usual), 1e-12) << name;
    }
  }
}


// Its oxygen is known of no explosive with values of the user's own.
TEST(ScenePlan, TellsNoAfterburnOfLikeAsThatOfTheUsersExplosive)
{
  SceneParameters scene = small_scene();
  scene.explosive = find_explosive("anfo");
  scene.has_usual_afterburn = true;
  const auto planned = [&](const char *const item) {
    return item_of(scene_plan(scene, box_layout(scene), {}, 2., false), item);
  };
  EXPECT_EQ(planned("afterburn").decision, "left out, by explosive");
  EXPECT_EQ(planned("afterburn_peak").value, 0.);
  scene.custom_entries = {{"Like", "anfo"}, {"Energy density", "4e9"}};
  EXPECT_EQ(planned("afterburn").decision,
            "left out by the values of ANFO (Like); it is unknown for this "
            "explosive");
  for (const char *const item : {"afterburn_peak", "afterburn_impulse"})
    EXPECT_TRUE(std::isnan(planned(item).value)) << item;
  // ANFO burns with 2.67 MJ/kg.
  EXPECT_EQ(warn_of_energy(scene), "");
  scene.explosive.jwl.energy_density = 4e9;
  EXPECT_NE(warn_of_energy(scene).find(
              "4.3 MJ/kg, exceeds the heat of combustion, 2.67 MJ/kg, which is "
              "that of ANFO (Like)"),
            std::string::npos)
    << warn_of_energy(scene);
  scene.afterburn = 1e6;
  scene.explosive.afterburn.largest = 2e6;
  EXPECT_EQ(planned("afterburn").decision,
            "1 of at most 2 MJ/kg by the heat of combustion of ANFO (Like), "
            "Miller's rate, by Like");
  EXPECT_GT(planned("afterburn_peak").value, 0.);
}


// A phase that is longer than expected is measured, too; one with a later wave,
// and one that the end of the run cuts, tell nothing of the cells in the first.
TEST(SceneAudit, MeasuresCellsInAPhaseWithoutLaterWavesAlone)
{
  const SceneParameters scene = small_scene();
  const SceneLayout layout = box_layout(scene);
  ASSERT_TRUE(layout.probe.has_value());
  const auto plan = scene_plan(scene, layout, {}, 2., false);
  const double expected = item_of(plan, "resolution").value;
  const io::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() + "/blast");
  const double part = 1.2, arrival = 2e-3;
  const double end = arrival + part * layout.positive_phase;
  for (const auto &[later, cut_off, gap] :
       {std::tuple{1.1 * end, 0., ""},
        {0.9 * end, 0., "that at the probe is of several waves"},
        {1.1 * end, 1., "the run ends before that at the probe does"}})
  {
    std::ofstream(folder.path() + "/blast/summary.json")
      << R"({"results": {"probe_1_duration": {"value": )"
      << part * layout.positive_phase << R"(}, "probe_1_arrival": {"value": )"
      << arrival << R"(}, "probe_1_cut_off": {"value": )" << cut_off
      << R"(}, "probe_1_later_peak_time": {"value": )" << later << "}}}";
    const Assumption found =
      item_of(scene_audit(scene, layout, plan, folder.path()), "resolution");
    const std::string quantity =
      "number of cells in the positive phase of the wave at the body";
    if (*gap == '\0')
    {
      EXPECT_NEAR(found.value, part * expected, 1e-5 * expected);
      EXPECT_EQ(found.quantity, quantity);
    }
    else
    {
      EXPECT_TRUE(std::isnan(found.value)) << found.value;
      EXPECT_EQ(found.quantity, quantity + ", not measured, since " + gap);
    }
  }
}


TEST(SceneAudit, ComparesTheSkinInTheGasWithThatOfTheBody)
{
  const SceneParameters scene = small_scene();
  const SceneLayout layout = box_layout(scene);
  const auto plan = scene_plan(scene, layout, {}, 2., false);
  const io::TemporaryFolder folder;
  const auto audit = [&]() {
    return item_of(scene_audit(scene, layout, plan, folder.path()), "skin");
  };
  EXPECT_TRUE(std::isnan(item_of(plan, "skin").value));
  EXPECT_TRUE(std::isnan(audit().value));
  for (const char *const stage : {"/anatomy", "/blast"})
    std::filesystem::create_directories(folder.path() + stage);
  std::ofstream(folder.path() + "/anatomy/summary.json")
    << R"({"surface_projections": 1.56})";
  for (const auto &[area, is_missing] : {std::pair{1.09, true}, {1.5, false}})
  {
    std::ofstream(folder.path() + "/blast/summary.json")
      << R"({"checks": {"loads_skin_projections": {"value": )" << area
      << R"(, "unit": "m^2"}}})";
    EXPECT_NEAR(audit().value, area / 1.56, 1e-12);
    EXPECT_EQ(audit().fails(), is_missing);
  }
}


// Whether one factor keeps the impulse is decided once, for both runs.
TEST(CoarserRun, CorrectsTheImpulseAsTheSceneDoes)
{
  using Words = std::vector<std::string>;
  const io::TemporaryFolder folder;
  write_biomechanics(folder.path(), "");
  EXPECT_EQ(CoarserRun::same_correction_of_loads(folder.path()),
            (Words{"--set", "Loads/Recorded/Largest correction=1"}));
  std::ofstream(folder.path() + "/summary.json")
    << R"({"checks": {"loads_impulse_factor": {"value": 1.0, "unit": "-"}}})";
  EXPECT_EQ(CoarserRun::same_correction_of_loads(folder.path()),
            (Words{"--set", "Loads/Recorded/Keep impulse=false"}));
}
