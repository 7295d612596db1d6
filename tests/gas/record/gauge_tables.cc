// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/gauge_tables.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace contrecoup;
using namespace contrecoup::gas;

namespace
{
/// Text between the commas of each line.
std::vector<std::vector<std::string>> rows_of(const std::string &table)
{
  std::vector<std::vector<std::string>> rows;
  for (const std::string &line : split(table, '\n'))
    if (!line.empty())
      rows.push_back(split(line, ','));
  return rows;
}
} // namespace


namespace
{
/// The mark of each measure and place by which it is a lower limit.
std::map<std::string, bool> lower_limits(const std::string &table)
{
  std::map<std::string, bool> marks;
  for (const auto &row : rows_of(table))
    if (row[0] != "measure")
      marks[row[0] + " " + row[1]] = row.back() == "1";
  return marks;
}


/// A steady load of 0.1 MPa that arrives at @p begin and ends at @p end, of
/// which samples are taken until 10 ms [s].
GaugeBlast
steady_load(const std::string &place, const double begin, const double end)
{
  GaugeBlast load{
    place, {1e5, 1e5 * (end - begin), begin, end - begin}, begin, {}};
  for (unsigned int i = 0; i <= 1000; ++i)
    load.overpressures.push_back(1e-5 * i >= begin && 1e-5 * i < end ? 1e5
                                                                     : 0.);
  return load;
}
} // namespace


// The chest wall, its mean, the exposure and the ear, each by what it follows
// from: velocity, positive phase, peak.
TEST(GaugeTables, CallWhatTheEndOfTheRunCutsOffALowerLimit)
{
  std::vector<double> times;
  for (unsigned int i = 0; i <= 1000; ++i)
    times.push_back(1e-5 * i);
  GaugeBlast last = steady_load("back", 9e-3, 1e-2);
  last.peak_time = 1e-2;
  const GaugeBlast none{"back", {}, 0., std::vector<double>(1001, 0.)};
  // A second wave moves the wall faster than the first.
  GaugeBlast again = steady_load("back", 2e-3, 2.1e-3);
  std::fill(again.overpressures.begin() + 950, again.overpressures.end(), 1e5);
  for (const auto &[back, expected] :
       {std::pair(steady_load("back", 2e-3, 4e-3), "0000"),
        std::pair(steady_load("back", 2e-3, 1e-2), "0010"),
        std::pair(last, "1111"),
        std::pair(none, "1101"),
        std::pair(again, "1100")})
  {
    GaugeBlast ear = back;
    ear.place = "left ear";
    const std::string table =
      gauge_injury_table({steady_load("chest", 1e-3, 3e-3),
                          back,
                          steady_load("left upper arm", 1e-3, 3e-3),
                          ear},
                         times,
                         70.);
    auto marks = lower_limits(table);
    std::string found;
    for (const char *const name : {"chest_wall_velocity back",
                                   "chest_wall_velocity trunk",
                                   "lung_exposure back",
                                   "eardrum_rupture left ear"})
      found += marks[name] ? "1" : "0";
    EXPECT_EQ(found, expected) << table;
    EXPECT_FALSE(marks.at("chest_wall_velocity chest"));
    EXPECT_FALSE(marks.at("lung_exposure left upper arm"));
    EXPECT_EQ(table.find("; a lower limit: the run ends too early") !=
                std::string::npos,
              found != "0000");
  }
}


// An ear is the last word of a name, not the end of one.
TEST(GaugeTables, TakeNoOtherPlaceForAnEar)
{
  const std::vector<double> times{0., 1e-3, 2e-3}, wave{0., 2e5, 1e5};
  for (const auto &[place, is_ear] :
       std::map<std::string, bool>{{"ear", true},
                                   {"left ear", true},
                                   {"left_ear", true},
                                   {"rear", false},
                                   {"upper rear", false},
                                   {"gear", false},
                                   {"near", false},
                                   {"ear muff", false}})
  {
    const std::string table = gauge_injury_table(
      {{place, {2e5, 100., 0.5e-3, 1e-3}, 1e-3, wave}}, times, 70.);
    EXPECT_EQ(table.find("eardrum_rupture," + place + ",") != std::string::npos,
              is_ear)
      << place;
    EXPECT_EQ(table.empty(), !is_ear) << place;
  }
}


