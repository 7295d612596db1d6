// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/base/system/exceptions.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace contrecoup;

namespace
{
/// Writes @p text into a file of this name and returns the name.
std::string file_with(const std::string &name, const std::string &text)
{
  std::ofstream(name) << text;
  return name;
}

/// The message of the InputError that reading @p text gives.
std::string refusal_of_file(const std::string &text)
{
  try
  {
    read_assignments(file_with("refused.prm", text));
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "accepted";
}
} // namespace

TEST(ParameterFile, ReadsSectionsCommentsAndContinuedLines)
{
  const auto assignments = read_assignments(file_with("read.prm",
                                                      "# a comment\n"
                                                      "set A = 1 # one\n"
                                                      "subsection Outer part\n"
                                                      "  subsection Inner\n"
                                                      "    set B b =  2, \\\n"
                                                      "      3\n"
                                                      "  end\n"
                                                      "  set C = x = y\n"
                                                      "end"));
  ASSERT_EQ(assignments.size(), 3u);
  EXPECT_EQ(assignments[0].entry, "A");
  EXPECT_EQ(assignments[0].value, "1");
  EXPECT_EQ(assignments[1].sections,
            (std::vector<std::string>{"Outer part", "Inner"}));
  EXPECT_EQ(assignments[1].entry, "B b");
  EXPECT_EQ(assignments[1].value, "2, 3");
  EXPECT_EQ(assignments[1].origin, "\"read.prm\", line 5");
  EXPECT_EQ(assignments[2].value, "x = y");
  EXPECT_EQ(assignments[2].origin, "\"read.prm\", line 8");
}

TEST(ParameterFile, SaysWhereTextIsNotUtf8OrHasALookalike)
{
  EXPECT_EQ(refusal_of_file("set A = 1\nset Title = caf\xE9\n"),
            "\"refused.prm\", line 2: not UTF-8: byte 0xE9 after \"set Title = "
            "caf\"; save the file as UTF-8");
  EXPECT_EQ(refusal_of_file("# caf\xE9\nset Title = caf\u00E9\n"), "accepted");
  EXPECT_NE(refusal_of_file("set\u00A0A = 1\n")
              .find("line 1: cannot understand \"set\u00A0A = 1\""),
            std::string::npos);
  EXPECT_NE(
    refusal_of_file("set\u00A0A = 1\n")
      .find("; U+00A0 (no-break space) after \"set\": write a space instead"),
    std::string::npos);
  EXPECT_EQ(refusal_of_file("set\tA\t=\t1\r\n"), "accepted");
}

TEST(ParameterFile, IncludesRelativeToTheIncludingFile)
{
  std::filesystem::create_directories("folder/deeper");
  file_with("folder/deeper/inner.prm", "set A = 1\n");
  file_with("folder/middle.prm", "include deeper/inner.prm\n");
  const auto assignments = read_assignments(
    file_with("outer.prm", "subsection S\ninclude folder/middle.prm\nend\n"));
  ASSERT_EQ(assignments.size(), 1u);
  EXPECT_EQ(assignments[0].sections, std::vector<std::string>{"S"});
  EXPECT_EQ(assignments[0].folder, "folder/deeper");
}

TEST(ParameterFile, SaysFileAndLineOfEachMistake)
{
  EXPECT_EQ(refusal_of_file("set A = 1\nend\n"),
            "\"refused.prm\", line 2: \"end\" without a subsection");
  EXPECT_EQ(refusal_of_file("\nsubsection S\nset A = 1\n"),
            "\"refused.prm\", line 2: subsection \"S\" has no \"end\"");
  EXPECT_EQ(refusal_of_file("set A\n"),
            "\"refused.prm\", line 1: \"set A\" is not of the form \"set ENTRY "
            "= VALUE\"");
  EXPECT_NE(
    refusal_of_file("A = 1\n").find("line 1: cannot understand \"A = 1\""),
    std::string::npos);
  EXPECT_EQ(refusal_of_file("include nowhere.prm\n"),
            "\"refused.prm\", line 1: cannot include \"nowhere.prm\": there is "
            "no such file");
  EXPECT_EQ(refusal_of_file("set A = 1\ninclude .\n"),
            "\"refused.prm\", line 2: cannot include \".\": it is a folder");
  EXPECT_EQ(refusal_of_file(std::string(300, 'x')),
            "\"refused.prm\", line 1: cannot understand \"" +
              std::string(60, 'x') +
              "...\"; a line is \"subsection NAME\", \"set ENTRY = VALUE\", "
              "\"end\" or \"include FILE\"");
  EXPECT_NE(refusal_of_file("include refused.prm\n").find("include each other"),
            std::string::npos);
  EXPECT_NE(refusal_of_file("include refused.prm\ninclude ./refused.prm\n")
              .find("include each other"),
            std::string::npos);
  EXPECT_THROW(read_assignments("missing.prm"), InputError);
  EXPECT_THROW(read_assignments("folder"), InputError);
}

TEST(ParameterFile, AcceptsAByteOrderMarkAndAnyLineEnds)
{
  const std::string mark = "\xEF\xBB\xBF";
  for (const std::string end : {"\n", "\r\n", "\r"})
    for (const std::string &begin : {std::string(), mark})
    {
      const auto assignments = read_assignments(
        file_with("marked.prm", begin + "set A = 1" + end + "set B = 2" + end));
      ASSERT_EQ(assignments.size(), 2u);
      EXPECT_EQ(assignments[0].entry, "A");
      EXPECT_EQ(assignments[0].value, "1");
      EXPECT_EQ(assignments[1].entry, "B");
      EXPECT_EQ(assignments[1].origin, "\"marked.prm\", line 2");
    }
}

TEST(ParameterFile, ReadsOverrides)
{
  const Assignment assignment = parse_override("A/B c/D e = f/g=h");
  EXPECT_EQ(assignment.sections, (std::vector<std::string>{"A", "B c"}));
  EXPECT_EQ(assignment.entry, "D e");
  EXPECT_EQ(assignment.value, "f/g=h");
  EXPECT_THROW(parse_override("A/B"), InputError);
  EXPECT_THROW(parse_override("=1"), InputError);
  EXPECT_THROW(parse_override("A=1#2"), InputError);
  EXPECT_THROW(parse_override("A//B=1"), InputError);
}
