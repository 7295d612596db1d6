// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/table_comparison.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>
#include <contrecoup/io/file/temporary_folder.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <tuple>

using namespace contrecoup;
using namespace contrecoup::coupling;
using dealii::Point;

namespace
{
SceneParameters scene_of(const std::string &explosive, const double height)
{
  SceneParameters scene;
  scene.accuracy = SceneParameters::accuracies[0];
  scene.explosive = find_explosive(explosive);
  scene.mass = 1.;
  scene.place = Point<3>(2.15, 0., height);
  scene.end_time = 0.01;
  scene.symmetry = "none";
  return scene;
}


SceneLayout layout_of(const SceneParameters &scene, const OwnGrid &own = {})
{
  return {scene,
          RoundedBox(Point<3>(0., 0., 0.9), Point<3>(0.15, 0.25, 0.9), 0.05),
          {},
          own};
}


/// A domain that ends at the distance @p gap behind the charge.
OwnGrid domain_behind(const SceneParameters &scene, const double gap)
{
  OwnGrid own;
  own.lower = Point<3>(-2.56, -2.56, 0.);
  own.upper = Point<3>((*scene.place)[0] + gap, 2.56, 2.56);
  return own;
}


const std::vector<ChosenSide> wall_behind{{"x high", "wall", 0, true}};


/// Writes what a blast finds at its probe: the tables' values times @p factor,
/// the duration times one of its own, whether the end of the run cuts the
/// positive phase, and how many times its peak a later wave has.
void write_blast(const std::string &folder,
                 const TableAnswer &tables,
                 const double factor,
                 const bool is_cut = false,
                 const double of_duration = 1.,
                 const double of_later_peak = 1.)
{
  std::filesystem::create_directories(folder);
  const double peak = tables.in_the_open.overpressure;
  std::ofstream(folder + "/summary.json")
    << R"({"results": {"probe_1_first_peak_overpressure": {"value": )"
    << factor * peak << R"(}, "probe_1_peak_overpressure": {"value": )"
    << of_later_peak * factor * peak
    << R"(}, "probe_1_later_peak_overpressure": {"value": )"
    << of_later_peak * factor * peak
    << R"(}, "probe_1_later_peak_time": {"value": )" << tables.arrival + 1e-4
    << R"(}, "probe_1_reference_peak_overpressure": {"value": )" << peak
    << R"(}, "probe_1_impulse": {"value": )" << factor * tables.impulse
    << R"(}, "probe_1_arrival": {"value": )" << tables.arrival
    << R"(}, "probe_1_duration": {"value": )"
    << (is_cut ? factor : of_duration) * tables.duration
    << (is_cut ? R"(}, "probe_1_cut_off": {"value": 1}}})" : "}}}");
  std::ofstream file(folder + "/probe_injury.csv");
  file << "measure,place,value,unit,definition\n";
  if (!is_cut)
    file << "lung_exposure,probe 1,"
         << factor * tables.in_the_open.lung_exposure
         << ",-,\"\"\nlung_lethality,probe 1,0.25,-,\"\"\n";
}


/// Warning for a blast that has @p fine times the values of the tables, and
/// whose coarser run has @p coarse times them.
std::string warning_for(const SceneParameters &scene,
                        const double fine,
                        const double coarse,
                        const bool is_cut = false)
{
  const SceneLayout layout = layout_of(scene);
  const auto tables = table_answer(scene, layout, 70.);
  const io::TemporaryFolder folder;
  write_blast(folder.path() + "/blast", *tables, fine, is_cut);
  if (coarse > 0.)
    write_blast(folder.path() + "/coarser_blast", *tables, coarse);
  return warning_of(
    compare_with_tables(scene, layout, 70., folder.path(), coarse > 0.),
    scene.explosive);
}
} // namespace