// A back that bears three times the load of the chest.
TEST(GaugeTables, HaveChestAndBack)
{
  GaugeBlast front{"chest", {200e3, 400., 5e-6, 5e-3}, 5e-6, {}};
  GaugeBlast rear{"back", {600e3, 1200., 5e-6, 5e-3}, 5e-6, {}};
  std::vector<double> times;
  for (unsigned int i = 0; i <= 1000; ++i)
  {
    const double x = i / 1000.;
    times.push_back(5e-3 * x);
    front.overpressures.push_back(200e3 * (1. - x) * std::exp(-x));
    rear.overpressures.push_back(3. * front.overpressures.back());
  }
  const auto rows = rows_of(gauge_injury_table({rear, front}, times, 70.));
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[1][0] + " " + rows[1][1], "chest_wall_velocity chest");
  EXPECT_NEAR(std::stod(rows[1][2]), 6.020, 1e-3);
  EXPECT_EQ(rows[2][0] + " " + rows[2][1], "chest_wall_velocity back");
  EXPECT_EQ(rows[3][0] + " " + rows[3][1], "chest_wall_velocity trunk");
  EXPECT_DOUBLE_EQ(std::stod(rows[3][2]),
                   0.5 * (std::stod(rows[1][2]) + std::stod(rows[2][2])));
  EXPECT_EQ(rows[4][0] + " " + rows[4][1], "lung_exposure chest");
  EXPECT_NEAR(std::stod(rows[4][2]), 200. / 941., 1e-3);
  EXPECT_EQ(rows[5][0] + " " + rows[5][1], "lung_exposure back");
  EXPECT_NEAR(std::stod(rows[5][2]), 600. / 941., 1e-3);
}


namespace
{
/// A gauge that sees a wave of 200 kPa and 5 ms, times @p part.
GaugeBlast scaled_wave(const std::string &place,
                       const double part,
                       const std::vector<double> &times)
{
  GaugeBlast found{place, {part * 200e3, 400., 5e-6, 5e-3}, 5e-6, {}};
  for (const double time : times)
    found.overpressures.push_back(part * 200e3 * (1. - time / 5e-3) *
                                  std::exp(-time / 5e-3));
  return found;
}
} // namespace


// One arm, as before a plane of symmetry, stands for both.
TEST(GaugeTables, TakeTheMeanOverTheTrunk)
{
  std::vector<double> times;
  for (unsigned int i = 0; i <= 1000; ++i)
    times.push_back(5e-6 * i);
  const auto gauge = [&](const std::string &place, const double part) {
    return scaled_wave(place, part, times);
  };
  const auto find = [&](const std::vector<GaugeBlast> &gauges) {
    std::map<std::string, double> found;
    for (const auto &row : rows_of(gauge_injury_table(gauges, times, 70.)))
      if (row[0] == "chest_wall_velocity")
        found[row[1]] = std::stod(row[2]);
    return found;
  };
  const GaugeBlast front = gauge("chest", 1.), rear = gauge("back", 0.5),
                   left = gauge("left upper arm", 2.),
                   right = gauge("right upper arm", 0.7);
  const auto half = find({front, rear, left});
  EXPECT_NEAR(
    half.at("trunk"),
    (half.at("chest") + half.at("back") + 2. * half.at("left upper arm")) / 4.,
    1e-12);
  const auto whole = find({front, rear, left, right});
  EXPECT_NEAR(whole.at("trunk"),
              (whole.at("chest") + whole.at("back") +
               whole.at("left upper arm") + whole.at("right upper arm")) /
                4.,
              1e-12);
  EXPECT_GT(half.at("trunk"), whole.at("trunk"));
}


// A person turns a side to the charge.
TEST(GaugeTables, HaveTheLoadOfTheLungsOnAllSides)
{
  std::vector<double> times;
  for (unsigned int i = 0; i <= 1000; ++i)
    times.push_back(5e-6 * i);
  const std::string table(
    gauge_injury_table({scaled_wave("chest", 0.5, times),
                        scaled_wave("left upper arm", 1., times),
                        scaled_wave("left thigh", 1., times)},
                       times,
                       70.));
  std::map<std::string, double> found;
  for (const auto &row : rows_of(table))
    if (row[0] == "lung_exposure")
      found[row[1]] = std::stod(row[2]);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found.at("left upper arm"), 200. / 941., 1e-3);
  EXPECT_NEAR(found.at("chest"), 100. / 941., 1e-3);
}


