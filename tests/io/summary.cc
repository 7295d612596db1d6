// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/io/output/summary.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::io;
using Json = nlohmann::json;

TEST(Summary, SaysTheRelativeChangeOfConservedQuantities)
{
  Summary summary;
  summary.first_values = {{"mass", "kg", -2., true},
                          {"momentum", "kg m/s", 0., true},
                          {"rest", "J", 0., true},
                          {"largest_pressure", "Pa", 1.}};
  summary.last_values = {{"mass", "kg", -2.5, true},
                         {"momentum", "kg m/s", 1., true},
                         {"rest", "J", 0., true},
                         {"largest_pressure", "Pa", 2.}};
  const Json changes = Json::parse(to_text(summary))["conservation"];
  EXPECT_EQ(changes["mass_first"], -2.);
  EXPECT_EQ(changes["mass_last"], -2.5);
  EXPECT_EQ(changes["mass_relative_change"], -0.25);
  EXPECT_TRUE(changes["momentum_relative_change"].is_null());
  EXPECT_EQ(changes["rest_relative_change"], 0.);
  EXPECT_FALSE(changes.contains("largest_pressure_first"));
}

TEST(Summary, IsValidJsonWhateverTheNumbers)
{
  Summary summary;
  summary.message = "a \"quoted\"\nline";
  summary.errors = {{"density_L1", "", std::nan("")},
                    {"density_L2", "", INFINITY},
                    {"density_Linf", "", 0.1}};
  summary.starts.timers = {{"flux", 1.5}};
  summary.state.updates = 100.;
  summary.starts.loop_seconds = 5.;
  summary.starts.loop_rank_seconds = 10.;
  const Json json = Json::parse(to_text(summary));
  EXPECT_TRUE(json["errors"]["density_L1"].is_null());
  EXPECT_TRUE(json["errors"]["density_L2"].is_null());
  EXPECT_EQ(json["errors"]["density_Linf"], 0.1);
  EXPECT_EQ(json["timers"]["flux"], 1.5);
  EXPECT_EQ(json["performance"]["updates_per_second"], 20.);
  EXPECT_EQ(json["performance"]["updates_per_second_per_core"], 10.);
}
