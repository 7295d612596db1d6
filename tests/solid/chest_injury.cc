// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/injury/brain_measures.h>
#include <contrecoup/solid/injury/chest_injury.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

using namespace contrecoup::solid;

namespace
{
/// Friedlander's wave of 200 kPa and 5 ms, followed from @p start on for four
/// times as long, or for @p n_samples of 5 microseconds.
void follow_blast(ChestInjury &chest,
                  const double start,
                  const unsigned int n_samples = 4001)
{
  const double duration = 5e-3;
  for (unsigned int i = 0; i < n_samples; ++i)
  {
    const double s = i / 1000.;
    chest.record(
      start + s * duration, 200e3 * (1. - s) * std::exp(-s), 3. * s - s * s);
  }
}

std::map<std::string, double> values(const ChestInjury &chest)
{
  std::map<std::string, double> result;
  for (const InjuryMeasure &measure : chest.measures())
    result[measure.value.name] = measure.value.value;
  return result;
}
} // namespace

TEST(ChestInjury, TakesTheMassOfAPhantomUnlessAnotherIsChosen)
{
  for (const auto &[text, phantom, mass, guesses] :
       {std::tuple{"by body", 50., 50., false},
        std::tuple{"by body", std::nan(""), 78.5, true},
        std::tuple{"by body", 0.2, 0.2, false},
        std::tuple{"78.5", 50., 78.5, false}})
  {
    dealii::ParameterHandler prm;
    ChestInjury::declare_parameters(prm);
    prm.set("Body mass", text);
    ChestInjury chest;
    chest.parse_parameters(prm, phantom);
    EXPECT_EQ(chest.body_mass(), mass) << text;
    EXPECT_EQ(chest.guesses_mass(), guesses) << text;
  }
}


// Integrated independently: 6.020 m/s; the curve of Bowen has 941 kPa at 5 ms
// for 70 kg.
TEST(ChestInjury, OfFriedlandersWaveIsKnownWheneverItArrives)
{
  dealii::ParameterHandler prm;
  ChestInjury::declare_parameters(prm);
  prm.set("Body mass", "70");
  for (const double start : {0., 0.002, 0.5})
  {
    ChestInjury chest;
    chest.parse_parameters(prm, std::nan(""));
    follow_blast(chest, start);
    const auto found = values(chest);
    EXPECT_NEAR(found.at("injury_chest_wall_velocity"), 6.020, 2e-3) << start;
    EXPECT_NEAR(found.at("injury_adjusted_severity"),
                std::pow(0.124 + 0.117 * 6.020, 2.63),
                1e-3);
    EXPECT_DOUBLE_EQ(found.at("injury_chest_pressure_peak"), 200e3);
    EXPECT_NEAR(found.at("injury_lung_exposure"), 200. / 941., 1e-3);
    EXPECT_NEAR(found.at("injury_chest_wall_velocity_mesh"), 2.25, 1e-12);
    EXPECT_NE(chest.measures().back().limits.find("; for a body mass of 70 kg"),
              std::string::npos);
  }
}


// The wave lasts for 1000 samples, of which the first is its peak; the wall is
// fastest within the first 700, its image in the mesh after 1500.
TEST(ChestInjury, CallsWhatTheEndCutsOffALowerLimit)
{
  dealii::ParameterHandler prm;
  ChestInjury::declare_parameters(prm);
  for (const auto &[n_samples, limits] : std::map<unsigned int, std::string>{
         {100, "10111"}, {700, "10001"}, {1100, "10000"}, {4001, "00000"}})
  {
    ChestInjury chest;
    chest.parse_parameters(prm, std::nan(""));
    follow_blast(chest, 0., n_samples);
    std::string found;
    for (const InjuryMeasure &measure : chest.measures())
      found += measure.is_cut ? "1" : "0";
    EXPECT_EQ(found, limits) << n_samples;
    EXPECT_EQ(to_csv(chest.measures()).find("\",1\n") != std::string::npos,
              n_samples < 4001);
    std::string marked;
    for (const auto &value : values_of(chest.measures()))
      if (value.name.find("_cut_off") != std::string::npos)
        marked.back() = '1';
      else
        marked += '0';
    EXPECT_EQ(marked, limits) << n_samples;
  }
}


namespace
{
ChestInjury without_load()
{
  dealii::ParameterHandler prm;
  ChestInjury::declare_parameters(prm);
  prm.set("Chest load", "false");
  ChestInjury chest;
  chest.parse_parameters(prm, std::nan(""));
  return chest;
}
} // namespace


TEST(ChestInjury, LeavesTheLoadToTheGaugeOfTheBlast)
{
  ChestInjury chest = without_load();
  follow_blast(chest, 0.);
  const auto found = values(chest);
  EXPECT_EQ(found.size(), 1);
  EXPECT_NEAR(found.at("injury_chest_wall_velocity_mesh"), 2.25, 1e-12);
}


TEST(ChestInjury, HasNoInwardVelocityOfRoundOff)
{
  ChestInjury chest = without_load();
  chest.record(0., 0., 2.8e-19);
  chest.record(1e-3, 1e3, -0.4);
  EXPECT_EQ(values(chest).at("injury_chest_wall_velocity_mesh"), 0.);
}


TEST(ChestInjury, GoesOnFromWhatItFollowed)
{
  dealii::ParameterHandler prm;
  ChestInjury::declare_parameters(prm);
  ChestInjury whole, second;
  whole.parse_parameters(prm, std::nan(""));
  second.parse_parameters(prm, std::nan(""));
  follow_blast(whole, 0.);
  const auto until_700 = [](const std::vector<double> &values) {
    return std::vector<double>(values.begin(), values.begin() + 700);
  };
  second.restore(until_700(whole.times()),
                 until_700(whole.pressures()),
                 until_700(whole.wall_velocities()));
  for (std::size_t i = 700; i < whole.times().size(); ++i)
    second.record(
      whole.times()[i], whole.pressures()[i], whole.wall_velocities()[i]);
  EXPECT_EQ(values(second), values(whole));
}


TEST(ChestInjury, SaysNothingOfWhatWasNotFollowed)
{
  EXPECT_TRUE(ChestInjury().measures().empty());
}
