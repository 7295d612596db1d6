// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/log.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace contrecoup;

TEST(Log, QuietScreenGetsWarningsAndWhatIsShown)
{
  Log &log = Log::instance();
  log.close();
  log.set_verbose(false);
  testing::internal::CaptureStdout();
  log_line("a detail");
  log_line("  WARNING: the record ends early");
  log_line("WARNING: the record ends early");
  log_line("No WARNING: at its beginning");
  show_line("the answer");
  const std::string screen = testing::internal::GetCapturedStdout();
  log.set_verbose(true);
  EXPECT_EQ(screen, "  WARNING: the record ends early\nthe answer\n");
  EXPECT_EQ(log.warnings(), std::vector<std::string>{"the record ends early"});
  log.close();
  EXPECT_TRUE(log.warnings().empty());
}

TEST(Log, ScreenGetsOnlyWarningsAndProgressOfAPart)
{
  Log &log = Log::instance();
  log.close();
  log.set_verbose(false);
  testing::internal::CaptureStdout();
  {
    const LogPart part("blast");
    show_line("the answer of a stage");
    log_line("WARNING: of a stage");
    log.take_back("not of a stage");
    log.progress("50 %");
  }
  {
    const LogPart part("coarser", true);
    log_line("WARNING: of a quiet stage");
    log.take_back("not of a quiet stage");
    EXPECT_EQ(log.warnings(), std::vector<std::string>{"of a quiet stage"});
  }
  show_line("the answer");
  const std::string screen = testing::internal::GetCapturedStdout();
  log.set_verbose(true);
  log.close();
  EXPECT_EQ(screen,
            "WARNING: of a stage\nnot of a stage\nblast: 50 %\nthe answer\n");
}
