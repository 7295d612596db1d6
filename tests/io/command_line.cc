// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/shell_word.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/io/run/command_line.h>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <iostream>

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

TEST(CommandLine, EstimateIsAnOptionOfSceneAlone)
{
  const char *const words[] = {"scene", "a.prm", "--estimate"};
  EXPECT_TRUE(parse_command_line(3, words, "scene").estimate);
  EXPECT_THROW(parse({"a.prm", "--estimate"}), InputError);
  EXPECT_NE(help_text("scene", "", "").find("--estimate"), std::string::npos);
  EXPECT_EQ(help_text("blast", "", "").find("--estimate"), std::string::npos);
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

TEST(CommandLine, SeveralFilesAreForCheckAlone)
{
  using Words = std::vector<std::string>;
  EXPECT_EQ(
    single_commands({"program",
                     "a.prm",
                     "--set",
                     "A=1",
                     "--check",
                     "b.prm",
                     "--output=here"}),
    (std::vector<Words>{
      {"program", "--set", "A=1", "--check", "--output=here", "a.prm"},
      {"program", "--set", "A=1", "--check", "--output=here", "b.prm"}}));
  for (const Words &words :
       {Words{"program", "a.prm", "b.prm"},
        Words{"program", "a.prm", "--check", "--output", "b.prm"},
        Words{"program", "a.prm", "b.prm", "--check", "--print-parameters"},
        Words{
          "program", "a.prm", "b.prm", "--check", "--print-parameters=json"}})
    EXPECT_EQ(single_commands(words), std::vector<Words>{words});
}

TEST(CommandLine, EachFileThatIsCheckedIsNamedAndTheWorstCodeCounts)
{
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = run_each(
    {"program", "--check", "a.prm", "b.prm", "c.prm", "d.prm"},
    [](const std::vector<std::string> &words) -> Failure {
      const std::string &file = words.back();
      std::cout << "told of " << file << std::endl;
      if (file == "b.prm")
        return {ExitCode::system_failed, "no room"};
      if (file == "c.prm")
        return {ExitCode::bad_input, "c.prm:3: unknown entry"};
      return {};
    },
    true);
  EXPECT_EQ(code, 3);
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "a.prm:\ntold of a.prm\nb.prm:\ntold of b.prm\n"
            "c.prm:\ntold of c.prm\nd.prm:\ntold of d.prm\n");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "error: b.prm: no room\nerror: c.prm:3: unknown entry\n");
}

TEST(CommandLine, ASignalEndsTheChecksOfAllFiles)
{
  unsigned int n_checked = 0;
  testing::internal::CaptureStdout();
  const int code = run_each(
    {"program", "--check", "a.prm", "b.prm"},
    [&](const std::vector<std::string> &) {
      ++n_checked;
      return to_failure(std::make_exception_ptr(Stopped(SIGTERM)),
                        ExitCode::system_failed);
    },
    true);
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, 143);
  EXPECT_EQ(n_checked, 1U);
}

TEST(CommandLine, RepeatsARunFromItsFolder)
{
  const std::string text = repeating_command(
    parse({"my scene.prm", "--set", "Scene/Title=it's", "--output", "out"}), 2);
  EXPECT_EQ(text.find("cd " +
                      shell_word(std::filesystem::current_path().string()) +
                      " && mpirun -np 2 /"),
            0U);
  EXPECT_NE(text.find(" 'my scene.prm' --set 'Scene/Title=it'\\''s' "
                      "--output out"),
            std::string::npos);
}

TEST(CommandLine, WordAfterPrintParametersIsNoFile)
{
  const CommandLine command = parse({"--print-parameters", "Time"});
  EXPECT_EQ(command.wanted_parameters, "Time");
  EXPECT_EQ(command.parameter_file, "");
  EXPECT_EQ(parse({"--print-parameters", "a.prm"}).parameter_file, "a.prm");
}

TEST(CommandLine, ParametersArePrintedAsTextOrJson)
{
  EXPECT_EQ(parse({"--print-parameters"}).form, ParameterForm::text);
  const CommandLine command = parse({"--print-parameters=json", "Time"});
  EXPECT_EQ(command.form, ParameterForm::json);
  EXPECT_EQ(command.wanted_parameters, "Time");
  EXPECT_THROW(parse({"--print-parameters=xml"}), InputError);
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
