// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/state_file.h>
#include <contrecoup/io/file/temporary_folder.h>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

using namespace contrecoup;

namespace
{
struct Record
{
  std::uint32_t number;
  std::array<float, 2> values;
};

std::string refusal_of(const std::function<void()> &action)
{
  try
  {
    action();
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace

// Two ranks saved nodes 0 to 3 and 3 to 6; another has the nodes 6, 2 and 9.
TEST(StateFile, GivesEachRankWhatItHas)
{
  const io::TemporaryFolder folder;
  for (unsigned int rank = 0; rank < 2; ++rank)
    io::save_state(folder.path() + "/all." + std::to_string(rank) + ".bin",
                   [&](io::StateWriter &out) {
                     out.put(10. + rank);
                     out.put_records(4, [&](const std::size_t i) {
                       const auto number =
                         static_cast<std::uint32_t>(3 * rank + i);
                       return Record{number, {{0.5F * number, 1.F}}};
                     });
                     out.put_list(std::vector<int>{3, 1, int(rank)});
                   });
  const std::vector<std::uint32_t> numbers{6, 2, 9};
  const auto here =
    io::index_by_number(3, [&](const std::size_t i) { return numbers[i]; });
  std::array<float, 3> found{{-1.F, -1.F, -1.F}};
  double sum = 0.;
  std::vector<int> all;
  io::restore_parts(folder.path(), "all", [&](io::StateReader &in) {
    double value = 0.;
    in.take(value);
    EXPECT_EQ(value, 10. + in.rank());
    sum += value;
    in.take_records<Record>(here,
                            [&](const std::size_t i, const Record &record) {
                              found[i] = record.values[0];
                            });
    std::vector<int> list;
    in.take_list(list);
    all.insert(all.end(), list.begin(), list.end());
  });
  EXPECT_EQ(sum, 21.);
  EXPECT_EQ(found, (std::array<float, 3>{{3.F, 1.F, -1.F}}));
  EXPECT_EQ(all, (std::vector<int>{3, 1, 0, 3, 1, 1}));
}

TEST(StateFile, RefusesFilesThatAreShortOrMissing)
{
  const io::TemporaryFolder folder;
  const std::string file = folder.path() + "/one.bin";
  io::save_state(file, [](io::StateWriter &out) {
    out.put_list(std::vector<double>{1., 2., 3.});
  });
  std::vector<double> list;
  io::StateReader(file).take_list(list);
  EXPECT_EQ(list, (std::vector<double>{1., 2., 3.}));
  for (const unsigned int size : {31U, 8U, 3U, 0U})
  {
    std::filesystem::resize_file(file, size);
    EXPECT_EQ(refusal_of([&]() { io::StateReader(file).take_list(list); }),
              "Checkpoint file " + file + " ends too early");
  }
  std::filesystem::remove(file);
  EXPECT_EQ(refusal_of([&]() { io::StateReader reader(file); }),
            "Checkpoint file " + file + " is missing");
  EXPECT_EQ(refusal_of([&]() {
              io::restore_parts(
                folder.path(), "none", [](io::StateReader &) {});
            }),
            "Checkpoint file " + folder.path() + "/none.0.bin is missing");
}
