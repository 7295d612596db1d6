// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/explosive/afterburn.h>

#include "../../set_entries.h"
#include "gas_run.h"
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace contrecoup;
using namespace contrecoup::gas;

namespace
{
Afterburn parse(const std::vector<std::string> &lines)
{
  return described<Afterburn>(lines, "Afterburn/");
}

/// Products of one pressure in half of a box, air of another in the rest.
class Fireball
{
public:
  Fireball()
    : run(products_in_air() + finite_volume(4) +
          std::vector<std::string>{"Domain/Dimension=2",
                                   "Domain/Coarse leaves=2, 2"})
  {
    run.set_state([](const dealii::Point<2> &p) {
      GasState<2> state;
      const bool is_burned = p[0] < 0.5;
      state.density = is_burned ? 10. : 1.225;
      state.pressure = is_burned ? pressure : 101325.;
      state.products = is_burned ? 1. : 0.;
      return state;
    });
  }

  bool release(Afterburn &afterburn, const double time, const double step)
  {
    return afterburn.release(
      time, step, run.mesh, run.points, run.material, run.field);
  }

  static constexpr double pressure = 3e6;
  GasRun<2> run;
};
} // namespace


TEST(Afterburn, ConstantRateReleasesAllBetweenTwoTimes)
{
  Fireball fireball;
  Afterburn afterburn =
    parse({"Kind=constant", "Energy=2e6", "Start time=1e-3", "End time=3e-3"});
  auto before = fireball.run.totals();
  EXPECT_FALSE(fireball.release(afterburn, 1e-3, 1e-3));
  EXPECT_EQ(afterburn.fraction(), 0.);
  EXPECT_TRUE(fireball.release(afterburn, 1.5e-3, 5e-4));
  EXPECT_NEAR(afterburn.fraction(), 0.25, 1e-14);
  EXPECT_TRUE(fireball.release(afterburn, 9e-3, 7.5e-3));
  EXPECT_EQ(afterburn.fraction(), 1.);
  EXPECT_FALSE(fireball.release(afterburn, 1e-2, 1e-3));

  auto after = fireball.run.totals();
  const double energy = 2e6 * before["products_mass"];
  EXPECT_NEAR(afterburn.released(), energy, 1e-12 * energy);
  EXPECT_NEAR(after["energy"] - before["energy"], energy, 1e-9 * energy);
  EXPECT_EQ(after["mass"], before["mass"]);
  // The air holds no products and gets nothing.
  EXPECT_NEAR(after["smallest_pressure"], 101325., 1e-6);
}


// At constant pressure with m = 1/2, sqrt(1 - L) falls linearly in time.
TEST(Afterburn, MillersLaw)
{
  Fireball fireball;
  Afterburn afterburn = parse({"Kind=miller", "Energy=0"});
  const double rate = 6500. * std::pow(Fireball::pressure / 1e11, 1. / 6.);
  for (unsigned int i = 1; i <= 5; ++i)
  {
    fireball.release(afterburn, i * 1e-4, 1e-4);
    EXPECT_NEAR(afterburn.fraction(),
                1. - std::pow(1. - 0.5 * rate * i * 1e-4, 2.),
                1e-10);
  }
  // Past all fuel it is over.
  fireball.release(afterburn, 1., 1.);
  EXPECT_EQ(afterburn.fraction(), 1.);
  fireball.release(afterburn, 2., 1.);
  EXPECT_EQ(afterburn.fraction(), 1.);
}


TEST(Afterburn, IsSavedAndLoaded)
{
  Fireball fireball;
  Afterburn afterburn = parse({"Kind=miller"});
  fireball.release(afterburn, 1e-4, 1e-4);
  std::stringstream stream;
  afterburn.save(stream);
  Afterburn other = parse({"Kind=miller"});
  other.load(stream);
  EXPECT_EQ(other.fraction(), afterburn.fraction());
  EXPECT_EQ(other.released(), afterburn.released());
  EXPECT_GT(other.released(), 0.);
}


TEST(Afterburn, RefusesAnEndBeforeTheStart)
{
  EXPECT_THROW(parse({"Kind=constant", "Start time=1e-3", "End time=1e-4"}),
               InputError);
  EXPECT_FALSE(parse({}).active());
}
