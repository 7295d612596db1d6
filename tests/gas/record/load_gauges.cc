// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/gauge_tables.h>
#include <contrecoup/gas/record/load_gauges.h>
#include <contrecoup/gas/record/record_gaps.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
constexpr double spacing = 0.02;

/// A plate 1 m wide and 1 mm thick in z = 0, and gauges on it.
LoadGauges make_gauges(const std::vector<std::string> &lines,
                       const Point<3> &lower = Point<3>(-2, -2, -2))
{
  dealii::ParameterHandler prm;
  RigidBody::declare_parameters(prm);
  {
    const Section section(prm, "Loads");
    LoadGauges::declare_parameters(prm);
  }
  std::vector<Assignment> assignments;
  std::vector<std::string> all = {"Rigid body/Kind=body",
                                  "Body/Kind=shape",
                                  "Body/Shape/Shape=box",
                                  "Body/Shape/Size=1, 1, 0.001"};
  all.insert(all.end(), lines.begin(), lines.end());
  for (const std::string &line : all)
    assignments.push_back(parse_override(line));
  apply_assignments(assignments, prm);
  RigidBody body;
  body.parse_parameters(prm);
  LoadGauges gauges;
  const Section section(prm, "Loads");
  gauges.parse_parameters(prm, body, lower, Point<3>(2, 2, 2), 0.02);
  return gauges;
}


/// Text between the commas of each line.
std::vector<std::vector<std::string>> read_rows(const std::string &path)
{
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  while (std::getline(file, line))
    rows.push_back(split(line, ','));
  return rows;
}


/// Centroids and area vectors of the upper facets, then of the lower ones.
std::vector<double> plate()
{
  std::vector<double> geometry;
  for (const double side : {1., -1.})
    for (int i = 0; i < 50; ++i)
      for (int j = 0; j < 50; ++j)
        for (const double value : {spacing * (i + 0.5) - 0.5,
                                   spacing * (j + 0.5) - 0.5,
                                   0.0005 * side,
                                   0.,
                                   0.,
                                   -side * spacing * spacing})
          geometry.push_back(value);
  return geometry;
}


std::vector<std::size_t> all_facets()
{
  std::vector<std::size_t> numbers(5000);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = i;
  return numbers;
}


/// On the upper side the pressure is a linear function of place.
double overpressure(const std::size_t facet)
{
  const std::vector<double> geometry = plate();
  const double *values = &geometry[6 * facet];
  return values[2] > 0. ? 10. * values[0] + values[1] : 1e6;
}


