// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/model_bias.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::coupling;

namespace
{
SceneParameters scene_of(const std::string &explosive, const double mass)
{
  SceneParameters scene;
  scene.explosive = find_explosive(explosive);
  scene.mass = mass;
  scene.has_usual_afterburn = true;
  return scene;
}
} // namespace


TEST(ModelBias, IsKnownForAllExplosivesOfTheLibrary)
{
  for (const std::string &name : explosive_names())
    for (const double distance : {1., 2.5, 6.})
    {
      const ModelBias bias = model_bias(scene_of(name, 1.), distance);
      EXPECT_LT(std::abs(bias.peak), 0.4) << name;
      EXPECT_LT(std::abs(bias.impulse), 0.4) << name;
      EXPECT_LT(std::abs(bias.duration), 0.6) << name;
    }
}


TEST(ModelBias, ScalesWithTheCubeRootOfTheMassInStepsOfAPerCent)
{
  const SceneParameters one = scene_of("tnt", 1.), eight = scene_of("tnt", 8.);
  EXPECT_DOUBLE_EQ(model_bias(one, 2.).impulse, model_bias(eight, 4.).impulse);
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
      const double bias = model_bias(scene_of(name, 1.), distance).duration;
      EXPECT_NEAR(100. * bias, std::round(100. * bias), 1e-9) << name;
    }
}


// Nobody measured other constants, other afterburn and other distances.
TEST(ModelBias, IsUnknownForWhatWasNotMeasured)
{
  SceneParameters scene = scene_of("tnt", 1.);
  EXPECT_TRUE(std::isnan(model_bias(scene, 0.9).peak));
  EXPECT_TRUE(std::isnan(model_bias(scene, 6.1).impulse));
  EXPECT_EQ(in_words(model_bias(scene, 6.1)),
            "unknown: it was measured from 1 to 6 m/kg^(1/3) alone");
  EXPECT_EQ(in_words(model_bias(scene, 2., true)),
            "unknown: it was measured for charges in free air alone");
  scene.has_usual_afterburn = false;
  EXPECT_TRUE(std::isnan(model_bias(scene, 2.).peak));
  EXPECT_EQ(in_words(model_bias(scene, 2.)),
            "unknown: it was not measured for afterburn of the user's own");
  scene = scene_of("tnt", 1.);
  scene.custom_entries = {{"Like", "tnt"}};
  EXPECT_TRUE(std::isnan(model_bias(scene, 2.).peak));
  EXPECT_EQ(in_words(model_bias(scene, 2.)),
            "unknown: it was not measured for constants of the user's own");
  EXPECT_EQ(in_words(ModelBias{-0.034, 0.125, -0.38}),
            "peak -3 %, impulse +13 %, duration -38 %");
}
