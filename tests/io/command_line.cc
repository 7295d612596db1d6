// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/io/command_line.h>

#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::io;

namespace
{
CommandLine parse(std::vector<const char *> words)
{
  words.insert(words.begin(), "program");
  return parse_command_line(
    static_cast<int>(words.size()), words.data(), "program");
}
} // namespace

TEST(CommandLine, ReadsEveryOptionInAnyOrder)
{
  const CommandLine command = parse({"--resume",
                                     "--set",
                                     "A=1",
                                     "folder/scene.prm",
                                     "--output=here",
                                     "--set=B/C=x=y",
                                     "--check"});
  EXPECT_EQ(command.parameter_file, "folder/scene.prm");
  EXPECT_EQ(command.overrides, (std::vector<std::string>{"A=1", "B/C=x=y"}));
  EXPECT_EQ(command.output_folder, "here");
  EXPECT_TRUE(command.resume);
  EXPECT_TRUE(command.check);
  EXPECT_FALSE(command.help);
}

TEST(CommandLine, OutputFolderIsNamedAfterTheFile)
{
  EXPECT_EQ(parse({"folder/scene.prm"}).output_folder, "output/program/scene");
}

TEST(CommandLine, ResumeAndOverwriteExcludeEachOther)
{
  EXPECT_TRUE(parse({"a.prm", "--overwrite"}).overwrite);
  EXPECT_FALSE(parse({"a.prm", "--resume"}).overwrite);
  EXPECT_THROW(parse({"a.prm", "--resume", "--overwrite"}), InputError);
}

TEST(CommandLine, RefusesWhatItDoesNotKnow)
{
  EXPECT_THROW(parse({"a.prm", "b.prm"}), InputError);
  EXPECT_THROW(parse({"a.prm", "--set"}), InputError);
  EXPECT_THROW(parse({"a.prm", "--output", ""}), InputError);
  EXPECT_THROW(parse({}), InputError);
  EXPECT_NO_THROW(parse({"--print-parameters"}));
  try
  {
    parse({"a.prm", "--print-parameter"});
    ADD_FAILURE();
  }
  catch (const InputError &error)
  {
    EXPECT_NE(std::string(error.what()).find("\"--print-parameters\"?"),
              std::string::npos);
  }
}
