// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_names.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace contrecoup;

namespace
{
void declare_all(ParameterHandler &prm)
{
  declare_bool(prm, "Adapt", "true", "Whether the mesh changes.");
  declare_string(prm, "Title", "", "Of the report.");
  const Section section(prm, "Charge and air");
  declare_selection(
    prm, "Explosive", "tnt", {"tnt", "c-4", "-x", "x"}, "What burns.");
  const Section item(prm, "Region *");
  declare_double(prm, "Mass in air", "1", 0., 9., "kg", "Of the ball.");
}

/// "path=value" of an override with declared names.
std::string understood(const std::string &text)
{
  ParameterHandler prm;
  declare_all(prm);
  const Assignment one = with_declared_names({parse_override(text)}, prm)[0];
  std::string path;
  for (const std::string &section : one.sections)
    path += section + "/";
  return path + one.entry + "=" + one.value;
}

/// Possible oversights in a file of this text with overrides.
std::vector<std::string>
oversights_of(const std::string &text,
              const std::vector<std::string> &overrides = {})
{
  std::ofstream("overlooked.prm") << text;
  std::vector<Assignment> assignments = read_assignments("overlooked.prm");
  for (const std::string &one : overrides)
    assignments.push_back(parse_override(one));
  ParameterHandler prm;
  declare_all(prm);
  return find_oversights("overlooked.prm",
                         with_declared_names(assignments, prm));
}
} // namespace

TEST(ParameterNames, CaseAndSeparatorsDoNotMatterWhenOneNameIsMeant)
{
  EXPECT_EQ(resolve_name("C4", {"tnt", "c-4"}), "c-4");
  EXPECT_EQ(resolve_name("end_TIME", {"End time", "Time"}), "End time");
  EXPECT_EQ(resolve_name("a b", {"a-b", "ab"}), "") << "two are alike";
  EXPECT_EQ(resolve_name("ab", {"a-b", "ab"}), "ab") << "one is the same";
  EXPECT_EQ(resolve_name("-X", {"x", "-x"}), "-x");
  EXPECT_EQ(resolve_name("X", {"-x"}), "") << "a sign is no separator";
  EXPECT_EQ(resolve_name("", {"x"}), "");
}

TEST(ParameterNames, NamesAndWordsBecomeTheDeclaredOnes)
{
  EXPECT_EQ(understood("charge AND air/explosive=C4"),
            "Charge and air/Explosive=c-4");
  EXPECT_EQ(understood("Charge and air/Explosive=-X"),
            "Charge and air/Explosive=-x");
  EXPECT_EQ(understood("charge_and_air/region Ball B/mass in AIR=2"),
            "Charge and air/Region Ball B/Mass in air=2")
    << "the user names an item";
  for (const char *word : {"true", "Yes", "ON", "1"})
    EXPECT_EQ(understood(std::string("adapt=") + word), "Adapt=true");
  for (const char *word : {"False", "no", "off", "0"})
    EXPECT_EQ(understood(std::string("adapt=") + word), "Adapt=false");
  EXPECT_EQ(understood("title=Tnt"), "Title=Tnt");
}

TEST(ParameterNames, WhatIsNotDeclaredStays)
{
  for (const char *text : {"Adapt=maybe",
                           "Adopt=yes",
                           "charg/explosive=C4",
                           "Charge and air/region/mass in air=1",
                           "Charge and air/Region */Mass in air=1"})
    EXPECT_EQ(understood(text), text);
}

TEST(ParameterNames, ItemsThatDifferInCaseAreTwo)
{
  ParameterHandler prm;
  declare_all(prm);
  for (const char *name : {"a", "A"})
    apply_assignments({parse_override(std::string("charge and air/region ") +
                                      name + "/Mass in air=2")},
                      prm);
  EXPECT_EQ(item_names(prm, "Charge and air/Region"),
            (std::vector<std::string>{"a", "A"}));
}

TEST(ParameterNames, SaysWhatIsSetTwiceInOneFile)
{
  EXPECT_EQ(oversights_of("set Adapt = no\nset Title = x\nset adapt = yes\n"),
            (std::vector<std::string>{
              "WARNING: \"overlooked.prm\", line 3: entry \"Adapt\" was set in "
              "line 1 already; the later value, \"true\", counts"}));
  EXPECT_TRUE(oversights_of("set Adapt = no\n", {"Adapt=yes"}).empty());
  std::ofstream("included.prm") << "set Adapt = no\n";
  EXPECT_TRUE(oversights_of("include included.prm\nset Adapt = yes\n").empty());
}

TEST(ParameterNames, SaysThatAFileSetsNothing)
{
  for (const char *text :
       {"", "# a comment\n", "subsection Charge and air\nend"})
    EXPECT_EQ(oversights_of(text),
              (std::vector<std::string>{
                "WARNING: the parameter file \"overlooked.prm\" sets no entry, "
                "so that each has its default"}))
      << text;
  EXPECT_EQ(oversights_of("", {"Adapt=no"}).size(), 1u);
  EXPECT_TRUE(find_oversights("", {}).empty()) << "there is no file";
}
