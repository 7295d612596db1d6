// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/first_answer.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>

using namespace contrecoup;
using namespace contrecoup::coupling;
using dealii::Point;

namespace
{
/// Lines for TNT at x = 2.15 m next to a box 1.8 m high and 0.3 m deep.
std::vector<std::string> answer_for(const double mass,
                                    const bool has_usual_afterburn = true,
                                    const double height = 1.,
                                    const bool has_ground = true,
                                    const double x = 2.15,
                                    const double end_time = 0.01,
                                    const std::string &question = "injury")
{
  SceneParameters scene;
  scene.question = question;
  scene.accuracy = SceneParameters::accuracies[0];
  scene.explosive = find_explosive("tnt");
  scene.mass = mass;
  scene.place = Point<3>(x, 0., height);
  scene.end_time = end_time;
  scene.symmetry = "none";
  scene.has_usual_afterburn = has_usual_afterburn;
  const RoundedBox body(Point<3>(0., 0., 0.9), Point<3>(0.15, 0.25, 0.9), 0.05);
  OwnGrid own;
  own.has_ground = has_ground;
  return first_answer(scene, SceneLayout(scene, body, {}, own), 70.);
}


/// First number after @p words in any of the lines.
double number_after(const std::vector<std::string> &lines,
                    const std::string &words)
{
  std::smatch match;
  for (const std::string &line : lines)
    if (std::regex_search(line, match, std::regex(words + " ([-0-9.e+]+)")))
      return std::stod(match[1]);
  ADD_FAILURE() << "no " << words;
  return 0.;
}
} // namespace

// Read off the curves of Kingery and Bulmash for spheres in free air at Z = 2
// m/kg^(1/3): some 200 kPa, 590 kPa reflected, arrival after 2.1 ms.
TEST(FirstAnswer, HasTheWaveOfTheTablesAndWhatItDoes)
{
  const auto lines = answer_for(1.);
  const double peak = number_after(lines, "free air: peak");
  EXPECT_NEAR(peak, 200., 15.);
  EXPECT_NEAR(number_after(lines, "wall there: peak"), 590., 60.);
  EXPECT_NEAR(number_after(lines, "arrival"), 2.1, 0.3);
  // Half at 104 kPa, nearly all at 400 kPa.
  const double incident = number_after(lines, "incident peak: eardrum rupture");
  EXPECT_GT(incident, 70.);
  EXPECT_LT(incident, 95.);
  EXPECT_GE(number_after(lines, "reflected peak: eardrum rupture more than"),
            99.);
  // 3.3 ms or less of 200 kPa and 110 kPa of dynamic pressure.
  const double exposure =
    number_after(lines, "in the open has the lung loaded with");
  EXPECT_GT(exposure, 0.15);
  EXPECT_LT(exposure, 0.3);
  EXPECT_EQ(number_after(lines, "by lung injury: less than"), 0.1);
}


/// Whether any of the lines has these words.
bool has_words(const std::vector<std::string> &lines, const std::string &words)
{
  return std::any_of(lines.begin(), lines.end(), [&](const std::string &line) {
    return line.find(words) != std::string::npos;
  });
}


// Hemispherical charge of TNT at Z = 2: some 290 kPa; 200 kPa in free air.
TEST(FirstAnswer, HasTheWaveOfASurfaceBurstOnTheGroundAlone)
{
  const auto ground = answer_for(1., true, 0.06);
  EXPECT_NEAR(number_after(ground, "of a surface burst .*: peak"), 290., 25.);
  EXPECT_FALSE(has_words(ground, "reflection by the ground"));
  EXPECT_TRUE(has_words(ground, "charges in free air alone"));
  // The size of what is left out above it.
  const auto air = answer_for(1., true, 0.3);
  const double rise = number_after(air, "adds some");
  EXPECT_NEAR(number_after(air, "free air: peak") * (1. + 0.01 * rise),
              number_after(ground, "of a surface burst .*: peak"),
              2.);
  // Without ground there is nothing to reflect.
  const auto open = answer_for(1., true, 0.06, false);
  EXPECT_NEAR(number_after(open, "free air: peak"), 200., 15.);
  EXPECT_FALSE(has_words(open, "reflection by the ground"));
}


// The ground's reflection comes to who stands before a wave or after it, and
// not to a crown below the charge.
TEST(FirstAnswer, HasNoReflectionOfTheGroundBehindTheBody)
{
  const std::string hidden = "which the body keeps from the nearest skin";
  EXPECT_TRUE(has_words(answer_for(1., true, 3.8, true, 0.), hidden));
  const auto beside = answer_for(1., true, 2.5);
  EXPECT_FALSE(has_words(beside, hidden));
  EXPECT_TRUE(has_words(beside, "which comes after the wave"));
  EXPECT_TRUE(has_words(answer_for(1.), "where it has merged with the wave"));
}