// A blast test device whose gauges see 2, 1, 1 and 0.5 times the same wave;
// half of it has one side for both.
TEST(GaugeTables, TakeTheMeanOfABlastTestDevice)
{
  std::vector<double> times;
  for (unsigned int i = 0; i <= 1000; ++i)
    times.push_back(5e-6 * i);
  const auto gauge = [&](const std::string &side, const double part) {
    return scaled_wave("device " + side, part, times);
  };
  const std::vector<GaugeBlast> half = {
    gauge("front", 2.), gauge("left", 1.), gauge("back", 0.5)};
  std::vector<GaugeBlast> whole = half;
  whole.push_back(gauge("right", 1.));
  const std::string text = gauge_injury_table(half, times, 70.);
  EXPECT_EQ(gauge_injury_table(whole, times, 70.), text);
  const auto rows = rows_of(text);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1][0] + " " + rows[1][1], "chest_wall_velocity device");
  // 11.547, twice 6.020 and 3.04 m/s; tests/numerics has the first two.
  const double velocity = std::stod(rows[1][2]);
  EXPECT_GT(velocity, (11.547 + 2. * 6.020 + 2.9) / 4.);
  EXPECT_LT(velocity, (11.547 + 2. * 6.020 + 3.1) / 4.);
  EXPECT_EQ(rows[2][0] + " " + rows[2][1], "thorax_injury_index device");
  EXPECT_NEAR(
    std::stod(rows[2][2]), std::pow(0.124 + 0.117 * velocity, 2.63), 1e-12);
  EXPECT_EQ(gauge_injury_table({half[0], half[2]}, times, 70.), "");
}


// Triangles of 100 kPa over 2 ms and, where the first has fallen to a part of
// its peak, of 50 kPa over 1 ms.
TEST(GaugeTables, CountAWaveThatMergesWithTheFirstAsALaterOne)
{
  const auto fraction = [](const double part) {
    BlastRecord<double> record;
    ExposureRecord exposure;
    const double step = 1e-5, second = 2e-3 * (1. - part);
    for (double time = step; time < 6e-3; time += step)
    {
      const double since = time - 1e-3;
      const double over =
        since < 0.       ? 0.
        : since < second ? 100e3 * (1. - since / 2e-3)
                         : 100e3 * part + 50e3 * (1. - (since - second) / 1e-3);
      record.add(over, time, step, 100.);
      exposure.waves.add(over, time, record);
    }
    return air_injury_values(
      {"", record.measures(6e-3), 101325., exposure, record.running}, 70.)[4];
  };
  // The second adds 25 Pa s, and the rest of the first stays beneath it.
  for (const double part : {0.02, 0.2, 0.5})
  {
    const double first = 100. * (1. - part * part);
    const double end = 1e-3 * (1. + part / 0.5);
    const double second = 0.5 * (100e3 * part + 50e3) * end;
    EXPECT_NEAR(fraction(part), first / (first + second), 0.01) << part;
  }
  EXPECT_NEAR(fraction(-0.2), 100. / 109., 0.01);
}


// The larger cells of a second stage smear the front: what falls by that and
// rises again is no later wave; what rises after that time is.
TEST(GaugeTables, CountAFrontThatLargerCellsSmearOnce)
{
  for (const double second : {0., 100e3})
  {
    const BlastRecord<double> record{300e3, 1e-3, 3.};
    WavePeaks waves;
    double time = 1e-3;
    waves.first = record.peak;
    waves.smeared_until = time + 4.5e-5;
    for (const double over :
         {200e3, 190e3, 240e3, 275e3, 200e3, 100e3, 50e3, 50e3 + second, 0.})
      waves.add(over, time += 1e-5, record);
    EXPECT_EQ(waves.first, 300e3);
    EXPECT_EQ(waves.later, second > 0. ? 150e3 : 0.);
  }
}


