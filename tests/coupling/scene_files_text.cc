// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/scene_files.h>

#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::coupling;

// The report reads the probes of the scene by their numbers.
TEST(TaskText, ProbesOfTheUserFollowThoseOfTheScene)
{
  const auto points = [](const std::string &section, const std::string &place) {
    Assignment assignment;
    assignment.sections = {"Probes"};
    if (!section.empty())
      assignment.sections.insert(assignment.sections.begin(), section);
    assignment.entry = "Points";
    assignment.value = place;
    return assignment;
  };
  const auto taken = [&](const std::string &own) {
    return task_text(
             "Blast",
             {points("", own)},
             dealii::ParameterHandler(),
             {points("Blast", "4, 5, 6"), points("Biomechanics", "7, 8, 9")},
             [](dealii::ParameterHandler &prm) {
               prm.enter_subsection("Probes");
               prm.declare_entry("Points", "");
               prm.leave_subsection();
             })
      .values.at("Probes/Points");
  };
  EXPECT_EQ(taken("1, 2, 3"), "1, 2, 3; 4, 5, 6");
  EXPECT_EQ(taken(""), "4, 5, 6");
}


// The scene takes corners of the user for its own; of what equals its own entry
// nothing is told.
TEST(TaskText, TellCornersOfTheUserAsChanged)
{
  const auto entry = [](const std::string &name, const std::string &value) {
    return parse_override(name + "=" + value);
  };
  const auto changes = task_text("Blast",
                                 {entry("Domain/Lower corner", "0, 0, 0"),
                                  entry("Domain/Size", "given")},
                                 dealii::ParameterHandler(),
                                 {entry("Blast/Domain/Lower corner", "0, 0, 0"),
                                  entry("Blast/Domain/Size", "given")},
                                 [](dealii::ParameterHandler &prm) {
                                   prm.enter_subsection("Domain");
                                   prm.declare_entry("Lower corner", "");
                                   prm.declare_entry("Size", "");
                                   prm.leave_subsection();
                                 })
                         .changes;
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].entry, "Blast/Domain/Lower corner");
  EXPECT_EQ(changes[0].value, "0, 0, 0");
  EXPECT_EQ(changes[0].before, "chosen by the scene");
}
