// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/study/json_path.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

using contrecoup::InputError;
using contrecoup::study::number_at;

TEST(JsonPath, FindsNumbers)
{
  const auto json = nlohmann::json::parse(
    R"({"steps": 7, "errors": {"density_L1": 0.5, "broken": null}})");
  EXPECT_EQ(number_at(json, "steps", "it"), 7.);
  EXPECT_EQ(number_at(json, "errors.density_L1", "it"), 0.5);
  EXPECT_TRUE(std::isnan(number_at(json, "errors.broken", "it")));
}

TEST(JsonPath, SaysWhatThereIs)
{
  const auto json = nlohmann::json::parse(
    R"({"status": "finished", "errors": {"density_L1": 0.5}})");
  for (const char *path : {"errors", "status", "", "errors.density_L1.x"})
    EXPECT_THROW(number_at(json, path, "it"), InputError) << path;
  try
  {
    number_at(json, "errors.densty_L1", "the summary");
    FAIL();
  }
  catch (const InputError &error)
  {
    const std::string text = error.what();
    for (const char *part :
         {"the summary", "densty_L1", "errors", "did you mean \"density_L1\""})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}