// 200 kPa of 5 ms: 310 kPa with the dynamic pressure, where 941 kPa kill half.
TEST(GaugeTables, TellWhatAWaveDoesToAPersonInTheAir)
{
  const BlastMeasures wave{200e3, 400., 1e-3, 5e-3};
  ExposureRecord exposure;
  exposure.load = standing_load(200e3, 101325.);
  exposure.chest.largest_velocity = 6.;
  const std::string table(
    air_injury_table({{"probe 1", wave, 101325., exposure, 500.},
                      {"probe 2", {}, 101325., {}, 0.},
                      {"probe 3", wave, 1., exposure, 500.}},
                     70.,
                     false));
  const auto rows = rows_of(table);
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(join(rows[0], ","),
            "measure,place,value,unit,definition,cut off [-]");
  EXPECT_EQ(rows[1][0] + " " + rows[1][1], "lung_exposure probe 1");
  EXPECT_NEAR(std::stod(rows[1][2]), 310. / 941., 1e-3);
  EXPECT_EQ(rows[2][0] + " " + rows[2][1], "lung_lethality probe 1");
  EXPECT_LT(std::stod(rows[2][2]), 1e-8);
  EXPECT_EQ(rows[3][0] + " " + rows[3][1], "eardrum_rupture probe 1");
  EXPECT_NEAR(std::stod(rows[3][2]), 0.84, 0.01);
  EXPECT_EQ(air_injury_table({{"probe 2", {}, 101325., {}, 0.}}, 70., true),
            "");

  // Where the run cuts the wave off, only the peak and a chest are known.
  const auto cut = rows_of(air_injury_table(
    {{"probe 1", wave, 101325., exposure, 400., true}}, 70., true));
  ASSERT_EQ(cut.size(), 4U);
  EXPECT_EQ(cut[1], rows[3]);
  EXPECT_EQ(cut[2][0], "chest_wall_velocity");
  EXPECT_EQ(cut[3][0], "peak_overpressure");

  // The motion of the chest and the 4 psi of training where they are asked for.
  ExposureRecord unknown;
  unknown.continue_after({20e3, 1e-3, 40., 40., 6e-3}, 101325.);
  const std::string more(air_injury_table(
    {{"probe 1", wave, 101325., exposure, 500.},
     {"probe 2", {20e3, 40., 1e-3, 5e-3}, 101325., unknown, 40.}},
    70.,
    true));
  const auto all = rows_of(more);
  ASSERT_EQ(all.size(), 12U);
  EXPECT_FALSE(lower_limits(more).at("chest_wall_velocity probe 1"));
  exposure.chest.velocity = exposure.chest.largest_velocity;
  EXPECT_TRUE(
    lower_limits(
      air_injury_table({{"probe 1", wave, 101325., exposure, 500.}}, 70., true))
      .at("chest_wall_velocity probe 1"));
  EXPECT_EQ(all[4][0] + " " + all[4][1], "chest_wall_velocity probe 1");
  EXPECT_EQ(std::stod(all[4][2]), 6.);
  EXPECT_EQ(all[5][0] + " " + all[5][1], "first_phase_fraction probe 1");
  EXPECT_EQ(std::stod(all[5][2]), 0.8);
  EXPECT_EQ(all[6][0] + " " + all[6][1], "peak_overpressure probe 1");
  EXPECT_NE(all[6][4].find("above 4 psi"), std::string::npos);
  EXPECT_EQ(all[9][0] + " " + all[9][1], "eardrum_rupture probe 2");
  EXPECT_EQ(all[11][0] + " " + all[11][1], "peak_overpressure probe 2");
  EXPECT_EQ(all[11][4].find("above 4 psi"), std::string::npos);
}


// Diffusion decides how much of the products a place near them gets: verdicts
// stand where they do not depend on it.
TEST(GaugeTables, KnowLungsBesideProductsWhereTheirDurationDecidesNothing)
{
  const auto lethality = [](const double peak,
                            const double duration,
                            const double products,
                            const double lasting) {
    AirBlast air{"", {peak, 300., 1e-3, duration}, 101325., {}, 320.};
    air.exposure.load = standing_load(peak, 101325.);
    air.exposure.products = products;
    air.exposure.lasting = air.exposure.pressing = lasting;
    air.exposure.load_impulse = 320.;
    const auto values = air_injury_values(air, 70.);
    EXPECT_EQ(std::isnan(values[0]), std::isnan(values[1]));
    EXPECT_FALSE(std::isnan(values[2]));
    EXPECT_EQ(lungs_are_unknown(air, 70.), std::isnan(values[0]));
    return values[1];
  };
  // The duration is 0.8 or 10 ms: nobody dies, or everybody.
  EXPECT_LT(lethality(0.7e6, 8e-4, 0., 1e-2), 1e-3);
  EXPECT_GT(lethality(0.7e6, 8e-4, 0.99, 1e-2), 0.99);
  for (const double mixture : {2e-4, 0.4, 0.6, 0.97})
  {
    EXPECT_TRUE(std::isnan(lethality(0.7e6, 8e-4, mixture, 1e-2))) << mixture;
    // The same verdict by either.
    EXPECT_GT(lethality(5e6, 2e-3, mixture, 1e-2), 0.99);
    EXPECT_NEAR(lethality(0.7e6, 2e-3, mixture, 2e-3),
                lethality(0.7e6, 2e-3, 0., 2e-3),
                1e-12);
  }
}


