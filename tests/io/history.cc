// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/output/history.h>
#include <contrecoup/io/output/history_reader.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace contrecoup;
using namespace contrecoup::io;

TEST(History, HasHeaderAndExactNumbers)
{
  HistoryFile file("table.csv");
  file.start();
  file.add_row({{"time", "s", 0.1}, {"count", "", 3.}});
  file.add_row({{"time", "s", 1. / 3.}, {"count", "", -1e-300}});
  file.flush();
  const std::string text = read_file("table.csv");
  EXPECT_EQ(text,
            "time [s],count\n0.1,3\n"
            "0.3333333333333333,-1e-300\n");
  EXPECT_EQ(file.size(), text.size());
}

TEST(History, ResumeCutsBack)
{
  std::uint64_t size = 0;
  {
    HistoryFile file("cut.csv");
    file.start();
    file.add_row({{"a", "m", 1.}});
    file.flush();
    size = file.size();
    file.add_row({{"a", "m", 2.}});
  }
  HistoryFile file("cut.csv");
  file.resume(size);
  file.add_row({{"a", "m", 3.}});
  EXPECT_THROW(file.add_row({{"b", "m", 3.}}), InputError);
  file.flush();
  EXPECT_EQ(read_file("cut.csv"), "a [m]\n1\n3\n");
  EXPECT_THROW(file.resume(100), InputError);
  file.resume(0);
  EXPECT_FALSE(std::filesystem::exists("cut.csv"));
}

TEST(History, IsReadAsItWasWritten)
{
  {
    HistoryFile file("read.csv");
    file.start();
    for (const double x : {0.1, 1. / 3., -1e-300})
      file.add_row({{"time", "s", x}, {"left ear", "Pa", 7. * x}});
  }
  const HistoryTable table = read_history("read.csv");
  EXPECT_EQ(table.names, std::vector<std::string>({"time", "left ear"}));
  EXPECT_EQ(table.column("time", "read.csv"),
            std::vector<double>({0.1, 1. / 3., -1e-300}));
  EXPECT_EQ(table.column("left ear", "read.csv")[1], 7. * (1. / 3.));
  EXPECT_THROW(table.column("right ear", "read.csv"), InputError);
}

TEST(History, SaysWhatIsWrongWithATable)
{
  const auto refusal = [](const std::string &text) -> std::string {
    std::ofstream("broken.csv") << text;
    try
    {
      read_history("broken.csv");
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "accepted";
  };
  const std::string header = "time [s],a [Pa]\n";
  EXPECT_EQ(refusal(header + "1,2\n3"),
            "\"broken.csv\", line 3: the row has 1 numbers for 2 columns");
  EXPECT_EQ(refusal(header + "1,2x\n"),
            "\"broken.csv\", line 2: the column \"a\" has \"2x\" instead of a "
            "number");
  EXPECT_EQ(refusal(header + "1,\n"),
            "\"broken.csv\", line 2: the column \"a\" has \"\" instead of a "
            "number");
  EXPECT_EQ(refusal(header + "1,nan\n"), "accepted");
  EXPECT_EQ(refusal(""), "cannot read the table \"broken.csv\": it is empty");
  EXPECT_EQ(
    refusal(std::string("\x89HDF")),
    "cannot read the table \"broken.csv\": it is not a text file: it is "
    "an HDF5 file");
  std::filesystem::remove("broken.csv");
  EXPECT_THROW(read_history("broken.csv"), InputError);
  EXPECT_THROW(read_history("."), InputError);
}

TEST(CheckedFile, LeavesNothingOfAFileThatCannotBeWritten)
{
  EXPECT_THROW(write_file("no_such_folder/file", [](std::ostream &) {}),
               SystemError);
  write_file("whole.txt", [](std::ostream &out) { out << "old"; });
  EXPECT_THROW(write_file("whole.txt",
                          [](std::ostream &out) {
                            out << "new";
                            throw SystemError("half-way");
                          }),
               SystemError);
  EXPECT_EQ(read_file("whole.txt"), "old");
  EXPECT_FALSE(std::filesystem::exists("whole.txt.partial"));
  EXPECT_THROW(read_file("no_such_file"), SystemError);
  // A device that is always full.
  std::filesystem::remove("full.partial");
  std::filesystem::create_symlink("/dev/full", "full.partial");
  EXPECT_THROW(write_file("full", [](std::ostream &out) { out << "x"; }),
               SystemError);
  EXPECT_FALSE(std::filesystem::exists("full"));
}
