// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/principal_axes.h>

#include <gtest/gtest.h>

using namespace contrecoup;

TEST(PrincipalAxes, FindEigenvaluesAndUnitVectors)
{
  for (const double size : {0., 1e-9, 1., 1e9})
  {
    dealii::SymmetricTensor<2, 3> tensor;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        tensor[i][j] = size * (i == j ? double(i) - 1. : 0.3 * double(i + j));
    const auto values = dealii::eigenvalues(tensor);
    const auto axes = principal_axes(tensor);
    for (unsigned int k = 0; k < 3; ++k)
    {
      const auto &[value, axis] = axes[k];
      EXPECT_NEAR(value, values[k], 1e-13 * size);
      EXPECT_NEAR(axis.norm(), 1., 1e-14);
      EXPECT_NEAR((tensor * axis - value * axis).norm(), 0., 1e-14 * size);
    }
  }
}
