// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/shell_word.h>
#include <contrecoup/base/system/text.h>

#include <gtest/gtest.h>

#include <cstdlib>

using namespace contrecoup;

TEST(Text, SplitsAndJoins)
{
  EXPECT_EQ(split(" a , b,,c ", ','),
            (std::vector<std::string>{"a", "b", "", "c"}));
  EXPECT_TRUE(split("  ", ',').empty());
  EXPECT_EQ(join({"a", "b"}, "/"), "a/b");
  EXPECT_EQ(one_line(" a\n  b\t c\n"), "a b c");
  EXPECT_EQ(wrap("aa bb cc dd", 5),
            (std::vector<std::string>{"aa bb", "cc dd"}));
}

TEST(Text, EditDistanceCountsTyposOnce)
{
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("pressure", "Pressure"), 0u);
  EXPECT_EQ(edit_distance("presure", "pressure"), 1u);
  EXPECT_EQ(edit_distance("perssure", "pressure"), 1u);
  EXPECT_EQ(edit_distance("pressore", "pressure"), 1u);
}

TEST(Text, NearestIsTheOneMeantOrNone)
{
  const std::vector<std::string> names = {"End time", "Largest step"};
  EXPECT_EQ(nearest("endtime", names), "End time");
  EXPECT_EQ(nearest("Lagrest step", names), "Largest step");
  EXPECT_EQ(nearest("viscosity", names), "");
  EXPECT_EQ(suggestion("endtime", names),
            "; did you mean \"End time\"? Known are: End time, Largest step");
  EXPECT_EQ(suggestion("viscosity", names),
            "; known are: End time, Largest step");
}


TEST(Text, NearestBeginsWithWhatWasTyped)
{
  const std::vector<std::string> names = {
    "fast", "first look", "first look of all", "fine"};
  EXPECT_EQ(nearest("first", names), "first look");
  EXPECT_EQ(nearest("FIRST L", names), "first look");
  EXPECT_EQ(nearest("fist", names), "fast");
  // Two letters begin much.
  EXPECT_EQ(nearest("fi", {"first look", "fit"}), "fit");
  EXPECT_EQ(nearest("mass", {"Mass of all", "Mast", "Mass"}), "Mass");
}

TEST(Text, ExactNumbersComeBackBitByBit)
{
  for (const double value : {0.1, 1. / 3., 1e-308, -1.7976931348623157e308})
    EXPECT_EQ(std::strtod(exact(value).c_str(), nullptr), value);
  EXPECT_EQ(exact(0.005), "0.005");
  EXPECT_EQ(exact(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(exact(-101325.), "-101325");
}

TEST(Text, WordsForAShellAreQuotedWhereNeeded)
{
  EXPECT_EQ(shell_word("output/scene-1.prm"), "output/scene-1.prm");
  EXPECT_EQ(shell_word("sc\u00E8ne 1.prm"), "'sc\u00E8ne 1.prm'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word(""), "''");
}

TEST(Text, NothingIsNearATextOfAnyLength)
{
  EXPECT_EQ(nearest(std::string(100000, 'x'), {std::string(99999, 'x')}), "");
}

TEST(Text, SaysDurationsAndSizes)
{
  EXPECT_EQ(duration(0.25), "0.25 s");
  EXPECT_EQ(duration(59.4), "59 s");
  EXPECT_EQ(duration(125.), "2 min 05 s");
  EXPECT_EQ(duration(7325.), "2 h 02 min");
  EXPECT_EQ(bytes(512.), "512 B");
  EXPECT_EQ(bytes(1.5 * 1024 * 1024 * 1024), "1.5 GiB");
}
