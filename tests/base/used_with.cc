// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace contrecoup;

namespace
{
void declare_body(ParameterHandler &prm)
{
  declare_selection(prm, "Kind", "phantom", {"phantom", "surface"}, "Of it.");
  const Section section(prm, "Surface");
  const UsedWith used("Body/Kind = surface");
  declare_file(prm, "File", "", "Triangles.");
  declare_double(prm, "Scale", "1", 0., 9., "-", "Of the file.");
  declare_selection(prm, "Organs", "none", {"none", "phantom"}, "Inside.");
  declare_string(prm,
                 "Facing",
                 "found",
                 used_with("Body/Surface/Organs not none", "Angle."));
}

void declare_sections(ParameterHandler &prm)
{
  declare_string(prm, "Points", "", "Of probes.");
  declare_string(prm, "Lines", "", "Of probes.");
  declare_bool(prm,
               "Injury",
               "false",
               used_with("Points or Lines not empty", "At probes."));
  declare_integer(prm, "Levels", "0", 0, 9, "Of a box.");
  declare_double(
    prm, "Corner", "0", 0., 9., "m", used_with("Levels not 0", "Of it."));
  declare_string(prm, "Sides", "", "1: wall, 2: inflow.");
  declare_double(
    prm, "Inflow", "0", 0., 9., "m/s", used_with("Sides = inflow", "Speed."));
  {
    const Section section(prm, "Body");
    declare_body(prm);
  }
  const Section section(prm, "Load *");
  declare_selection(prm, "Kind", "text", {"text", "pulse"}, "Of it.");
  const Section inner(prm, "Pulse");
  const UsedWith used("Kind = pulse");
  declare_double(prm, "Peak", "1", 0., 9., "Pa", "Of it.");
}

/// Warnings of a file with such entries and of later overrides.
std::vector<std::string>
unused_of(const std::vector<std::string> &texts,
          const std::vector<std::string> &overrides = {})
{
  ParameterHandler prm;
  declare_sections(prm);
  std::vector<Assignment> assignments;
  for (const std::string &text : texts)
  {
    assignments.push_back(parse_override(text));
    assignments.back().origin = "a.prm, line 1";
  }
  for (const std::string &text : overrides)
    assignments.push_back(parse_override(text));
  apply_assignments(assignments, prm);
  return find_unused(prm, assignments);
}

using Lines = std::vector<std::string>;
} // namespace

TEST(UsedWith, IsInTheHelpText)
{
  ParameterHandler prm;
  declare_sections(prm);
  EXPECT_NE(
    parameter_text(prm, true).find("Triangles. Used with Body/Kind = surface."),
    std::string::npos);
}

TEST(UsedWith, NamesEntriesAndChoice)
{
  EXPECT_EQ(unused_of({"Body/Surface/File=x.stl"}),
            Lines{"WARNING: Body/Surface/File is set but not used: Body/Kind "
                  "is phantom, not surface"});
  EXPECT_EQ(unused_of({"Injury=true"}),
            Lines{"WARNING: Injury is set but not used: Points and Lines are "
                  "empty"});
  EXPECT_EQ(unused_of({"Corner=2"}),
            Lines{"WARNING: Corner is set but not used: Levels is 0"});
  EXPECT_EQ(unused_of({"Load a/Pulse/Peak=2"}),
            Lines{"WARNING: Load a/Pulse/Peak is set but not used: Load "
                  "a/Kind is text, not pulse"});
}

TEST(UsedWith, TellsEachReasonOnce)
{
  EXPECT_EQ(unused_of({"Body/Surface/File=x.stl", "Body/Surface/Scale=2"}),
            Lines{"WARNING: Body/Surface/File, Body/Surface/Scale are set but "
                  "not used: Body/Kind is phantom, not surface"});
}

TEST(UsedWith, TellsTheOuterReason)
{
  EXPECT_EQ(unused_of({"Body/Surface/Facing=90"}),
            Lines{"WARNING: Body/Surface/Facing is set but not used: Body/Kind "
                  "is phantom, not surface"});
  EXPECT_EQ(unused_of({"Body/Kind=surface", "Body/Surface/Facing=90"}),
            Lines{"WARNING: Body/Surface/Facing is set but not used: "
                  "Body/Surface/Organs is none"});
}

// Who overrides a choice of a file knows that entries of the other one rest.
TEST(UsedWith, IsSilentWhereAnOverrideChose)
{
  const std::vector<std::string> file = {"Body/Kind=surface",
                                         "Body/Surface/Scale=2"};
  EXPECT_EQ(unused_of(file, {"Body/Kind=phantom"}), Lines{});
  EXPECT_EQ(unused_of(file, {"Body/Kind=phantom", "Body/Surface/Scale=3"}),
            Lines{"WARNING: Body/Surface/Scale is set but not used: Body/Kind "
                  "is phantom, not surface"});
  EXPECT_EQ(unused_of({"Body/Surface/Scale=2"}, {"Levels=1"}),
            Lines{"WARNING: Body/Surface/Scale is set but not used: Body/Kind "
                  "is phantom, not surface"});
}

// A preset has entries for choices of those that include it.
TEST(UsedWith, IsSilentAboutIncludedFiles)
{
  std::ofstream("preset.prm") << "subsection Body\n subsection Surface\n"
                                 "  set Scale = 2\n end\nend\n";
  const auto warnings = [](const std::string &own) {
    std::ofstream("with_preset.prm") << own;
    ParameterHandler prm;
    declare_sections(prm);
    const auto assignments = read_assignments("with_preset.prm");
    apply_assignments(assignments, prm);
    return find_unused(prm, assignments);
  };
  EXPECT_EQ(warnings("include preset.prm\n"), Lines{});
  EXPECT_EQ(warnings("include preset.prm\nset Corner = 2\n"),
            Lines{"WARNING: Corner is set but not used: Levels is 0"});
  EXPECT_EQ(warnings("include preset.prm\nsubsection Body\n subsection "
                     "Surface\n  set Scale = 3\n end\nend\n"),
            Lines{"WARNING: Body/Surface/Scale is set but not used: Body/Kind "
                  "is phantom, not surface"});
}

TEST(UsedWith, AcceptsWhatIsUsedOrHasItsDefault)
{
  EXPECT_EQ(unused_of({"Body/Surface/Scale=1.0",
                       "Load a/Kind=pulse",
                       "Load a/Pulse/Peak=2",
                       "Lines=a",
                       "Injury=true",
                       "Sides=1: wall, 2: inflow",
                       "Inflow=3"}),
            Lines{});
}
