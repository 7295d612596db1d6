// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/study/outcome.h>

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

using namespace contrecoup::study;

namespace
{
Outcome judged(const ProcessEnd &end,
               const std::string &summary,
               const std::string &errors = "",
               const bool timed_out = false)
{
  const contrecoup::io::TemporaryFolder folder;
  if (!summary.empty())
    std::ofstream(folder.path() + "/summary.json") << summary;
  std::ofstream(folder.path() + "/errors.txt") << errors;
  return judge(end, timed_out, folder.path(), folder.path() + "/errors.txt");
}
} // namespace

TEST(Outcome, IsJudgedByCodeAndSummary)
{
  EXPECT_EQ(judged({}, R"({"status": "finished", "retries": 0})").kind,
            "stable");
  const Outcome meshed = judged({}, R"({"status": "finished"})");
  EXPECT_EQ(meshed.kind, "finished");
  EXPECT_TRUE(meshed.is_usable());
  const Outcome retried = judged({}, R"({"status": "finished", "retries": 3})");
  EXPECT_EQ(retried.kind, "retried");
  EXPECT_EQ(retried.reason, "3 steps were cut back");
  EXPECT_TRUE(retried.is_usable());
  const Outcome refused = judged({1, 0}, "", "error: no such entry\n");
  EXPECT_EQ(refused.kind, "refused");
  EXPECT_EQ(refused.reason, "no such entry");
  const Outcome unstable =
    judged({2, 0}, R"({"status": "failed", "message": "negative"})", "x");
  EXPECT_EQ(unstable.kind, "unstable");
  EXPECT_EQ(unstable.reason, "negative");
  EXPECT_FALSE(unstable.is_usable());
  EXPECT_EQ(judged({3, 0}, "").kind, "failed");
  EXPECT_EQ(judged({0, SIGSEGV}, "").kind, "failed");
  EXPECT_EQ(judged({0, 0}, "").kind, "failed");
  EXPECT_EQ(judged({0, 0}, R"({"status": "stopped"})").kind, "failed");
  EXPECT_EQ(judged({0, SIGTERM}, "", "", true).kind, "timed out");
}

// A disk without room is no property of the variant, a lack of memory may be.
TEST(Outcome, TellsOfStorage)
{
  for (const char *reason :
       {"cannot write \"run/history.csv\": No space left on device",
        "cannot write \"run/history.csv\": File too large",
        "cannot write \"run/history.csv\": Disk quota exceeded",
        "cannot make the folder \"run\": Read-only file system",
        "cannot write log.txt: is the disk full?",
        "loads.h5 cannot be written",
        ""})
    EXPECT_TRUE(is_storage_failure(judged(
      {3, 0}, "", reason[0] == 0 ? "" : "error: " + std::string(reason))))
      << reason;
  EXPECT_TRUE(is_storage_failure(
    judged({1, 0},
           "",
           "error: cannot make the output folder: No space left on device")));
  EXPECT_FALSE(is_storage_failure(judged({1, 0}, "")));
  EXPECT_FALSE(is_storage_failure(judged({3, 0}, "", "error: out of memory")));
  EXPECT_FALSE(is_storage_failure(
    judged({2, 0}, R"({"status": "failed", "message": "negative"})")));
  EXPECT_FALSE(is_storage_failure(judged({0, SIGKILL}, "")));
  EXPECT_FALSE(
    is_storage_failure(judged({}, R"({"status": "finished", "retries": 0})")));
}

TEST(Outcome, IsFoundAgainForTheSameIdentityAlone)
{
  const contrecoup::io::TemporaryFolder folder;
  const std::string file = folder.path() + "/outcome.json";
  const std::string who = identity("blast", "1", 1, {{"A/B", "1"}});
  for (const std::string &other : {identity("blast", "2", 1, {{"A/B", "1"}}),
                                   identity("blast", "1", 2, {{"A/B", "1"}}),
                                   identity("blast", "1", 1, {{"A/B", "2"}})})
    EXPECT_NE(who, other);

  EXPECT_FALSE(read_outcome(file, who, 0.));
  Outcome outcome;
  outcome.kind = "unstable";
  outcome.reason = "a \"quoted\" reason";
  outcome.exit_code = 2;
  outcome.wall_seconds = 1.25;
  write_outcome(file, outcome, who);
  const auto found = read_outcome(file, who, 0.);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, outcome.kind);
  EXPECT_EQ(found->reason, outcome.reason);
  EXPECT_EQ(found->exit_code, 2);
  EXPECT_EQ(found->wall_seconds, 1.25);
  EXPECT_FALSE(read_outcome(file, identity("blast", "2", 1, {}), 0.));
}

TEST(Outcome, OfANewerFormatIsRefused)
{
  const contrecoup::io::TemporaryFolder folder;
  const std::string file = folder.path() + "/outcome.json";
  const std::string who = identity("blast", "1", 1, {});
  write_outcome(file, Outcome(), who);
  EXPECT_NO_THROW(read_outcome(file, who, 0.));
  std::ofstream(file) << R"({"format": 2})";
  EXPECT_THROW(read_outcome(file, who, 0.), contrecoup::InputError);
}

TEST(Outcome, OfADamagedFileIsNone)
{
  const contrecoup::io::TemporaryFolder folder;
  const std::string file = folder.path() + "/outcome.json";
  const std::string who = identity("blast", "1", 1, {});
  for (const std::string text :
       {"",
        "{ \"outcome\": \"sta",
        "[]",
        "{}",
        "{\"outcome\": 1, \"reason\": \"\", \"exit_code\": 0, "
        "\"wall_seconds\": 1, \"time_limit\": 0, \"identity\": {}}",
        "{\"outcome\": \"stable\", \"reason\": \"\", \"exit_code\": [0], "
        "\"wall_seconds\": 1, \"time_limit\": 0, \"identity\": {}}"})
  {
    std::ofstream(file) << text;
    testing::internal::CaptureStdout();
    EXPECT_FALSE(read_outcome(file, who, 0.)) << text;
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
              "the outcome \"" + file +
                "\" is damaged: its run is made again\n");
  }
}

TEST(Outcome, IsRepeatedWhenItMayTurnOutOtherwise)
{
  const contrecoup::io::TemporaryFolder folder;
  const std::string file = folder.path() + "/outcome.json";
  const std::string who = identity("blast", "1", 1, {});
  Outcome outcome;
  outcome.kind = "timed out";
  outcome.time_limit = 10.;
  write_outcome(file, outcome, who);
  EXPECT_TRUE(read_outcome(file, who, 10.));
  EXPECT_TRUE(read_outcome(file, who, 5.));
  EXPECT_FALSE(read_outcome(file, who, 20.));
  EXPECT_FALSE(read_outcome(file, who, 0.));
  outcome.kind = "failed";
  write_outcome(file, outcome, who);
  EXPECT_FALSE(read_outcome(file, who, 10.));
}
