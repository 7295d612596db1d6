// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/injury/brain_measures.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

using namespace contrecoup::solid;

namespace
{
bool is_cut(const std::vector<InjuryMeasure> &list, const std::string &name)
{
  for (const InjuryMeasure &measure : list)
    if (measure.value.name == name)
      return measure.is_cut;
  ADD_FAILURE() << "no " << name;
  return false;
}
} // namespace


// Forty elements as large as one another: a twentieth of the brain are two.
TEST(BrainMeasures, AreLowerLimitsWhileTheStrainOfATwentiethGrows)
{
  for (const unsigned int n_growing : {2, 3})
  {
    std::vector<BrainSample> samples(40);
    for (unsigned int i = 0; i < samples.size(); ++i)
    {
      samples[i].volume = 0.125;
      samples[i].record_strain(0.1);
      samples[i].record_strain(i < n_growing ? 0.11 : 0.1);
    }
    const auto list = brain_measures(samples, BrainSums(), MPI_COMM_SELF);
    for (const char *name :
         {"injury_strain_95", "injury_csdm_15", "injury_csdm_25"})
      EXPECT_EQ(is_cut(list, name), n_growing == 3) << name;
    EXPECT_FALSE(is_cut(list, "injury_intracranial_pressure_peak"));
  }
}


// Each case has the pressures of two elements over time; expected are marks of
// the highest pressure, the least one, and fraction and time below -100 kPa.
TEST(BrainMeasures, AreLowerLimitsOfPressuresThatAreAtTheEnd)
{
  using Course = std::vector<double>;
  struct Case
  {
    Course first, second;
    std::string marks;
  };
  for (const auto &[first, second, marks] : std::vector<Case>{
         {{1e4, 2e4, 0.}, {0., 1e4, -1.}, "0111"},
         {{1e4, 2e4, 0.}, {0., 3e4, 1e4}, "0000"},
         {{1e4, 2e4, 1e4}, {0., 1e4, 3e4}, "1000"},
         // The second rises and falls without being the extreme of all.
         {{4e4, -3e4, 0.}, {0., 2e4, 3e4}, "0000"},
         {{4e4, -3e4, 0.}, {0., 0., -2e4}, "0000"},
         // Tension that is less than before continues.
         {{0., -3e5, 0.}, {0., 0., -2e5}, "0001"},
         {{0., -3e5, -2e5}, {0., 0., 0.}, "0011"},
         // All of the brain cannot become more.
         {{0., -3e5, -2e5}, {0., -3e5, 0.}, "0001"},
         {{0., -3e5, 0.}, {0., 0., 0.}, "0000"},
         {{0., 0., 0.}, {0., 0., 0.}, "0000"}})
    for (const bool tension_grows : {false, true})
    {
      std::vector<BrainSample> samples(2);
      for (BrainSample &sample : samples)
      {
        sample.volume = 1.;
        for (const double pressure : &sample == &samples[0] ? first : second)
          sample.record_pressure(pressure);
      }
      std::string found;
      const auto list =
        brain_measures(samples, BrainSums(), MPI_COMM_SELF, tension_grows);
      for (const char *name : {"injury_intracranial_pressure_peak",
                               "injury_intracranial_pressure_lowest",
                               "injury_cavitating_fraction",
                               "injury_cavitation_dose"})
        found += is_cut(list, name) ? '1' : '0';
      const bool is_whole =
        first[1] < -1e5 && (second[1] < -1e5 || second[2] < -1e5);
      EXPECT_EQ(found,
                tension_grows ? marks.substr(0, 1) + (is_whole ? "101" : "111")
                              : marks)
        << first[1] << ' ' << second[2];
    }
}


TEST(InjuryMeasure, TellsOnWhichSideALowerLimitOfItsMagnitudeIs)
{
  for (const auto &[value, is_cut, words] :
       {std::tuple{-2., true, "a <= -2 Pa (none)"},
        {2., true, "a >= 2 Pa (none)"},
        {-2., false, "a = -2 Pa (none)"}})
    EXPECT_EQ(in_words({{"a", "Pa", value}, "none", "", is_cut}), words);
}


// A head that is pushed and turned by half a sine over 4 ms, and of which the
// end of the run leaves half.
TEST(BrainMeasures, AreLowerLimitsWhileTheHeadIsPushed)
{
  for (const double end : {2e-3, 8e-3})
  {
    HeadMotion motion;
    for (double time = 0.; time <= end; time += 2e-5)
    {
      const double speed = 1. - std::cos(M_PI * std::min(time / 4e-3, 1.));
      dealii::Tensor<1, 3> velocity;
      velocity[0] = 3. * speed;
      // It turns back after 4 ms.
      dealii::Tensor<1, 3> turning;
      turning[1] = 10. * std::sin(M_PI * time / 6e-3);
      motion.add(time, velocity, turning);
    }
    const auto list = head_motion_measures(motion, "the skull");
    for (const char *name :
         {"injury_hic15", "injury_hic15_ais2", "injury_bric"})
      EXPECT_EQ(is_cut(list, name), end < 4e-3) << name << " at " << end;
  }
}


// Rotation by round-off in a symmetric fall grows, too, and means nothing.
TEST(BrainMeasures, AreNoLowerLimitsOfTurnsByRoundOff)
{
  for (const double turn : {1e-7, 1.})
  {
    HeadMotion motion;
    for (unsigned int i = 0; i <= 200; ++i)
    {
      dealii::Tensor<1, 3> velocity, turning;
      velocity[2] = -3.;
      turning[0] = turn * i;
      motion.add(2e-5 * i, velocity, turning);
    }
    const auto list = head_motion_measures(motion, "the skull");
    for (const char *name : {"injury_bric", "injury_bric_ais2"})
      EXPECT_EQ(is_cut(list, name), turn == 1.) << name;
  }
}


TEST(BrainMeasures, AreLowerLimitsOfAShortRunWhereTheyStillGrow)
{
  for (const double end : {0.0099, std::nextafter(0.01, 0.), 0.01})
  {
    std::vector<InjuryMeasure> list;
    for (const char *name : {"injury_intracranial_pressure_peak",
                             "injury_strain_95",
                             "injury_csdm_25",
                             "injury_hic15",
                             "injury_hic15_ais2",
                             "injury_bric"})
      list.push_back({{name, "-", 0.1}, "", ""});
    mark_lower_limits(end, list);
    EXPECT_FALSE(list[0].is_cut);
    for (std::size_t i = 1; i < list.size(); ++i)
      EXPECT_EQ(list[i].is_cut, end < 0.00999) << list[i].value.name;
  }
}
