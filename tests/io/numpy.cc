// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/numpy.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>

using namespace contrecoup::io;

TEST(Numpy, FollowsTheFormat)
{
  const std::vector<double> data = {1., 2., 3., 4., 5., -0.1};
  write_npy("array.npy", {2, 3}, data);
  const std::string file = read_file("array.npy");
  EXPECT_EQ(file.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t start = 10 + static_cast<unsigned char>(file[8]) +
                            256 * static_cast<unsigned char>(file[9]);
  EXPECT_EQ(start % 64, 0u);
  EXPECT_EQ(file[start - 1], '\n');
  EXPECT_NE(
    file.find("'descr': '<f8', 'fortran_order': False, 'shape': (2,3,)"),
    std::string::npos);
  ASSERT_EQ(file.size(), start + 6 * sizeof(double));
  EXPECT_EQ(std::memcmp(file.data() + start, data.data(), 48), 0);
  EXPECT_THROW(write_npy("array.npy", {2, 2}, data), std::invalid_argument);
}

TEST(Numpy, ReadsBackWhatItWrote)
{
  const std::vector<double> data = {1., 2., 3., 4., 5., -0.1};
  write_npy("array.npy", {3, 2}, data);
  const NumpyArray array = read_npy("array.npy");
  EXPECT_EQ(array.shape, (std::vector<std::size_t>{3, 2}));
  EXPECT_EQ(array.data, data);
  write_file("cut.npy", [](std::ostream &out) {
    const std::string whole = read_file("array.npy");
    out << whole.substr(0, whole.size() - 1);
  });
  EXPECT_THROW(read_npy("cut.npy"), contrecoup::InputError);
  write_file("text.npy", [](std::ostream &out) { out << "hello\n"; });
  EXPECT_THROW(read_npy("text.npy"), contrecoup::InputError);
}

TEST(Numpy, PlanesSayWhereTheyAre)
{
  PlaneSamples plane;
  plane.quantity = "pressure";
  plane.unit = "Pa";
  plane.time = 0.5;
  plane.axes[0] = "x";
  plane.axes[1] = "z";
  plane.upper[0] = 2.;
  plane.upper[1] = 1.;
  plane.n_points[0] = 3;
  plane.n_points[1] = 2;
  plane.values = {0., 1., 2., 3., 4., 5.};
  write_plane("plane", plane);
  const auto json = nlohmann::json::parse(read_file("plane.json"));
  EXPECT_EQ(json["quantity"], "pressure");
  EXPECT_EQ(json["axes"][1], "z");
  EXPECT_EQ(json["upper"][0], 2.);
  EXPECT_NE(read_file("plane.npy").find("(2,3,)"), std::string::npos);
}