TEST(TableComparison, WarnsOfDifferencesBeyondTheErrorsOfBoth)
{
  const SceneParameters tnt = scene_of("tnt", 3.);
  EXPECT_EQ(warning_for(tnt, 0.95, 0.), "");
  EXPECT_EQ(warning_for(tnt, 1.05, 1.), "");
  const std::string warning = warning_for(tnt, 0.6, 0.59);
  EXPECT_EQ(warning.find("WARNING: beside the body, run and tables of Kingery "
                         "and Bulmash differ by more than what is known of "
                         "their errors: "
                         "incident peak "),
            0U)
    << warning;
  EXPECT_NE(warning.find("; impulse "), std::string::npos) << warning;
  EXPECT_NE(warning.find("; death by lung injury in the open 25 % against "),
            std::string::npos)
    << warning;
  // A value that is lower because the run has ended does not differ.
  const std::string cut = warning_for(tnt, 0.6, 0.59, true);
  EXPECT_NE(cut.find("incident peak "), std::string::npos) << cut;
  for (const char *part : {"; impulse ", "; duration ", "lung injury"})
    EXPECT_EQ(cut.find(part), std::string::npos) << cut;
  // One that is larger all the same is told as the lower limit that it is.
  const std::string above = warning_for(tnt, 3., 2.9, true);
  EXPECT_NE(above.find("; impulse at least "), std::string::npos) << above;
  EXPECT_EQ(warning_for(tnt, 3., 2.9).find("at least"), std::string::npos);
  // Cells of half the size may give what is missing.
  EXPECT_EQ(warning_for(tnt, 0.8, 0.65), "");
}


TEST(TableComparison, SaysWhereTheEquivalenceIsAnEstimate)
{
  const SceneParameters other = scene_of("composition b", 3.);
  EXPECT_EQ(warning_for(other, 0.85, 0.), "");
  const std::string warning = warning_for(other, 0.6, 0.);
  EXPECT_NE(warning.find("(as 1.15 times its mass of TNT: ratio of detonation "
                         "energies, an estimate, not measured)"),
            std::string::npos)
    << warning;
  // The error is unknown of each quantity; probabilities have none.
  EXPECT_NE(warning.find(" kPa (numerical error unknown) against "),
            std::string::npos)
    << warning;
  EXPECT_NE(warning.find("25 % against "), std::string::npos) << warning;
}


// Two runs can agree by chance, and errors of peak and duration cancel in the
// load.
TEST(TableComparison, HasErrorsOfAtLeastTwoPerCentAndThoseOfThePeak)
{
  const SceneParameters tnt = scene_of("tnt", 3.);
  const SceneLayout layout = layout_of(tnt);
  const auto tables = table_answer(tnt, layout, 70.);
  const io::TemporaryFolder folder;
  write_blast(folder.path() + "/blast", *tables, 0.9);
  const auto errors = [&](const bool has_coarser_run = true) {
    std::map<std::string, double> found;
    for (const ComparedQuantity &one :
         compare_with_tables(tnt, layout, 70., folder.path(), has_coarser_run))
      found[one.name] = one.run_error;
    return found;
  };
  EXPECT_TRUE(std::isnan(errors().at("peak_overpressure")));
  write_blast(folder.path() + "/coarser_blast", *tables, 0.9);
  // That of another scene, or one that was stopped, tells nothing.
  EXPECT_TRUE(std::isnan(errors(false).at("peak_overpressure")));
  EXPECT_EQ(errors().at("impulse"), 0.02);
  EXPECT_TRUE(std::isnan(errors().at("lung_lethality")));
  // The coarser run differs in the peak alone.
  std::filesystem::copy(folder.path() + "/blast/probe_injury.csv",
                        folder.path() + "/probe_injury.csv");
  write_blast(folder.path() + "/coarser_blast", *tables, 0.8);
  std::filesystem::rename(folder.path() + "/probe_injury.csv",
                          folder.path() + "/coarser_blast/probe_injury.csv");
  EXPECT_GT(errors().at("peak_overpressure"), 0.1);
  EXPECT_EQ(errors().at("lung_exposure"), errors().at("peak_overpressure"));
}


// As next to the products of an explosive: the error of the load is then at
// least that of the peak, and no error is invented.
TEST(TableComparison, DoesNotExceedErrorsThatAreUnknown)
{
  const SceneParameters tnt = scene_of("tnt", 3.);
  const SceneLayout layout = layout_of(tnt);
  const auto tables = table_answer(tnt, layout, 70.);
  const io::TemporaryFolder folder;
  const auto load = [&](const double fine, const double coarse) {
    write_blast(folder.path() + "/blast", *tables, fine);
    write_blast(folder.path() + "/coarser_blast", *tables, coarse);
    std::filesystem::remove(folder.path() + "/coarser_blast/probe_injury.csv");
    for (const ComparedQuantity &one :
         compare_with_tables(tnt, layout, 70., folder.path(), true))
      if (one.name == "lung_exposure")
        return one;
    return ComparedQuantity();
  };
  const ComparedQuantity within = load(0.8, 0.65), beyond = load(0.6, 0.59);
  EXPECT_TRUE(std::isnan(within.run_error) && std::isnan(beyond.run_error));
  EXPECT_FALSE(within.differs);
  EXPECT_TRUE(beyond.differs);
}