std::string refusal(const std::string &gauges)
{
  try
  {
    make_gauges({"Loads/Gauges=" + gauges});
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace


TEST(LoadGauges, AreMeansOverPatchesOfOneSide)
{
  LoadGauges gauges = make_gauges(
    {"Loads/Gauges=wide: 0.1, 0.2, 0.0005", "Loads/Gauge radius=0.1"});
  gauges.reinit(plate(), all_facets());
  // The patch is symmetric about the place.
  EXPECT_NEAR(gauges.partial_sums(overpressure)[0], 1.2, 1e-12);
}


TEST(LoadGauges, TakeTheNearestFacetWhereThePatchIsSmall)
{
  LoadGauges gauges = make_gauges(
    {"Loads/Gauges=here: 0.104, 0.216, 0.0005", "Loads/Gauge radius=0.001"});
  gauges.reinit(plate(), all_facets());
  EXPECT_NEAR(gauges.partial_sums(overpressure)[0], 1.1 + 0.21, 1e-12);
}


// The middle of a scanned body is off the plane of symmetry by round-off.
TEST(LoadGauges, BelongToTheHalfWhosePlaneTheyLieOn)
{
  const auto at = [](const double y) {
    return make_gauges({"Loads/Gauges=back: 0.1, " + exact(y) + ", 0.0005"},
                       Point<3>(-2, 0, -2))
      .names();
  };
  EXPECT_EQ(at(-1e-4), std::vector<std::string>{"back"});
  EXPECT_THROW(at(-0.1), InputError);
}


// The chest of a scanned person is some millimetres off the plane.
TEST(LoadGauges, KeepTheMiddleOfAPersonWhoIsNotQuiteSymmetric)
{
  const auto has = [](const std::string &shift, const std::string &name) {
    const std::vector<std::string> names =
      make_gauges({"Body/Kind=phantom", "Body/Shift=0," + shift + ",0"},
                  Point<3>(-2, 0, 0))
        .names();
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  EXPECT_TRUE(has("-0.015", "chest"));
  EXPECT_TRUE(has("-0.015", "left eye"));
  EXPECT_FALSE(has("-0.015", "right eye"));
  EXPECT_FALSE(has("-0.025", "chest"));
}


TEST(LoadGauges, RanksShareTheFacets)
{
  LoadGauges gauges = make_gauges(
    {"Loads/Gauges=here: 0.1, 0.2, 0.0005", "Loads/Gauge radius=0.05"});
  double sum = 0.;
  for (const std::size_t parity : {0, 1})
  {
    std::vector<std::size_t> owned;
    for (const std::size_t facet : all_facets())
      if (facet % 2 == parity)
        owned.push_back(facet);
    gauges.reinit(plate(), owned);
    sum += gauges.partial_sums(overpressure)[0];
  }
  EXPECT_NEAR(sum, 1.2, 1e-12);
}


TEST(LoadGauges, TellWhatTheBlastDidAndGoOnFromACheckpoint)
{
  const std::vector<std::string> lines = {
    "Loads/Gauges=back of hand: 0, 0, 0.0005"};
  LoadGauges straight = make_gauges(lines), stopped = make_gauges(lines);
  // Overpressure that jumps to 100 Pa at 2 s and falls to 0 at 7 s.
  const auto add = [](LoadGauges &gauges, const int begin, const int end) {
    for (int step = begin; step < end; ++step)
    {
      const double time = 0.01 * (step + 1);
      const double value = time < 2. ? 0. : 20. * (7. - time);
      gauges.add({value}, time, 0.01, 1.);
    }
  };
  add(straight, 0, 1000);
  add(stopped, 0, 400);
  std::stringstream stream;
  stopped.save(stream);
  LoadGauges resumed = make_gauges(lines);
  resumed.load(stream);
  add(resumed, 400, 1000);
  std::map<std::string, double> values;
  for (const NamedValue &value : straight.measures(10.))
    values[value.name] = value.value;
  EXPECT_NEAR(values.at("loads_back_of_hand_peak"), 100., 1.);
  EXPECT_NEAR(values.at("loads_back_of_hand_peak_time"), 2., 0.011);
  EXPECT_NEAR(values.at("loads_back_of_hand_arrival"), 2., 0.011);
  EXPECT_NEAR(values.at("loads_back_of_hand_impulse"), 250., 2.);
  for (const NamedValue &value : resumed.measures(10.))
    EXPECT_EQ(value.value, values.at(value.name)) << value.name;
  // A second wave is no peak of the first.
  resumed.add({200.}, 10.01, 0.01, 1.);
  for (const NamedValue &value : resumed.measures(10.01))
    values[value.name] = value.value;
  EXPECT_EQ(values.at("loads_back_of_hand_peak"), 200.);
  EXPECT_NEAR(values.at("loads_back_of_hand_first_peak"), 100., 1.);
  LoadGauges other =
    make_gauges({"Loads/Gauges=a: 0, 0, 0.0005; b: 0.1, 0, 0.0005"});
  stream.clear();
  stream.seekg(0);
  EXPECT_THROW(other.load(stream), InputError);
}


// Effects of the Friedlander wave of 200 kPa and 5 ms on a chest of 70 kg and
// on an ear were found independently; a run that was stopped has the whole
// history.
TEST(LoadGauges, WriteWhatTheLoadsWouldDoToAPerson)
{
  const std::vector<std::string> lines = {
    "Loads/Gauges=chest: 0, 0, 0.0005; left ear: 0.1, 0, 0.0005; calf: 0.2, 0, 0.0005",
    "Loads/Body mass=70"};
  const auto follow = [](LoadGauges &gauges, const int begin, const int end) {
    const double step = 5e-6;
    for (int i = begin; i < end; ++i)
    {
      const double x = (i + 1) * step / 5e-3;
      const double pressure = 200e3 * (1. - x) * std::exp(-x);
      gauges.begin_step(step);
      gauges.add({pressure, pressure, pressure}, (i + 1) * step, step, 1.);
      gauges.end_sample((i + 1) * step, step, true);
    }
    gauges.flush();
  };
  std::filesystem::create_directory("gauges_of_one");
  LoadGauges first = make_gauges(lines), second = make_gauges(lines);
  first.set_folder("gauges_of_one");
  follow(first, 0, 500);
  std::stringstream stream;
  first.save(stream);
  second.load(stream);
  second.set_folder("gauges_of_one");
  follow(second, 500, 2000);
  second.write_tables(0.01);
  const std::vector<std::vector<std::string>> measures =
    read_rows("gauges_of_one/gauge_measures.csv");
  ASSERT_EQ(measures.size(), 4U);
  EXPECT_EQ(join(measures[0], ","),
            "place,arrival [s],peak [Pa],peak time [s],impulse [Pa s],positive "
            "phase [s],cut off [-]");
  EXPECT_EQ(measures[1][0], "chest");
  EXPECT_NEAR(std::stod(measures[1][2]), 200e3, 0.01 * 200e3);
  EXPECT_NEAR(std::stod(measures[1][5]), 5e-3, 5e-5);
  EXPECT_EQ(measures[1][6], "0");
  // The same numbers as in the summary.
  std::map<std::string, double> told;
  for (const NamedValue &value : second.measures(0.01))
    told[value.name] = value.value;
  const std::vector<std::string> names = {
    "arrival", "peak", "peak_time", "impulse", "positive_phase"};
  for (std::size_t i = 0; i < names.size(); ++i)
    EXPECT_EQ(std::stod(measures[1][i + 1]), told.at("loads_chest_" + names[i]))
      << names[i];
  const std::vector<std::vector<std::string>> injuries =
    read_rows("gauges_of_one/gauge_injury.csv");
  ASSERT_EQ(injuries.size(), 4U);
  EXPECT_EQ(join(injuries[0], ","),
            "measure,place,value,unit,definition,cut off [-]");
  EXPECT_EQ(injuries[1][0] + " " + injuries[1][1], "chest_wall_velocity chest");
  EXPECT_NEAR(std::stod(injuries[1][2]), 6.020, 0.02);
  EXPECT_EQ(injuries[2][0] + " " + injuries[2][1], "lung_exposure chest");
  EXPECT_NEAR(std::stod(injuries[2][2]), 200. / 941., 3e-3);
  EXPECT_EQ(injuries[3][0] + " " + injuries[3][1], "eardrum_rupture left ear");
  EXPECT_NEAR(std::stod(injuries[3][2]), 0.84, 0.01);
}


// Impulse and duration of a positive phase of 5 ms are lower limits when the
// run ends after 2 ms.
TEST(LoadGauges, TellAPositivePhaseThatTheEndOfTheRunCutsOff)
{
  const BlastMeasures whole{200e3, 400., 1e-3, 5e-3},
    cut{200e3, 300., 1e-3, 1e-3}, none;
  EXPECT_FALSE(is_cut_off(whole, 7e-3));
  EXPECT_TRUE(is_cut_off(cut, 2e-3));
  EXPECT_FALSE(is_cut_off(none, 2e-3));
  const std::string table = gauge_measures_table(
    {{"chest", cut, 1e-3, {}}, {"back", none, 0., {}}}, 2e-3);
  EXPECT_NE(table.find("chest,0.001,2e+05,0.001,300,0.001,1\n"),
            std::string::npos)
    << table;
  EXPECT_NE(table.find("back,nan,nan,nan,nan,nan,0\n"), std::string::npos)
    << table;

  LoadGauges gauges = make_gauges({"Loads/Gauges=chest: 0, 0, 0.0005"});
  for (int i = 0; i < 100; ++i)
    gauges.add({200e3}, 2e-5 * (i + 1), 2e-5, 1.);
  const auto is_marked = [&] {
    for (const NamedValue &value : gauges.measures(2e-3))
      if (value.name == "loads_chest_cut_off")
        return value.value == 1.;
    return false;
  };
  EXPECT_TRUE(is_marked());
  gauges.add({-1e3}, 2e-3, 1e-9, 1.);
  EXPECT_FALSE(is_marked());
}

TEST(LoadGauges, TellGapsOfTheirRecord)
{
  const BlastMeasures cut{200e3, 300., 1e-3, 1e-3}, none,
    whole{200e3, 300., 1e-3, 0.5e-3};
  const auto gaps = [&](const std::size_t n_unreached,
                        const std::size_t n_cut,
                        const std::size_t n_whole) {
    RecordGaps result(2e-3, "gauges");
    for (std::size_t i = 0; i < n_unreached; ++i)
      result.add("u" + std::to_string(i), none);
    for (std::size_t i = 0; i < n_cut; ++i)
      result.add("c" + std::to_string(i), cut);
    for (std::size_t i = 0; i < n_whole; ++i)
      result.add("w" + std::to_string(i), whole);
    return join(result.in_words(), "\n");
  };
  const std::string begin = "the record ends at 2 ms; ",
                    unreached = ", where nothing is measured",
                    limits = ", where impulse and duration are lower limits";
  EXPECT_EQ(gaps(0, 0, 3), "");
  EXPECT_EQ(gaps(1, 2, 1),
            begin + "not reached by a blast or its peak: u0" + unreached +
              "; cut off in the positive phase: c0, c1" + limits);
  EXPECT_EQ(gaps(2, 0, 0),
            begin + "not reached by a blast or its peak: all 2 gauges" +
              unreached);
  EXPECT_EQ(gaps(0, 5, 4),
            begin + "cut off in the positive phase: 5 of 9 gauges, as c0" +
              limits);
}


// A place that no blast has reached has no number, wherever it is told.
TEST(LoadGauges, MeasureNothingWhereNoBlastHasArrived)
{
  LoadGauges gauges = make_gauges(
    {"Loads/Gauges=chest: 0, 0, 0.0005; left side of the back: 0.1, 0, 0.0005"});
  for (int i = 0; i < 100; ++i)
    gauges.add({200e3, 0.5}, 2e-5 * (i + 1), 2e-5, 1.);
  unsigned int n_unknown = 0;
  for (const NamedValue &value : gauges.measures(2e-3))
  {
    const bool is_back = begins_with(value.name, "loads_left_side_of_the_back");
    EXPECT_EQ(std::isnan(value.value), is_back) << value.name;
    n_unknown += is_back ? 1 : 0;
  }
  EXPECT_EQ(n_unknown, 5U);
  const std::vector<std::string> lines = gauges.table(2e-3);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NE(lines[2].find("not reached"), std::string::npos) << lines[2];
  // Columns fit their widest cell.
  EXPECT_EQ(lines[0].find("x, y, z"), lines[2].find("0.1, 0"));
  EXPECT_EQ(lines[0].find("arrival"), lines[2].find("not reached"));
  const std::vector<std::string> gaps = gauges.gaps(2e-3);
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_NE(
    gaps[0].find("not reached by a blast or its peak: left side of the back,"),
    std::string::npos)
    << gaps[0];
}


TEST(LoadGauges, TextThatNamesNoPlaceIsRefused)
{
  for (const std::string gauges : {"0, 0, 1",
                                   "nose: 0, 1",
                                   ": 0, 0, 1",
                                   "a, b: 0, 0, 1",
                                   "nose: 0, 0, one"})
    EXPECT_NE(refusal(gauges).find("must be a name, a colon and 3"),
              std::string::npos)
      << gauges << ": " << refusal(gauges);
  EXPECT_NE(
    refusal("a: 0, 0, 0.0005; a: 0.1, 0, 0.0005").find("two gauges \"a\""),
    std::string::npos);
  EXPECT_EQ(refusal("a: 0, 0, 0.0005; "), "");
}


// Cells are of 20 mm; one side of the plate may lose its facets.
TEST(LoadGauges, WarnOfPlacesWithoutSkinAndOfSharedFacets)
{
  for (const std::string radius : {"0.001", "0.05"})
    for (const bool is_lost : {false, true})
    {
      LoadGauges gauges =
        make_gauges({"Loads/Gauges=eye: 0.104, 0.216, 0.0005; "
                     "temple: 0.106, 0.214, 0.0005; far: 0.3, 0, 0.0005; "
                     "below: 0.3, 0.2, -0.0005",
                     "Loads/Gauge radius=" + radius});
      std::vector<double> geometry = plate();
      if (is_lost)
        geometry.resize(geometry.size() / 2);
      testing::internal::CaptureStdout();
      gauges.reinit(geometry, {});
      gauges.reinit(geometry, {});
      const std::string log = testing::internal::GetCapturedStdout();
      const std::size_t lost =
        log.find("the gas has no skin at below: the nearest is beyond the "
                 "diagonal of a cell, 34.6 mm, and");
      EXPECT_EQ(lost != std::string::npos, is_lost) << log;
      const std::size_t shared = log.find(
        "gauges have the same loads, since they fell on the same facets: eye "
        "and temple\n");
      EXPECT_EQ(shared != std::string::npos, radius == "0.001") << log;
      EXPECT_EQ(log.find("the gas has no skin", lost + 1), std::string::npos)
        << log;
    }
}


// Cells of 20 mm may have no corner in a plate that is thinner than their
// diagonal, 34.6 mm.
TEST(LoadGauges, WarnOfPartsThatCellsMayLose)
{
  for (const auto &[thickness, is_warned] :
       {std::pair{"0.001", true}, {"0.034", true}, {"0.036", false}})
    for (const std::string required : {"true", "false"})
    {
      testing::internal::CaptureStdout();
      make_gauges({std::string("Body/Shape/Size=1, 1, ") + thickness,
                   "Rigid body/Required=" + required,
                   "Loads/Gauges=top: 0, 0, 0.02; edge: 0.5, 0, 0"});
      const std::string log = testing::internal::GetCapturedStdout();
      EXPECT_EQ(
        log.find("at top the body is thinner than the diagonal of a cell, "
                 "34.6 mm") != std::string::npos,
        is_warned && required == "true")
        << thickness << ": " << log;
    }
}
