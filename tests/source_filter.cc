// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "source_filter.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>

std::string filter_of_sources(const std::string &list)
{
  std::set<std::string> sources;
  std::istringstream in(list);
  for (std::string name; std::getline(in, name, ',');)
    sources.insert(name);

  std::string filter;
  const auto &all = *::testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s)
  {
    const auto &suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t)
    {
      const auto &test = *suite.GetTestInfo(t);
      const std::filesystem::path file = test.file();
      if (sources.count(file.filename().string()) > 0)
        filter += std::string(suite.name()) + '.' + test.name() + ':';
    }
  }
  return filter;
}
