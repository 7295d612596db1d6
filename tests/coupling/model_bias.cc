// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/coupling/application/model_bias.h>
#include <contrecoup/coupling/first_stage/staged_simulation.h>
#include <contrecoup/materials/explosives.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::coupling;

namespace
{
/// The warning of a run in 1-D with these entries.
std::vector<std::string> warning_of(const std::vector<std::string> &lines)
{
  dealii::ParameterHandler prm;
  StagedSimulation<3>::declare_parameters(prm);
  set_entries(prm, lines);
  return warn_of_bias(prm);
}
} // namespace


TEST(ModelBias, IsKnownForAllExplosivesOfTheLibrary)
{
  for (const std::string &name : explosive_names())
    for (const double distance : {1., 2.5, 6.})
    {
      const ModelBias bias = model_bias({name, 1.}, distance);
      EXPECT_LT(std::abs(bias.peak), 0.4) << name;
      EXPECT_LT(std::abs(bias.impulse), 0.4) << name;
      EXPECT_LT(std::abs(bias.duration), 0.6) << name;
    }
}


TEST(ModelBias, ScalesWithTheCubeRootOfTheMassInStepsOfAPerCent)
{
  // Without afterburn; with it, its time is another one for each mass.
  EXPECT_DOUBLE_EQ(model_bias({"anfo", 1.}, 2.).impulse,
                   model_bias({"anfo", 8.}, 4.).impulse);
  EXPECT_DOUBLE_EQ(model_bias({"tnt", 10.}, 2. * std::cbrt(10.)).impulse, 0.05);
  const BiasedBurst one = {"tnt", 1.};
  for (const double distance : {1.5, 2., 3., 4.})
    EXPECT_NEAR(model_bias(one, distance * (1. - 1e-9)).peak,
                model_bias(one, distance * (1. + 1e-9)).peak,
                0.01 + 1e-8);
  const double low = model_bias(one, 2.).impulse,
               high = model_bias(one, 3.).impulse;
  EXPECT_NEAR(
    model_bias(one, std::sqrt(6.)).impulse, 0.5 * (low + high), 0.005 + 1e-12);
}


// Plan, --estimate and report round one number once.
TEST(ModelBias, IsInWholePerCents)
{
  for (const std::string &name : explosive_names())
    for (double distance = 1.; distance < 6.; distance *= 1.07)
    {
      const double bias = model_bias({name, 1.}, distance).duration;
      if (std::isnan(bias))
        continue;
      EXPECT_NEAR(100. * bias, std::round(100. * bias), 1e-9) << name;
    }
}


// Nobody measured other constants, other afterburn and other distances.
TEST(ModelBias, IsUnknownForWhatWasNotMeasured)
{
  BiasedBurst burst = {"tnt", 1.};
  EXPECT_TRUE(std::isnan(model_bias(burst, 0.9).peak));
  EXPECT_TRUE(std::isnan(model_bias(burst, 6.1).impulse));
  EXPECT_EQ(in_words(model_bias({"tnt", 101.}, 10.)),
            "unknown: it was measured from 0.1 to 100 kg alone");
  // Of 0.1 kg the duration is 34 % less, of 0.3 kg 20 % more.
  EXPECT_NE(in_words(model_bias({"tnt", 0.2}, 0.88)).find("a second shock"),
            std::string::npos);
  EXPECT_EQ(in_words(model_bias(burst, 6.1)),
            "unknown: it was measured from 1 to 6 m/kg^(1/3) alone");
  burst.is_on_ground = true;
  EXPECT_EQ(in_words(model_bias(burst, 2.)),
            "unknown: it was measured for charges in free air alone");
  burst.has_usual_afterburn = false;
  EXPECT_TRUE(std::isnan(model_bias(burst, 2.).peak));
  EXPECT_EQ(in_words(model_bias(burst, 2.)),
            "unknown: it was not measured for afterburn of the user's own");
  burst = {"tnt", 1., true};
  EXPECT_TRUE(std::isnan(model_bias(burst, 2.).peak));
  EXPECT_EQ(in_words(model_bias(burst, 2.)),
            "unknown: it was not measured for constants of the user's own");
  EXPECT_EQ(in_words(ModelBias{-0.034, 0.125, -0.38}),
            "peak -3 %, impulse +13 %, duration -38 %");
}


// Lungs are judged by impulses and durations that the model has too small.
TEST(ModelBias, IsAWarningOfRunsWithInjuries)
{
  const std::vector<std::string> anfo = {
    "Domain/Dimension=1",
    "Domain/Geometry=spherical",
    "Material/Equation of state=jwl in air",
    "Material/Explosive=anfo",
    "Charges/Charge 1/Mass=8",
    "Probes/Points=2; 30",
    "Probes/Injury=true"};
  const auto lines = warning_of(anfo);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("WARNING: Material/Explosive = anfo: 2 m from the "
                          "charge"),
            std::string::npos);
  EXPECT_NE(lines[0].find("peak -9 %, impulse -28 %, duration -58 %"),
            std::string::npos);
  // A line of probes passes where the bias is largest.
  std::vector<std::string> with_line = anfo;
  with_line.insert(with_line.end(),
                   {"Probes/Points=", "Probes/Lines=0.5 : 30 : 10"});
  const auto of_line = warning_of(with_line);
  ASSERT_EQ(of_line.size(), 1U);
  EXPECT_NE(of_line[0].find("anfo: 2 m from the charge"), std::string::npos);
  for (const char *other : {"Domain/Geometry=plane",
                            "Charges/Charge 1/Shape=box",
                            "Probes/Injury=false",
                            "Probes/Points=30",
                            "Material/Explosive=tnt",
                            "Charges/Afterburn/Kind=miller",
                            "Charges/Charge 2/Mass=1"})
  {
    std::vector<std::string> changed = anfo;
    changed.push_back(other);
    EXPECT_TRUE(warning_of(changed).empty()) << other;
  }
}