// Probabilities that read the same are the same.
TEST(TableComparison, DoesNotTellProbabilitiesApartThatReadTheSame)
{
  const SceneParameters tnt = scene_of("tnt", 3.);
  const SceneLayout layout = layout_of(tnt);
  auto tables = table_answer(tnt, layout, 70.);
  const io::TemporaryFolder folder;
  write_blast(folder.path() + "/blast", *tables, 0.6);
  for (const auto &[probability, expected] :
       {std::pair{"0.25", true}, std::pair{"1e-50", false}})
  {
    std::ofstream(folder.path() + "/blast/probe_injury.csv")
      << "measure,place,value,unit,definition\nlung_exposure,probe 1,"
      << 0.6 * tables->in_the_open.lung_exposure
      << ",-,\"\"\nlung_lethality,probe 1," << probability << ",-,\"\"\n";
    for (const ComparedQuantity &one :
         compare_with_tables(tnt, layout, 70., folder.path(), true))
      if (one.name == "lung_exposure")
      {
        EXPECT_TRUE(one.differs);
      }
      else if (one.name == "lung_lethality")
      {
        EXPECT_EQ(one.differs, expected) << one.run << " " << one.tables;
      }
  }
}


// The front of a high charge comes alone; that of a low one has merged with
// its reflection, which raises the peak. Reflections that follow raise impulses
// in any case.
TEST(TableComparison, LeavesToTheGroundWhatItMayAdd)
{
  const std::string high = warning_for(scene_of("tnt", 3.), 1.4, 0.);
  EXPECT_NE(high.find("incident peak"), std::string::npos) << high;
  EXPECT_EQ(high.find("impulse"), std::string::npos) << high;
  EXPECT_EQ(warning_for(scene_of("tnt", 0.5), 1.4, 0.), "");
  // A wave that has merged is shorter near the charge alone, whether cells
  // lower its peak or not.
  for (const double distance : {0.85, 2.})
    for (const double peak : {0.9, 1.1})
    {
      SceneParameters scene = scene_of("tnt", 0.25);
      scene.place = Point<3>(0.15 + distance, 0., 0.25);
      const SceneLayout layout = layout_of(scene);
      const auto tables = table_answer(scene, layout, 70.);
      const io::TemporaryFolder folder;
      write_blast(folder.path() + "/blast", *tables, peak, false, 0.7);
      const std::string warning = warning_of(
        compare_with_tables(scene, layout, 70., folder.path(), false),
        scene.explosive);
      EXPECT_EQ(warning.find("duration ") == std::string::npos, distance < 1.)
        << warning;
    }
}


// The wave of a charge that is close to a wall is one with its reflection, and
// that of a charge 1 m before the wall is not.
TEST(TableComparison, LeavesToAWallWhatItMayAdd)
{
  const SceneParameters scene = scene_of("tnt", 1.5);
  for (const double gap : {0.1, 1.})
  {
    const SceneLayout layout = layout_of(scene, domain_behind(scene, gap));
    const auto tables = table_answer(scene, layout, 70.);
    const io::TemporaryFolder folder;
    write_blast(folder.path() + "/blast", *tables, 1.4);
    const auto rows = compare_with_tables(
      scene, layout, 70., folder.path(), false, wall_behind);
    ASSERT_EQ(rows.front().name, "peak_overpressure");
    EXPECT_EQ(rows.front().differs, gap == 1.);
    const auto reflections =
      reflections_at_probe(scene, layout, wall_behind, folder.path());
    ASSERT_EQ(reflections.size(), 2U);
    EXPECT_EQ(reflections[0].plane, "ground");
    EXPECT_EQ(reflections[1].plane,
              gap == 1. ? "wall at x = 3.15 m" : "wall at x = 2.25 m");
    EXPECT_FALSE(reflections[0].merges);
    EXPECT_EQ(reflections[1].merges, gap < 1.);
  }
}


