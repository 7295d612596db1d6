// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/log_words.h>
#include <contrecoup/coupling/task/scene_words.h>

#include <gtest/gtest.h>

using namespace contrecoup;
using contrecoup::coupling::SceneWords;

namespace
{
Assignment assign(const std::string &path, const std::string &origin)
{
  Assignment assignment = parse_override(path + "=1");
  assignment.origin = origin;
  return assignment;
}

/// Words of a blast whose user wrote its limiter and another charge.
SceneWords blast_words()
{
  dealii::ParameterHandler prm;
  const auto declare = [&](const std::string &section,
                           const std::vector<std::string> &entries) {
    const Section inner(prm, section);
    for (const std::string &entry : entries)
      declare_string(prm, entry, "", "A word.");
  };
  declare("Body", {"Kind", "Shift"});
  declare("Domain", {"Coarse leaves", "Size", "Size limit"});
  declare("Method", {"CFL number", "Limiter"});
  declare("Rigid body", {"Kind", "Levels"});
  return {"Blast",
          {assign("Domain/Coarse leaves", "Scene/End time"),
           assign("Charges/Charge 1/Mass", "Charge/Mass"),
           assign("Charges/Charge 1/Center", "Charge/Place"),
           assign("Rigid body/Kind", "Body/Kind"),
           assign("Rigid body/Levels", "Scene/Accuracy"),
           assign("Method/CFL number", ""),
           assign("Method/Limiter", "Scene/Accuracy")},
          {{"Charges", "Charge"}, {"Rigid body", "Body"}},
          {assign("Blast/Method/Limiter", "file.prm, line 3"),
           assign("Blast/Charges/Charge 2/Mass", "--set"),
           assign("Scene/End time", "file.prm, line 4")},
          prm};
}
} // namespace

TEST(SceneWords, EntriesOfStagesAreCalledByWhatTheyFollowFrom)
{
  const SceneWords words = blast_words();
  EXPECT_EQ(words("Blast: entry \"Domain/Coarse leaves\" cannot be \"0\""),
            "Blast: entry \"Scene/End time\" cannot be \"0\"");
  EXPECT_EQ(words("Charges/Charge 1/Mass = 1 kg and Charges/Charge 1/Center"),
            "Charge/Mass = 1 kg and Charge/Place");
  EXPECT_EQ(words("see Rigid body/Levels"), "see Scene/Accuracy");
}


TEST(SceneWords, OthersAreCalledByTheirPlaceInTheScene)
{
  const SceneWords words = blast_words();
  EXPECT_EQ(words("Domain/Size: no"), "Blast/Domain/Size: no");
  EXPECT_EQ(words("Domain/Size limit"), "Blast/Domain/Size limit");
  EXPECT_EQ(words("Method/CFL number is 2"), "Blast/Method/CFL number is 2");
  // The user's entry wins over the scene's choice.
  EXPECT_EQ(words("a Method/Limiter"), "a Blast/Method/Limiter");
  EXPECT_EQ(words("Body/Shift moves it"), "Body/Shift moves it");
}


TEST(SceneWords, SectionsThatAMessageBeginsWithAreNamedAsWell)
{
  const SceneWords words = blast_words();
  EXPECT_EQ(words("Rigid body: it lies outside, see Body/Shift"),
            "Body: it lies outside, see Body/Shift");
  EXPECT_EQ(words("Charges/Charge 1: it is cut"), "Charge: it is cut");
  EXPECT_EQ(
    words("Charges/Charge 2: it is cut, by Charges/Charge 2/Mass"),
    "Blast/Charges/Charge 2: it is cut, by Blast/Charges/Charge 2/Mass");
  EXPECT_EQ(words("Method: none"), "Blast/Method: none");
  EXPECT_EQ(words("Domain: too large"), "Blast/Domain: too large");
}


TEST(SceneWords, NamesWithoutASectionAreOfTheOneThatAMessageBeginsWith)
{
  const SceneWords words = blast_words();
  EXPECT_EQ(words("Charges/Charge 1: of Mass = 1 kg; its Center must be 1"),
            "Charge: of Mass = 1 kg; its Charge/Place must be 1");
  EXPECT_EQ(words("Charges/Charge 1/Mass: Center is missing"),
            "Charge/Mass: Charge/Place is missing");
  EXPECT_EQ(words("Domain needs Size = 1 or Coarse leaves, for Levels"),
            "Blast/Domain needs Size = 1 or Scene/End time, for Levels");
  EXPECT_EQ(words("Rigid body: raise Levels, not Levels/x or BigLevels"),
            "Body: raise Scene/Accuracy, not Levels/x or BigLevels");
  EXPECT_EQ(words("Charges/Charge 2: its Mass"),
            "Blast/Charges/Charge 2: its Mass");
  EXPECT_EQ(words("a word of Domain: Size"), "a word of Domain: Size");
  EXPECT_EQ(words("Rigid body"), "Body");
  EXPECT_EQ(words("Domain"), "Blast/Domain");
}


TEST(SceneWords, WhatIsNoNameStaysAsItIs)
{
  const SceneWords words = blast_words();
  for (const char *text : {"",
                           "Blast/Domain/Coarse leaves",
                           "\"/tmp/Domain/Coarse leaves/x.h5\" is missing",
                           "Domain/Coarse leavesX",
                           "MyDomain/Coarse leaves",
                           "the method: Domain"})
    EXPECT_EQ(words(text), text);
  EXPECT_EQ(SceneWords()("Domain/Size: no"), "Domain/Size: no");
}


TEST(SceneWords, OneEntryCanBeNamedByItself)
{
  SceneWords words = blast_words();
  words.rename("Loads/Recorded/File", "the loads of stage blast");
  EXPECT_EQ(words("Loads/Recorded/File: it is damaged"),
            "the loads of stage blast: it is damaged");
}


TEST(LogWords, TheLogSpeaksThemWhileTheyLive)
{
  testing::internal::CaptureStdout();
  log_line("see Domain/Size");
  {
    const LogWords scene(blast_words());
    log_line("see Domain/Size");
    {
      const LogWords shout([](const std::string &text) { return text + "!"; });
      log_line("see Domain/Size");
    }
    log_line("see Domain/Coarse leaves");
  }
  log_line("see Domain/Size");
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "see Domain/Size\nsee Blast/Domain/Size\nsee Domain/Size!\n"
            "see Scene/End time\nsee Domain/Size\n");
}
