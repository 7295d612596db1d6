// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/timers.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

using namespace contrecoup;

TEST(Timers, AddUpByName)
{
  Timers::instance().reset();
  for (int i = 0; i < 2; ++i)
  {
    const TimerScope timer("sleeping");
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(Timers::instance().entry("sleeping").calls, 2u);
  const auto seconds = Timers::instance().largest(MPI_COMM_WORLD);
  ASSERT_EQ(seconds.size(), 1u);
  EXPECT_GE(seconds.at("sleeping"), 0.02);
  EXPECT_NE(Timers::instance().table(MPI_COMM_WORLD, 1.).find("sleeping"),
            std::string::npos);
  Timers::instance().reset();
  EXPECT_TRUE(Timers::instance().largest(MPI_COMM_WORLD).empty());
}
