// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/exponential.h>
#include <contrecoup/base/lanes/lane_math.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace contrecoup;

namespace
{
template <typename Scalar>
Lanes<Scalar> ascending()
{
  Lanes<Scalar> lanes;
  for (unsigned int lane = 0; lane < Lanes<Scalar>::size(); ++lane)
    lanes[lane] = lane + 1;
  return lanes;
}
} // namespace


TEST(LaneMath, SelectsLaneByLane)
{
  using Number = Lanes<double>;
  const Number a = ascending<double>();
  const Number picked = select_less(a, Number(2.5), Number(-1.), Number(7.));
  for (unsigned int lane = 0; lane < Number::size(); ++lane)
    EXPECT_EQ(picked[lane], lane + 1 < 2.5 ? -1. : 7.);
  EXPECT_EQ(select_less(1., 1., 5., 6.), 6.);
  EXPECT_EQ(select_less(1.f, 2.f, 5.f, 6.f), 5.f);
  EXPECT_EQ(select_less(std::numeric_limits<double>::quiet_NaN(), 2., 5., 6.),
            6.);
}


template <typename Scalar>
void check_questions()
{
  using Number = Lanes<Scalar>;
  const Number a = ascending<Scalar>();
  const Scalar last = Number::size();
  EXPECT_TRUE(any_less(a, Number(Scalar(1.5))));
  EXPECT_FALSE(any_less(a, Number(Scalar(1.))));
  EXPECT_TRUE(all_greater(a, Number(Scalar(0.5))));
  EXPECT_FALSE(all_greater(a, Number(Scalar(1.))));
  EXPECT_EQ(smallest_lane(a), Scalar(1.));
  EXPECT_EQ(largest_lane(a), last);

  Number broken = a;
  broken[Number::size() - 1] = std::numeric_limits<Scalar>::quiet_NaN();
  EXPECT_FALSE(all_greater(broken, Number(Scalar(0.))));
  EXPECT_FALSE(any_less(Number(broken + last), Number(Scalar(1.))));
}


TEST(LaneMath, AnswersForAllLanes)
{
  check_questions<double>();
  check_questions<float>();
  EXPECT_TRUE(any_less(1., 2.));
  EXPECT_FALSE(all_greater(1., 2.));
  EXPECT_EQ(smallest_lane(3.), 3.);
  EXPECT_EQ(largest_lane(3.f), 3.f);
}


TEST(Exponential, IsExactToAUnitInTheLastPlace)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> wide(-708., 709.7);
  std::uniform_real_distribution<double> narrow(-2., 2.);
  double largest = 0., largest_float = 0.;
  for (unsigned int i = 0; i < 200000; ++i)
  {
    const double x = i % 2 == 0 ? wide(generator) : narrow(generator);
    const long double exact = std::exp(static_cast<long double>(x));
    const double value = exponential(Lanes<double>(x))[0];
    largest =
      std::max(largest, static_cast<double>(std::abs(value / exact - 1.L)));

    const float y = x * 0.12f;
    const double exact_float = std::exp(static_cast<double>(y));
    const double value_float = exponential(Lanes<float>(y))[0];
    largest_float =
      std::max(largest_float, std::abs(value_float / exact_float - 1.));
  }
  EXPECT_LT(largest, std::numeric_limits<double>::epsilon());
  EXPECT_LT(largest_float, std::numeric_limits<float>::epsilon());
}


TEST(Exponential, HandlesTheEndsOfTheRange)
{
  const auto of = [](const double x) {
    return exponential(Lanes<double>(x))[0];
  };
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(of(0.), 1.);
  EXPECT_EQ(of(-0.), 1.);
  EXPECT_EQ(of(-709.), 0.);
  EXPECT_EQ(of(-1e300), 0.);
  EXPECT_EQ(of(-infinity), 0.);
  EXPECT_EQ(of(710.), infinity);
  EXPECT_EQ(of(infinity), infinity);
  EXPECT_GT(of(-708.), 0.);
  EXPECT_EQ(exponential(Lanes<float>(-88.f))[0], 0.f);
  EXPECT_EQ(exponential(Lanes<float>(89.f))[0],
            std::numeric_limits<float>::infinity());
  EXPECT_EQ(exponential(1.), std::exp(1.));
  EXPECT_EQ(exponential(1.f), std::exp(1.f));
}