// From 2.5 m above the ground its reflection takes some 5 ms.
TEST(FirstAnswer, LeavesOutNothingThatARunDoesNotHave)
{
  const auto answer = [](const double end_time, const std::string &question) {
    return answer_for(1., true, 2.5, true, 2.15, end_time, question);
  };
  EXPECT_TRUE(has_words(answer(0.01, "injury"),
                        "reflection by the ground, which comes after the wave, "
                        "shape and tissues of the body; a run has them"));
  EXPECT_TRUE(has_words(answer(0.003, "injury"),
                        "left out: shape and tissues of the body; a run has "
                        "them"));
  EXPECT_TRUE(has_words(answer(0.01, "loads"),
                        "comes after the wave, shape of the body; a run has "
                        "them"));
  EXPECT_TRUE(has_words(answer(0.003, "loads"),
                        "left out: shape of the body; a run has it"));
}


// A wall close behind the charge adds what the ground adds to a surface burst,
// one behind the body comes to its back.
TEST(FirstAnswer, TellsWhatAWallAdds)
{
  SceneParameters scene;
  scene.question = "injury";
  scene.accuracy = SceneParameters::accuracies[0];
  scene.explosive = find_explosive("tnt");
  scene.mass = 1.;
  scene.place = Point<3>(2.15, 0., 2.);
  scene.end_time = 0.02;
  scene.symmetry = "none";
  OwnGrid own;
  own.lower = Point<3>(-2.56, -2.56, 0.);
  own.upper = Point<3>(2.25, 2.56, 2.56);
  const RoundedBox body(Point<3>(0., 0., 0.9), Point<3>(0.15, 0.25, 0.9), 0.05);
  const auto lines = first_answer(scene,
                                  SceneLayout(scene, body, {}, own),
                                  70.,
                                  "",
                                  {{"x high", "wall", 0, true},
                                   {"x low", "wall", 0, false},
                                   {"y high", "open", 1, true}});
  EXPECT_TRUE(has_words(lines,
                        "reflection by the wall at x = 2.25 m (Blast/Boundaries"
                        "/x high), which adds some "))
    << lines[5];
  EXPECT_NEAR(number_after(lines, "x high., which adds some"), 45., 10.);
  EXPECT_TRUE(has_words(lines,
                        "reflection by the wall at x = -2.56 m (Blast/"
                        "Boundaries/x low), which the body keeps from the "
                        "nearest skin"));
  EXPECT_FALSE(has_words(lines, "y high"));
}


// 1 kg of TNT at 2 m, with other afterburn than measured.
TEST(FirstAnswer, TellsTheBiasOfTheModelOrThatItIsUnknown)
{
  const auto has = [](const std::vector<std::string> &lines,
                      const std::string &words) {
    return lines.back().find(words) != std::string::npos;
  };
  const std::string known =
    "peak -5 %, impulse +8 %, duration +12 % of these figures";
  EXPECT_TRUE(has(answer_for(1.), known)) << answer_for(1.).back();
  EXPECT_FALSE(has(answer_for(1., false), known));
  EXPECT_TRUE(has(answer_for(1., false), "unknown: it was not measured"));
}


// 1 kg of TNT has swept its mass of air at 2 m, 1000 kg have not.
TEST(FirstAnswer, HasTheReservationOfThePlanNearTheCharge)
{
  const auto has_reservation = [](const double mass) {
    const auto lines = answer_for(mass);
    return std::find(lines.begin(), lines.end(), "  " + unknown_beforehand()) !=
           lines.end();
  };
  EXPECT_FALSE(has_reservation(1.));
  EXPECT_TRUE(has_reservation(1000.));
}


TEST(FirstAnswer, SaysWhereTheTablesEnd)
{
  const auto lines = answer_for(1e-6);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NE(lines[0].find("do not cover 1e-06 kg of TNT at 2 m, but no more "
                          "than 0.4 m"),
            std::string::npos)
    << lines[0];
  EXPECT_NE(lines[1].find("continued by a point source: peak"),
            std::string::npos)
    << lines[1];
  EXPECT_NE(lines[2].find("reflection by the ground"), std::string::npos);
  // They reach 1.9996 m.
  EXPECT_TRUE(has_words(answer_for(1.24925e-4),
                        "of TNT at 2 m, but no more than 1.999 m"));
  // Nearer than 0.147 m/kg^(1/3) they have no impulse.
  const auto near = answer_for(6e3);
  ASSERT_EQ(near.size(), 3U);
  EXPECT_NE(near[1].find("of the tables: peak"), std::string::npos) << near[1];
}
