// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/names.h>

#include <gtest/gtest.h>

using namespace contrecoup;

TEST(Names, HavePositions)
{
  const std::vector<std::string> names = {"minmod", "van leer"};
  EXPECT_EQ(position_of("minmod", names, "limiter"), 0u);
  EXPECT_EQ(position_of("van leer", names, "limiter"), 1u);
}

TEST(Names, UnknownOnesGetTheNearestOne)
{
  try
  {
    position_of("van lear", {"minmod", "van leer"}, "limiter");
    ADD_FAILURE() << "accepted";
  }
  catch (const InputError &error)
  {
    EXPECT_EQ(error.what(),
              std::string("\"van lear\" is no limiter; did you mean \"van "
                          "leer\"? Known are: minmod, van leer"));
  }
}