// Two runs with cells of 40 mm have the peak of the reflection by the ground
// this long after the incident wave, which is slower than the reflection in the
// flow behind it.
TEST(TableComparison, KnowsWhenAReflectionComes)
{
  for (const auto &[explosive, mass, delay] :
       {std::tuple{"c-4", 1., 1.554e-3}, {"petn 1.50", 0.5, 1.606e-3}})
  {
    SceneParameters scene = scene_of(explosive, 1.2);
    scene.mass = mass;
    scene.place = Point<3>(3.14, 0., 1.2);
    const SceneLayout layout = layout_of(scene);
    const auto found =
      reflections_at(scene, layout, {}, layout.nearest_skin).front();
    EXPECT_GT(found.least_delay, 0.1 * layout.arrival);
    EXPECT_LT(found.least_delay, delay);
    EXPECT_GT(found.largest_delay, delay);
    EXPECT_FALSE(found.merges);
  }
}


// The reflection by the ground may come later and be larger: the tables have
// the peak of the first wave.
TEST(TableComparison, IsOfTheFirstPeak)
{
  const auto compare = [](const double height,
                          const double factor,
                          const double of_later_peak,
                          const std::string &eardrum) {
    const SceneParameters scene = scene_of("tnt", height);
    const SceneLayout layout = layout_of(scene);
    const auto tables = table_answer(scene, layout, 70.);
    const io::TemporaryFolder folder;
    const std::string blast = folder.path() + "/blast";
    write_blast(blast, *tables, factor, false, 1., of_later_peak);
    std::ofstream(blast + "/probe_injury.csv", std::ios::app)
      << "eardrum_rupture,probe 1," << eardrum << ",-,\"\"\n";
    std::map<std::string, ComparedQuantity> found;
    for (const ComparedQuantity &one :
         compare_with_tables(scene, layout, 70., folder.path(), false))
      found[one.name] = one;
    return found;
  };
  const auto low = compare(3., 0.75, 1.3, "0.1");
  const ComparedQuantity &peak = low.at("peak_overpressure");
  EXPECT_NEAR(peak.run / peak.tables, 0.75, 1e-5);
  EXPECT_TRUE(peak.differs);
  EXPECT_FALSE(compare(3., 1., 1.3, "0.9").at("peak_overpressure").differs);
  // The eardrums are those under the larger peak, whatever the first one is; a
  // reflection may raise it above that of the tables.
  EXPECT_FALSE(low.at("eardrum_rupture").differs);
  EXPECT_FALSE(compare(3., 0.75, 1.6, "0.999").at("eardrum_rupture").differs);
  EXPECT_TRUE(compare(3., 0.6, 1.1, "0.1").at("eardrum_rupture").differs);
  // A wave that follows the incident one has not merged with it.
  for (const double of_later_peak : {1., 1.3})
    EXPECT_EQ(
      compare(0.5, 1.4, of_later_peak, "0.9").at("peak_overpressure").differs,
      of_later_peak > 1.);
}


// Neither a body nor the ground can add any impulse: what is more than they can
// is marked, and so are the duration and the load that follow from it.
TEST(TableComparison, LeavesNoMoreToReflectionsThanTheyCanAdd)
{
  for (const double height : {0.06, 3.})
    for (const double factor : {1.2, 2.7})
    {
      const SceneParameters scene = scene_of("tnt", height);
      const SceneLayout layout = layout_of(scene);
      const auto tables = table_answer(scene, layout, 70.);
      const io::TemporaryFolder folder;
      write_blast(
        folder.path() + "/blast", *tables, factor, false, 1.5 / factor);
      const auto rows =
        compare_with_tables(scene, layout, 70., folder.path(), false);
      for (const ComparedQuantity &one : rows)
        if (one.name == "impulse" || one.name == "lung_exposure")
        {
          EXPECT_EQ(one.differs, factor > 2.) << height << " " << one.name;
        }
      const std::string warning = warning_of(rows, scene.explosive, true);
      EXPECT_EQ(warning.find("impulse ") != std::string::npos, factor > 2.);
      EXPECT_EQ(warning.find("what open sides send back") != std::string::npos,
                !warning.empty());
    }
}


// The tables have what the ground adds to a charge that lies on it.
TEST(TableComparison, LeavesNothingToTheGroundOfASurfaceBurst)
{
  const std::string warning = warning_for(scene_of("tnt", 0.06), 1.4, 0.);
  EXPECT_NE(warning.find("incident peak"), std::string::npos) << warning;
}


