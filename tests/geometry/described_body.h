// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/body_description.h>

#include "../set_entries.h"
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

namespace contrecoup
{
/// The body of entries such as "Kind=mesh".
inline BodyPointer described_body(std::vector<std::string> entries,
                                  const std::vector<std::string> &more)
{
  entries.insert(entries.end(), more.begin(), more.end());
  return described<BodyDescription>(entries).create();
}

/// A folder for files of one test.
class BodyFiles : public ::testing::Test
{
protected:
  BodyFiles()
  {
    std::filesystem::create_directories(folder_);
  }
  ~BodyFiles() override
  {
    std::filesystem::remove_all(folder_);
  }

  /// A body of a file and further entries.
  virtual BodyPointer create(const std::string &file,
                             const std::vector<std::string> &more) const = 0;

  /// Why such a body is refused, in one line; "" where it is not.
  std::string refusal(const std::string &file,
                      const std::vector<std::string> &more = {}) const
  {
    try
    {
      create(file, more);
    }
    catch (const InputError &error)
    {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_ =
    std::filesystem::temp_directory_path() /
    ("contrecoup_body_" + std::to_string(getpid()));
};
} // namespace contrecoup
