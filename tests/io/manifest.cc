// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/name_patterns.h>
#include <contrecoup/io/output/manifest.h>

#include <gtest/gtest.h>

#include <filesystem>

using namespace contrecoup;
using namespace contrecoup::io;
namespace fs = std::filesystem;

namespace
{
using Names = std::vector<std::string>;

const FileNames names = {{"history.csv", "fields/fields_#.vtu"},
                         {"log.txt", "inner/"}};
const RunInput input = {{{"A/B", "1"}}, {}};

void write(const std::string &file, const std::string &text = "text")
{
  fs::create_directories(fs::path(file).parent_path());
  write_file(file, [&](std::ostream &out) { out << text; });
}

std::string fresh(const std::string &name)
{
  fs::remove_all(name);
  fs::create_directories(name);
  return name;
}

Names files_in(const std::string &folder)
{
  Names files;
  for (const auto &item : fs::recursive_directory_iterator(folder))
    if (!item.is_directory())
      files.push_back(item.path().lexically_relative(folder).string());
  std::sort(files.begin(), files.end());
  return files;
}

/// A run with two results, one more that is not one, and a file of the user.
Manifest finished_run(const std::string &folder)
{
  Manifest manifest(folder);
  manifest.begin("blast", names, input);
  for (const char *file :
       {"history.csv", "fields/fields_0000.vtu", "log.txt", "fields/x.txt"})
    write(folder + "/" + file);
  manifest.set_status("finished");
  return Manifest(folder);
}
} // namespace

TEST(NamePatterns, DigitsAndAnyCharacters)
{
  EXPECT_TRUE(matches("fields_0001.vtu", "fields_#.vtu"));
  EXPECT_TRUE(matches("fields_12345.0003.vtu", "fields_#.#.vtu"));
  EXPECT_TRUE(matches("plane_y_0_0001.vti", "plane_*_#.vti"));
  EXPECT_TRUE(matches("a", "*a"));
  EXPECT_FALSE(matches("fields_.vtu", "fields_#.vtu"));
  EXPECT_FALSE(matches("fields_1a.vtu", "fields_#.vtu"));
  EXPECT_FALSE(matches("fields_1.vtu2", "fields_#.vtu"));
  EXPECT_FALSE(matches("x.txt", "fields_#.vtu"));
  EXPECT_FALSE(matches("", "#"));
}

TEST(NamePatterns, FindAndRemoveNothingElse)
{
  const std::string folder = fresh("patterns");
  for (const char *file : {"a.csv",
                           "b.csv",
                           "sub/1/c.bin",
                           "sub/2/c.bin.partial",
                           "sub/two/c.bin",
                           "sub/1/note"})
    write(folder + "/" + file);
  const Names found = find_files(folder, {"a.csv", "sub/#/*.bin"});
  EXPECT_EQ(found, (Names{"a.csv", "sub/1/c.bin", "sub/2/c.bin.partial"}));
  remove_files(folder, found);
  EXPECT_EQ(files_in(folder), (Names{"b.csv", "sub/1/note", "sub/two/c.bin"}));
  EXPECT_FALSE(fs::exists(folder + "/sub/2"));
  EXPECT_NO_THROW(remove_files(folder, found));
}

TEST(Manifest, NothingIsContrecoupsWithoutOne)
{
  const std::string folder = fresh("without");
  for (const char *file : {"history.csv",
                           "fields/fields_0001.vtu",
                           "thesis.txt",
                           "fields/x.txt",
                           "inner/history.csv"})
    write(folder + "/" + file);
  const Manifest manifest(folder);
  EXPECT_FALSE(manifest.exists());
  EXPECT_EQ(manifest.own_files(), Names{});
  EXPECT_EQ(manifest.foreign_files(names),
            (Names{"fields/fields_0001.vtu", "history.csv"}));
}

TEST(Manifest, ForeignFilesAndFoldersInTheWay)
{
  const std::string folder = fresh("in_the_way");
  write(folder + "/fields", "a file where a folder is needed");
  fs::create_directories(folder + "/history.csv");
  write(folder + "/inner/manifest.json", "{}");
  EXPECT_EQ(Manifest(folder).foreign_files(names),
            (Names{"fields", "inner/", "history.csv/"}));
}

