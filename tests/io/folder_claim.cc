// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/output/folder_claim.h>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>

using namespace contrecoup;
using namespace contrecoup::io;
namespace fs = std::filesystem;

namespace
{
const FileNames names = {{"history.csv"}, {"log.txt"}};
const RunInput input = {{{"A/B", "1"}}, {}};
const RunInput other = {{{"A/B", "2"}}, {}};

void write(const std::string &file, const std::string &text = "text")
{
  write_file(file, [&](std::ostream &out) { out << text; });
}

std::string fresh(const std::string &name)
{
  fs::remove_all(name);
  fs::create_directories(name);
  return name;
}

/// The message of the InputError that @p function throws.
template <typename Function>
std::string refusal(const Function &function)
{
  try
  {
    function();
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

bool has(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

/// Leaves a run with this status.
void leave_run(const std::string &folder, const std::string &status)
{
  FolderClaim claim(folder, "blast", names, input);
  claim.begin();
  write(folder + "/history.csv");
  claim.set_status(status);
}

bool may_proceed(const std::string &folder,
                 const RunInput &wanted,
                 const bool can_resume,
                 const std::string &option = "")
{
  CommandLine command;
  command.resume = option == "--resume";
  command.overwrite = option == "--overwrite";
  return FolderClaim(folder, "blast", names, wanted)
    .may_proceed(command, [&]() { return can_resume; });
}
} // namespace

TEST(FolderLock, TheSecondRunIsToldWhoHoldsIt)
{
  const std::string folder = fresh("locked");
  {
    const FolderLock lock(folder, "blast");
    const std::string message =
      refusal([&]() { const FolderLock second(folder, "scene"); });
    EXPECT_TRUE(
      has(message, "blast, process " + std::to_string(getpid()) + " on "))
      << message;
    EXPECT_TRUE(has(message, " since 2")) << message;
    // Whoever looks into the file must not open the lock.
    EXPECT_FALSE(read_file(folder + "/lock").empty());
    EXPECT_THROW(FolderLock(folder, "scene"), InputError);
  }
  EXPECT_FALSE(fs::exists(folder + "/lock"));
  EXPECT_NO_THROW(FolderLock(folder, "scene"));
}

TEST(FolderLock, AKilledProcessHoldsItNoLonger)
{
  const std::string folder = fresh("killed_holder");
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0)
  {
    const FolderLock lock(folder, "blast");
    if (::write(ends[1], "x", 1) == 1)
      pause();
    _exit(0);
  }
  char letter = 0;
  ASSERT_EQ(read(ends[0], &letter, 1), 1);
  EXPECT_TRUE(has(refusal([&]() { const FolderLock mine(folder, "blast"); }),
                  "process " + std::to_string(child)));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(folder + "/lock"));
  EXPECT_NO_THROW(FolderLock(folder, "blast"));
  close(ends[0]);
  close(ends[1]);
}

TEST(FolderLock, AForeignFileOfThisNameStays)
{
  const std::string folder = fresh("foreign_lock");
  write(folder + "/lock", "my own");
  EXPECT_THROW(FolderLock(folder, "blast"), InputError);
  EXPECT_EQ(read_file(folder + "/lock"), "my own");
}

TEST(FolderClaim, ResumesOrBeginsWhatLeftNothing)
{
  const auto goes_on = [&](const std::string &folder, const bool can_resume) {
    CommandLine command;
    command.resume = true;
    return FolderClaim(folder, "blast", names, input)
      .goes_on(command, can_resume);
  };
  const std::string killed = fresh("killed");
  leave_run(killed, "started");
  EXPECT_TRUE(goes_on(killed, true));
  EXPECT_FALSE(goes_on(killed, false));
  EXPECT_FALSE(goes_on(fresh("nothing"), false));
  // Others are left to who knows what they hold.
  const std::string finished = fresh("finished_before");
  leave_run(finished, "finished");
  EXPECT_TRUE(goes_on(finished, false));
  const std::string foreign = fresh("foreign");
  write(foreign + "/letter.txt");
  EXPECT_TRUE(goes_on(foreign, false));
  const std::string other = fresh("of_scene");
  FolderClaim(other, "scene", names, input).begin();
  EXPECT_TRUE(goes_on(other, false));
}

TEST(FolderClaim, LeavesNothingUnlessItBegins)
{
  fs::remove_all("a");
  {
    const FolderClaim claim("a/new/folder", "blast", names, input);
    EXPECT_TRUE(fs::exists("a/new/folder/lock"));
  }
  EXPECT_FALSE(fs::exists("a"));
}

TEST(FolderClaim, RefusesRootAndHome)
{
  const std::string home = fs::absolute(fresh("home")).string();
  const char *before = std::getenv("HOME");
  const std::string kept = before != nullptr ? before : "";
  setenv("HOME", home.c_str(), 1);
  for (const std::string &folder : {std::string("/"), home, home + "/."})
    EXPECT_TRUE(has(refusal([&]() {
                      const FolderClaim claim(folder, "blast", names, input);
                    }),
                    "give one below it"))
      << folder;
  EXPECT_TRUE(fs::is_empty(home));
  setenv("HOME", kept.c_str(), 1);
}

TEST(FolderClaim, RefusesForeignFilesThatItWouldOverwrite)
{
  const std::string folder = fresh("foreign");
  write(folder + "/thesis.txt");
  EXPECT_TRUE(may_proceed(folder, input, false));
  write(folder + "/history.csv", "mine");
  EXPECT_TRUE(
    has(refusal([&]() { may_proceed(folder, input, false, "--overwrite"); }),
        "history.csv"));
  EXPECT_EQ(read_file(folder + "/history.csv"), "mine");
}

TEST(FolderClaim, AFinishedRunStays)
{
  const std::string folder = fresh("finished");
  leave_run(folder, "finished");
  EXPECT_FALSE(may_proceed(folder, input, true));
  EXPECT_TRUE(has(refusal([&]() { may_proceed(folder, other, true); }),
                  "\"A/B\" was \"1\" and is now \"2\"; --overwrite"));
  EXPECT_TRUE(may_proceed(folder, other, true, "--overwrite"));
  EXPECT_TRUE(may_proceed(folder, other, true, "--resume"));
  write(folder + "/history.csv", "cut");
  EXPECT_TRUE(has(refusal([&]() { may_proceed(folder, input, true); }),
                  "--overwrite computes it anew"));
}

TEST(FolderClaim, WhatCanGoOnStays)
{
  for (const char *status : {"started", "stopped", "failed"})
  {
    const std::string folder = fresh("unfinished");
    leave_run(folder, status);
    const std::string message =
      refusal([&]() { may_proceed(folder, input, true); });
    EXPECT_TRUE(has(message, status)) << message;
    EXPECT_TRUE(has(message, "--resume goes on")) << message;
    EXPECT_TRUE(has(message, "--overwrite begins anew")) << message;
    EXPECT_TRUE(may_proceed(folder, input, false));
    EXPECT_TRUE(may_proceed(folder, input, true, "--resume"));
    EXPECT_TRUE(may_proceed(folder, input, true, "--overwrite"));
  }
}

TEST(FolderClaim, AnotherApplicationsResultsStay)
{
  const std::string folder = fresh("of_another");
  leave_run(folder, "failed");
  CommandLine command;
  const FolderClaim claim(folder, "biomechanics", names, input);
  EXPECT_TRUE(
    has(refusal([&]() { claim.may_proceed(command, {}); }), "\"blast\""));
}
