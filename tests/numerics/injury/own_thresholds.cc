// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/injury/own_thresholds.h>

#include "../../set_entries.h"
#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
/// Thresholds of "NAME/ENTRY=VALUE".
OwnThresholds read(const std::vector<std::string> &entries)
{
  ParameterHandler prm;
  {
    const Section section(prm, "Injury");
    OwnThresholds::declare_parameters(prm);
  }
  set_entries(prm, entries, "Injury/Measure ");
  OwnThresholds own;
  own.parse_parameters(prm, "Injury");
  return own;
}


std::string refusal(const std::vector<std::string> &entries)
{
  try
  {
    read(entries).require({"injury_hic15", "injury_strain_95"}, "no lung");
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}


void expect_refused(const std::string &entry, const std::string &words)
{
  EXPECT_NE(refusal({entry}).find(words), std::string::npos)
    << entry << ": " << refusal({entry});
}
} // namespace


TEST(OwnThresholds, ReplaceThePublishedOnesOfTheirMeasureAlone)
{
  const OwnThresholds own =
    read({"Injury hic15/Thresholds=100: headache; 300: concussion",
          "Injury hic15/Source=our ward, 2026",
          "injury_intracranial_pressure_lowest/Thresholds=-50e3: gas; -90e3: "
          "vapour"});
  const InjuryCriterion hic = own.criterion("injury_hic15");
  EXPECT_EQ(hic.meaning(99.), "none");
  EXPECT_EQ(hic.meaning(200.), "headache");
  EXPECT_EQ(hic.meaning(800.), "concussion");
  EXPECT_EQ(hic.in_words(),
            "100: headache; 300: concussion (the user's own: our ward, 2026)");
  EXPECT_EQ(hic.curves, injury_criterion("injury_hic15").curves);
  const InjuryCriterion lowest =
    own.criterion("injury_intracranial_pressure_lowest");
  EXPECT_EQ(lowest.meaning(-60e3), "gas");
  EXPECT_EQ(lowest.meaning(-95e3), "vapour");
  EXPECT_EQ(lowest.source, "the user's own");
  EXPECT_EQ(own.criterion("injury_bric").in_words(),
            injury_criterion("injury_bric").in_words());
  ASSERT_EQ(own.assumptions().size(), 2U);
  EXPECT_EQ(own.assumptions()[0].name, "own_injury_hic15");
  EXPECT_EQ(own.assumptions()[0].value, 100.);
  EXPECT_EQ(own.assumptions()[1].unit, "Pa");
}


TEST(OwnThresholds, AreReadFromTheirOwnEntries)
{
  const OwnThresholds own = read({"injury_strain_95/Thresholds=0.1: harm"});
  std::vector<std::string> again;
  for (const std::string &measure : own.measures())
    for (const auto &[entry, value] : own.entries(measure))
      again.push_back(measure + "/" + entry + "=" + value);
  EXPECT_EQ(read(again).criterion("injury_strain_95").in_words(),
            own.criterion("injury_strain_95").in_words());
}


TEST(OwnThresholds, RefuseWhatNoMeasureCanHave)
{
  EXPECT_EQ(refusal({"injury_strain_95/Thresholds=0.1: harm"}), "");
  const std::string hic = "injury_hic15/Thresholds=";
  expect_refused("injury_hic16/Thresholds=1: harm",
                 "did you mean \"injury_hic15\"? Known are chest_wall_back");
  expect_refused("peak_overpressure/Thresholds=1: harm",
                 "there is no such measure");
  expect_refused("injury_hic15/Source=me", "Thresholds is missing");
  expect_refused(hic + "300", "\"300\" must be a value and what it means");
  expect_refused(hic + "much: harm", "must be a value and what it means");
  expect_refused(hic + "0: harm", "cannot be 0; allowed: above 0");
  expect_refused(hic + "nan: harm", "must be a value and what it means");
  expect_refused(hic + "300: harm; 300: death", "increasing severity");
  expect_refused(hic + "300: harm; 200: death", "300; thresholds must be in");
  expect_refused(hic + "300: \"harm\"", "cannot have a quotation mark");
  expect_refused("ear_rupture/Thresholds=1.5: always",
                 "cannot be 1.5; allowed: above 0, at most 1");
  expect_refused("injury_intracranial_pressure_lowest/Thresholds=50e3: gas",
                 "below 0 Pa");
  expect_refused("injury_lung_exposure/Thresholds=0.5: harm",
                 "is not taken here (no lung); those are injury_hic15, "
                 "injury_strain_95");
  EXPECT_NE(refusal({hic + "1: harm", "Injury HIC15/Thresholds=2: harm"})
              .find("a second section of this measure"),
            std::string::npos);
}