// Without a probe, the load on the nearest skin is that on a wall.
TEST(TableComparison, IsOfTheSkinWithoutAProbe)
{
  SceneParameters scene = scene_of("tnt", 1.1);
  scene.mass = 0.1;
  scene.place = Point<3>(0.5, 0., 1.1);
  const SceneLayout layout = layout_of(scene);
  ASSERT_FALSE(layout.probe);
  const Landmark gauge{"upper arm", Point<3>(0.15, 0., 1.1)};
  const IncidentWave wave = layout.incident_wave(scene);
  const double peak = wave.value(BlastQuantity::reflected_overpressure, 0.35);
  const io::TemporaryFolder folder;
  const auto compare = [&](const double fine, const double coarse) {
    for (const auto &[name, factor] :
         {std::pair{"/blast", fine}, std::pair{"/coarser_blast", coarse}})
    {
      std::filesystem::create_directories(folder.path() + name);
      std::ofstream(folder.path() + name + "/summary.json")
        << R"({"results": {"loads_upper_arm_first_peak": {"value": )"
        << factor * peak << R"(}, "loads_upper_arm_peak": {"value": )"
        << 2. * factor * peak
        << R"(}, "loads_upper_arm_impulse": {"value": 1},)"
        << R"( "loads_upper_arm_cut_off": {"value": 1},)"
        << R"( "loads_upper_arm_arrival": {"value": )"
        << wave.value(BlastQuantity::arrival, 0.35) << "}}}";
    }
    return compare_skin_with_tables(
      scene, layout, gauge, folder.path(), coarse > 0.);
  };
  EXPECT_EQ(warning_of(compare(0.8, 0.65), scene.explosive), "");
  EXPECT_TRUE(std::isnan(compare(0.4, 0.).front().run_error));
  const auto rows = compare(0.4, 0.26);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_NEAR(rows[0].run / rows[0].tables, 0.4, 1e-6);
  // A body is no endless wall: its impulse may be less.
  EXPECT_LT(rows[1].run, 0.1 * rows[1].tables);
  EXPECT_TRUE(rows[0].differs && !rows[1].differs && !rows[2].differs);
  EXPECT_TRUE(!rows[0].is_cut && rows[1].is_cut && !rows[2].is_cut);
  const std::string warning = warning_of(rows, scene.explosive);
  EXPECT_EQ(warning.find("WARNING: at the upper arm, run and tables of Kingery "
                         "and Bulmash differ by more than what is known of "
                         "their errors: reflected peak "),
            0U)
    << warning;
  const Landmark aside{"upper arm", Point<3>(0.15, 0.2, 1.1)};
  EXPECT_TRUE(
    compare_skin_with_tables(scene, layout, aside, folder.path(), true)
      .empty());
}


// Both runs may agree at one gauge by chance: its error is that of the others.
TEST(TableComparison, HasAtLeastTheMedianErrorOfGaugesOnTheSkin)
{
  SceneParameters scene = scene_of("tnt", 1.1);
  scene.mass = 0.1;
  scene.place = Point<3>(0.5, 0., 1.1);
  const Landmark gauge{"chest", Point<3>(0.15, 0., 1.1)};
  const io::TemporaryFolder folder;
  const auto error_of_impulse = [&](const double chest_cut_off) {
    for (const auto &[name, factor] :
         {std::pair{"/blast", 1.}, std::pair{"/coarser_blast", 0.9}})
    {
      std::filesystem::create_directories(folder.path() + name);
      std::ofstream file(folder.path() + name + "/summary.json");
      file << R"({"results": {"loads_chest_impulse": {"value": 50})"
           << R"(, "loads_back_impulse": {"value": )" << 20. * factor
           << R"(}, "loads_head_impulse": {"value": )" << 30. * factor << "}";
      if (chest_cut_off > 0.)
        file << R"(, "loads_chest_cut_off": {"value": 1})";
      file << "}}";
    }
    const auto rows = compare_skin_with_tables(
      scene, layout_of(scene), gauge, folder.path(), true);
    return rows.size() == 1 ? rows.front().run_error : 0.;
  };
  EXPECT_NEAR(error_of_impulse(0.), 0.1 / (std::pow(2., 0.7) - 1.), 1e-9);
  EXPECT_TRUE(std::isnan(error_of_impulse(1.)));
}


TEST(TableComparison, IsEmptyWithoutAProbe)
{
  const SceneParameters scene = scene_of("tnt", 1.);
  const io::TemporaryFolder folder;
  EXPECT_TRUE(
    compare_with_tables(scene, layout_of(scene), 70., folder.path(), false)
      .empty());
}