TEST(Manifest, NamesAreKnownBeforeFilesAreWritten)
{
  const std::string folder = fresh("killed");
  Manifest(folder).begin("blast", names, input);
  // The process ends without another word.
  write(folder + "/history.csv");
  write(folder + "/fields/fields_0000.vtu.partial");
  const Manifest manifest(folder);
  EXPECT_EQ(manifest.status(), "started");
  EXPECT_EQ(manifest.foreign_files(names), Names{});
  EXPECT_EQ(manifest.own_files(),
            (Names{"fields/fields_0000.vtu.partial", "history.csv"}));
}

TEST(Manifest, ANewRunRemovesOnlyWhatTheOldOneWrote)
{
  const std::string folder = fresh("again");
  finished_run(folder);
  write(folder + "/inner/y.txt");
  Manifest inner(folder + "/inner");
  inner.begin("anatomy", {{"mesh.vtu"}, {}}, {});
  write(folder + "/inner/mesh.vtu");
  write(folder + "/inner/lock");
  Manifest manifest(folder);
  manifest.begin("solid", {{"probes.csv"}, {}}, input);
  EXPECT_EQ(files_in(folder),
            (Names{"fields/x.txt", "inner/y.txt", "manifest.json"}));
  EXPECT_EQ(Manifest(folder).application(), "solid");
  // A file of the old run alone is not the new one's.
  write(folder + "/history.csv");
  EXPECT_EQ(Manifest(folder).own_files(), Names{});
  Manifest(folder).remove_all();
  EXPECT_EQ(files_in(folder),
            (Names{"fields/x.txt", "history.csv", "inner/y.txt"}));
}

TEST(Manifest, WhatAFinishedRunDidNotWriteIsNotIts)
{
  const std::string folder = fresh("added");
  finished_run(folder);
  write(folder + "/fields/fields_0001.vtu");
  EXPECT_EQ(Manifest(folder).foreign_files(names),
            Names{"fields/fields_0001.vtu"});
}

TEST(Manifest, EveryChangeOfAResultIsNoticed)
{
  const std::string folder = fresh("changed");
  EXPECT_EQ(finished_run(folder).damage(), "");
  write(folder + "/log.txt", "logs may change");
  EXPECT_EQ(Manifest(folder).damage(), "");
  write(folder + "/history.csv", "tExt");
  EXPECT_NE(Manifest(folder).damage().find("has changed"), std::string::npos);
  write(folder + "/history.csv", "tex");
  EXPECT_NE(Manifest(folder).damage().find("has 3 bytes instead of 4"),
            std::string::npos);
  fs::remove(folder + "/history.csv");
  EXPECT_NE(Manifest(folder).damage().find("history.csv\" is missing"),
            std::string::npos);
}

TEST(Manifest, DamagedOrOfSomethingElseIsRefused)
{
  const std::string folder = fresh("damaged");
  finished_run(folder);
  const std::string file = folder + "/manifest.json";
  const std::string good = read_file(file);
  const auto with = [&](const std::string &old, const std::string &now) {
    std::string text = good;
    return text.replace(text.find(old), old.size(), now);
  };
  // Names that lead out of the folder, as that of a pattern and of a result,
  // or to the folder itself.
  const std::string result = "\"history.csv\": {";
  ASSERT_NE(good.find(result), std::string::npos);
  for (const std::string &text : {std::string(),
                                  std::string("[]"),
                                  std::string("{\"name\": \"web\"}"),
                                  good.substr(0, good.size() / 2),
                                  with("log.txt", "../x.md"),
                                  with(result, "\"../x.md\": {"),
                                  with("log.txt", "./"),
                                  with("log.txt", "")})
  {
    write(file, text);
    EXPECT_THROW(Manifest{folder}, InputError) << text;
  }
}

TEST(RunInput, DiffersByEntriesAndByContentsOfFiles)
{
  const std::string file = fs::absolute("input.stl").string();
  write(file, "one");
  const RunInput before = make_run_input({{"A/File", file}, {"A/B", "1"}});
  EXPECT_EQ(before.files.size(), 1u);
  EXPECT_EQ(difference(before, before), "");
  RunInput now = before;
  now.entries["A/B"] = "2";
  EXPECT_EQ(difference(before, now), "\"A/B\" was \"1\" and is now \"2\"");
  write(file, "two");
  EXPECT_EQ(difference(before, make_run_input(before.entries)),
            "the file \"" + file + "\" has changed");
  now = before;
  now.entries.erase("A/B");
  EXPECT_NE(difference(before, now).find("now missing"), std::string::npos);
  EXPECT_NE(difference(now, before).find("no entry \"A/B\""),
            std::string::npos);
}
