// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/plane_file.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/study/error_measure.h>

#include "../set_entries.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

using namespace contrecoup;
using namespace contrecoup::study;

namespace
{
ErrorMeasure measure(const std::vector<std::string> &overrides)
{
  return described<ErrorMeasure>(overrides, "Error/");
}

const auto summary = nlohmann::json::parse(
  R"({"errors": {"density_L1": -0.25}, "conservation": {"mass_last": 6.0}})");
} // namespace

TEST(ErrorMeasure, TakesTheRunsOwnError)
{
  const ErrorMeasure exact = measure({});
  EXPECT_EQ(exact.value(".", summary), 0.25);
  EXPECT_EQ(exact.short_name(), "density_L1");
  EXPECT_THROW(measure({"Name=pressure_L1"}).value(".", summary), InputError);
}

TEST(ErrorMeasure, ComparesWithAKnownValue)
{
  const std::vector<std::string> known = {"Kind=known value",
                                          "Name=conservation.mass_last"};
  auto relative = known;
  relative.emplace_back("Known value=5");
  EXPECT_DOUBLE_EQ(measure(relative).value(".", summary), 0.2);
  EXPECT_EQ(measure(known).value(".", summary), 6.);
  EXPECT_EQ(measure(known).short_name(), "conservation_mass_last");
  const std::string title = "relative error of ";
  EXPECT_EQ(measure(known).title({{"results.mass", "mass", "kg"}}),
            title + "conservation.mass_last");
  EXPECT_EQ(measure(known).title({{"conservation.mass_last", "mass", "kg"}}),
            title + "mass");
}

TEST(ErrorMeasure, ComparesTablesAndPlanesOfRuns)
{
  const contrecoup::io::TemporaryFolder one, other;
  for (const contrecoup::io::TemporaryFolder *folder : {&one, &other})
  {
    const double factor = folder == &one ? 3. : 2.;
    std::ofstream(folder->path() + "/summary.json") << summary;
    std::ofstream(folder->path() + "/probes.csv")
      << "time [s],p [Pa]\n0,1\n1," << 1. + factor << "\n2,1\n";
    std::ofstream(folder->path() + "/history.csv")
      << "time [s],p [Pa]\n0,1\n1," << 1. + 2. * factor << "\n2," << 1. - factor
      << "\n3,1\n";
    const std::string fields = folder->path() + "/fields";
    std::filesystem::create_directories(fields);
    io::PlaneSamples plane;
    plane.axes = {{0, 1}};
    plane.n_points = {{2, 2}};
    plane.fields = {{"p", "Pa", {0., 0., 0., 0.}}};
    io::write_plane(fields + "/plane_0000.vti", plane);
    plane.fields[0].values = {factor, std::nan(""), factor, factor};
    io::write_plane(fields + "/plane_0001.vti", plane);
  }
  const auto difference = [&](const std::string &quantity,
                              const std::string &name) {
    return measure({"Kind=reference run",
                    "Reference folder=" + other.path(),
                    "Quantity=" + quantity,
                    "Name=" + name})
      .value(one.path(), summary);
  };
  EXPECT_DOUBLE_EQ(difference("probe peak", "p"), 0.5);
  EXPECT_DOUBLE_EQ(difference("probe impulse", "p"), 0.5);
  EXPECT_DOUBLE_EQ(difference("probe arrival", "p"), 0.);
  EXPECT_DOUBLE_EQ(difference("probe curve", "p"), 0.5);
  EXPECT_DOUBLE_EQ(difference("probe lowest", "p"), 0.);
  for (const char *const word : {"peak", "lowest", "impulse", "curve"})
    EXPECT_DOUBLE_EQ(difference(std::string("history ") + word, "p"), 0.5)
      << word;
  EXPECT_DOUBLE_EQ(difference("history arrival", "p"), 0.);
  EXPECT_DOUBLE_EQ(difference("plane", "plane_p"), 1.);
  EXPECT_DOUBLE_EQ(difference("summary", "conservation.mass_last"), 0.);
  // Means over 1 s of 1, 1 + f, 1: 1 + f / 4, 1 + 3 f / 4, 1 + f / 4.
  EXPECT_DOUBLE_EQ(measure({"Kind=reference run",
                            "Reference folder=" + other.path(),
                            "Quantity=probe curve",
                            "Name=p",
                            "Averaging time=1"})
                     .value(one.path(), summary),
                   1.);
  EXPECT_THROW(difference("plane", "plane_q"), InputError);
  EXPECT_THROW(difference("probe peak", "q"), InputError);
  EXPECT_THROW(difference("history lowest", "q"), InputError);
}

TEST(ErrorMeasure, RefusesWhatDoesNotGoTogether)
{
  EXPECT_THROW(measure({"Kind=reference run"}), InputError);
  EXPECT_THROW(measure({"Reference=A/B=1"}), InputError);
  EXPECT_THROW(measure({"Kind=reference run", "Reference=AB"}), InputError);
  EXPECT_THROW(
    measure({"Kind=reference run", "Reference=A/B=1", "Reference folder=x"}),
    InputError);
  EXPECT_THROW(measure({"Kind=known value", "Quantity=plane"}), InputError);
  EXPECT_THROW(measure({"Kind=known value", "Quantity=history curve"}),
               InputError);
  EXPECT_THROW(measure({"Kind=none", "Wanted error=1"}), InputError);
}
