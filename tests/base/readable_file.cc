// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

using namespace contrecoup;

namespace
{
/// The message that reading a file of this content gives, or its text.
std::string reading(const std::string &content)
{
  std::ofstream("read_me", std::ios::binary) << content;
  try
  {
    return read_text("the table", "read_me", 1U << 24);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
}
} // namespace

TEST(ReadableFile, SaysWhyAFileCannotBeRead)
{
  std::filesystem::create_directories("a_folder");
  std::ofstream("closed") << "x";
  EXPECT_EQ(why_unreadable("closed"), "");
  EXPECT_EQ(why_unreadable("a_folder"), "it is a folder");
  EXPECT_EQ(why_unreadable("nowhere/file"), "there is no such file");
  EXPECT_EQ(why_unreadable("closed/file"), "there is no such file");
  EXPECT_EQ(why_unreadable(""), "its name is empty");
  EXPECT_EQ(why_unreadable(std::string(5000, 'x')), "File name too long");
  std::filesystem::permissions("closed", std::filesystem::perms::none);
  // The superuser may read all.
  EXPECT_EQ(why_unreadable("closed"),
            geteuid() == 0 ? "" : "Permission denied");
  std::filesystem::remove("closed");
}

TEST(ReadableFile, TextIsUtf8)
{
  EXPECT_EQ(reading("a\r\nb\rc\n"), "a\nb\nc\n");
  EXPECT_EQ(reading("\xEF\xBB\xBF\xC3\xA4"), "\xC3\xA4");
  const std::string problem = "cannot read the table \"read_me\": it is not a "
                              "text file: ";
  EXPECT_EQ(reading("\xFF\xFEs"),
            problem + "it is encoded as UTF-16; UTF-8 is wanted");
  EXPECT_EQ(reading("\xFE\xFFs"),
            problem + "it is encoded as UTF-16; UTF-8 is wanted");
  EXPECT_EQ(reading("\x89HDF\r\n"), problem + "it is an HDF5 file");
  EXPECT_EQ(reading(std::string("s\0e\0t\0", 6)),
            problem + "its byte 2 is 0, as in UTF-16 or a binary file");
  EXPECT_EQ(reading("set\x01"),
            problem + "its byte 4 is 1, as in UTF-16 or a binary file");
  EXPECT_EQ(reading(std::string((1U << 24) + 1, 'x')),
            "cannot read the table \"read_me\": it has more than 16 MiB");
  EXPECT_EQ(reading(std::string(1U << 24, 'x')).size(), std::size_t(1U << 24));
}

TEST(ReadableFile, QuotesOneLineOfAnyText)
{
  EXPECT_EQ(quotation("a b"), "\"a b\"");
  EXPECT_EQ(quotation("a\nb\x1B"), "\"a?b?\"");
  EXPECT_EQ(quotation(std::string(60, 'x')),
            "\"" + std::string(60, 'x') + "\"");
  EXPECT_EQ(quotation(std::string(61, 'x')),
            "\"" + std::string(60, 'x') + "...\"");
  EXPECT_EQ(quotation(std::string(59, 'x') + "\xC3\xA4z"),
            "\"" + std::string(59, 'x') + "...\"")
    << "no half of a letter";
}
