// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/study/convergence.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup::study;

TEST(Convergence, FindsTheOrderOfAPowerLaw)
{
  EXPECT_NEAR(observed_order(3. * 0.01, 3. * 0.0025, 0.1, 0.05), 2., 1e-12);
  EXPECT_NEAR(observed_order(std::pow(0.3, 1.5), std::pow(0.1, 1.5), 0.3, 0.1),
              1.5,
              1e-12);
  EXPECT_TRUE(std::isnan(observed_order(1., 0., 0.1, 0.05)));
  EXPECT_TRUE(std::isnan(observed_order(1., 0.5, 0.1, 0.1)));
  EXPECT_TRUE(std::isnan(observed_order(std::nan(""), 0.5, 0.1, 0.05)));
}

TEST(Convergence, ExtrapolatesWhatConvergesSteadily)
{
  // Unequal ratios of the mesh widths, falling and rising quantities.
  const std::vector<double> widths = {0.5, 0.2, 0.1, 0.07};
  for (const double order : {0.7, 1., 2.3, 4.})
    for (const double constant : {3., -0.2})
    {
      std::vector<double> values;
      for (const double width : widths)
        values.push_back(5. + constant * std::pow(width, order));
      const Extrapolation found = extrapolate(widths, values);
      EXPECT_TRUE(found.is_asymptotic);
      EXPECT_NEAR(found.order, order, 1e-8);
      EXPECT_NEAR(found.limit, 5., 1e-9);
    }
}

TEST(Convergence, DoesNotExtrapolateWhatDoesNotConverge)
{
  const std::vector<double> widths = {0.4, 0.2, 0.1};
  // To and fro; moving away faster and faster; not moving.
  for (const std::vector<double> &values :
       {std::vector<double>{1., 2., 1.5}, {1., 2., 4.}, {1., 1., 1.}})
  {
    const Extrapolation found = extrapolate(widths, values);
    EXPECT_FALSE(found.is_asymptotic);
    EXPECT_TRUE(std::isnan(found.order));
    EXPECT_EQ(found.limit, values.back());
  }
  EXPECT_THROW(extrapolate({0.2, 0.1}, {1., 2.}), contrecoup::InputError);
}
