// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/study/child_process.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>

using namespace contrecoup::study;

TEST(ChildProcess, TellsHowItEnded)
{
  const contrecoup::io::TemporaryFolder folder;
  const ProcessText text = run_process(
    {"sh", "-c", "echo out; echo 'error: bad' >&2; echo more >&2; exit 3"},
    folder.path());
  EXPECT_EQ(text.end.exit_code, 3);
  EXPECT_EQ(text.end.signal, 0);
  EXPECT_EQ(text.output, "out\n");
  EXPECT_EQ(text.errors, "bad");
  EXPECT_EQ(
    run_process({"sh", "-c", "kill -SEGV $$"}, folder.path()).end.signal,
    SIGSEGV);
  EXPECT_THROW(run_process({"/no/such/program"}, folder.path()),
               contrecoup::SystemError);
}

TEST(ChildProcess, IsEndedWithItsChildren)
{
  const contrecoup::io::TemporaryFolder folder;
  const std::string out = folder.path() + "/o", err = folder.path() + "/e";
  ChildProcess patient({"sh", "-c", "sleep 60 & wait"}, out, err);
  EXPECT_FALSE(patient.poll().has_value());
  patient.terminate(5.);
  ASSERT_TRUE(patient.poll().has_value());
  EXPECT_EQ(patient.poll()->signal, SIGTERM);
  // One that does not listen.
  ChildProcess deaf({"sh",
                     "-c",
                     "trap '' TERM; touch " + folder.path() +
                       "/on; while :; do sleep 0.05; done"},
                    out,
                    err);
  while (!std::filesystem::exists(folder.path() + "/on"))
    ;
  deaf.terminate(0.2);
  EXPECT_EQ(deaf.poll()->signal, SIGKILL);
}

TEST(ChildProcess, DoesNotInheritAnMpiJob)
{
  setenv("PMIX_RANK", "1", 1);
  setenv("PMIX_NAMESPACE", "job", 1);
  setenv("PMIX_MCA_gds", "hash", 1);
  setenv("OMPI_COMM_WORLD_RANK", "1", 1);
  setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", 1);
  setenv("PRTE_LAUNCHED", "1", 1);
  setenv("PRTE_MCA_rmaps_default_mapping_policy", "slot", 1);
  const contrecoup::io::TemporaryFolder folder;
  const std::string variables = run_process({"env"}, folder.path()).output;
  // Only settings are kept of PMIx's variables.
  for (auto at = variables.find("PMIX_"); at != std::string::npos;
       at = variables.find("PMIX_", at + 1))
    EXPECT_EQ(variables.substr(at, 9), "PMIX_MCA_") << variables.substr(at, 30);
  EXPECT_NE(variables.find("PMIX_MCA_gds=hash"), std::string::npos);
  EXPECT_EQ(variables.find("OMPI_COMM"), std::string::npos);
  EXPECT_NE(variables.find("OMPI_MCA_btl_vader"), std::string::npos);
  EXPECT_EQ(variables.find("PRTE_LAUNCHED"), std::string::npos);
  EXPECT_NE(variables.find("PRTE_MCA_rmaps_default_mapping_policy=slot\n"),
            std::string::npos);
  unsetenv("PMIX_RANK");
  unsetenv("PMIX_NAMESPACE");
  unsetenv("PMIX_MCA_gds");
  unsetenv("OMPI_COMM_WORLD_RANK");
  unsetenv("PRTE_LAUNCHED");
  unsetenv("PRTE_MCA_rmaps_default_mapping_policy");
}