// Maps know the lungs where the phase is not over or the wave not simple, but
// where even an endless phase would kill nobody; a table has no row of them
// where the phase is not over, and otherwise says what it is.
TEST(GaugeTables, KnowLungsOfAnEndlessPhaseThatKillsNobody)
{
  for (const double peak : {50e3, 200e3, 10e6})
    for (const bool is_cut : {false, true})
    {
      AirBlast air{"here", {peak, 300., 1e-3, 5e-3}, 101325., {}, 300., is_cut};
      air.exposure.load = standing_load(peak, 101325.);
      air.exposure.waves.later = 0.5 * peak;
      air.exposure.waves.first_impulse = 0.75 * 300.;
      const auto values = air_injury_values(air, 70.);
      const double mapped = mapped_injury_values(air, 70.)[1];
      EXPECT_EQ(std::isnan(values[1]), is_cut);
      if (peak < 100e3)
      {
        EXPECT_LT(mapped, 1e-3);
        EXPECT_FALSE(mapped <= values[1]);
      }
      else if (peak > 1e6 && !is_cut)
        EXPECT_EQ(mapped, values[1]);
      else
        EXPECT_TRUE(std::isnan(mapped)) << peak << " " << is_cut;
      const std::string table = air_injury_table({air}, 70., false);
      EXPECT_EQ(table.find("lung") == std::string::npos, is_cut);
      EXPECT_EQ(table.find("lung_lethality,here," + exact(mapped)) !=
                    std::string::npos &&
                  table.find("an endless phase") != std::string::npos,
                !is_cut && peak < 100e3);
      // A wave that is simple needs no bound.
      air.exposure.waves.first_impulse = 0.76 * 300.;
      EXPECT_TRUE(is_cut || mapped_injury_values(air, 70.)[1] == values[1]);
    }
}


// A reader of the first positive phase alone would not find the lung exposure.
TEST(GaugeTables, TellHowLongTheLoadLastsAmongProducts)
{
  for (const double products : {0., 0.99})
  {
    AirBlast air{"probe 1", {0.7e6, 300., 1e-3, 8e-4}, 101325., {}, 320.};
    air.exposure.load = standing_load(0.7e6, 101325.);
    air.exposure.products = products;
    air.exposure.lasting = air.exposure.pressing = 2e-3;
    air.exposure.load_impulse = 320.;
    const auto rows = rows_of(air_injury_table({air}, 70., false));
    const bool is_longer = products > 0.;
    ASSERT_EQ(rows.size(), is_longer ? 6U : 5U);
    EXPECT_EQ(rows.back()[0],
              is_longer ? "lung_load_duration" : "first_phase_fraction");
    EXPECT_TRUE(!is_longer || std::stod(rows.back()[2]) == 2e-3);
  }
}


// Later phases belong to the wave of products, which overexpand; a wave within
// the first one does not.
TEST(GaugeTables, CountTheFirstPhaseAloneAmongProducts)
{
  for (const double products : {0., 0.5})
    for (const double first : {60., 100.})
    {
      AirBlast air{"", {200e3, 100., 1e-3, 2e-3}, 101325., {}, 150.};
      air.exposure.load = standing_load(200e3, 101325.);
      air.exposure.products = products;
      air.exposure.waves.later = 50e3;
      air.exposure.waves.first_impulse = first;
      EXPECT_DOUBLE_EQ(air_injury_values(air, 70.)[4],
                       first / (products > 0. ? 100. : 150.));
    }
}
