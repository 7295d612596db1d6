// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lanes.h>

#include <contrecoup/gas/galerkin/scaling_to_mean.h>
#include <contrecoup/materials/ideal_gas.h>

#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;

namespace
{
using Number = Lanes<double>;
using C = Component<1>;
constexpr unsigned int n_nodes = 4;

/// A leaf in 1-D at rest, of which all lanes are alike.
struct Leaf
{
  Leaf()
    : values(3 * n_nodes)
    , volume(n_nodes)
  {
    for (unsigned int q = 0; q < n_nodes; ++q)
    {
      volume[q] = q == 0 || q == n_nodes - 1 ? 1. : 5.;
      at(C::density, q) = 1.;
      at(C::momentum, q) = 0.;
      at(C::energy, q) = 2.5;
    }
  }

  Number &at(const unsigned int component, const unsigned int node)
  {
    return values[component * n_nodes + node];
  }

  double mean(const unsigned int component, const unsigned int lane)
  {
    double sum = 0., whole = 0.;
    for (unsigned int q = 0; q < n_nodes; ++q)
    {
      sum += at(component, q)[lane] * volume[q][lane];
      whole += volume[q][lane];
    }
    return sum / whole;
  }

  Number restore(const bool positivity = true)
  {
    const IdealGas gas(1.4);
    return ScalingToMean<1, IdealGas, Number>(gas, values, volume)
      .restore_positivity(positivity);
  }

  dealii::AlignedVector<Number> values, volume;
};
} // namespace


TEST(ScalingToMean, RestoresNodesAndKeepsTheMean)
{
  for (const unsigned int component : {C::density, C::energy})
  {
    Leaf leaf;
    leaf.at(component, 1)[0] = -0.5;
    const double mean = leaf.mean(component, 0);
    EXPECT_EQ(leaf.restore()[0], 1.);
    EXPECT_GT(leaf.at(component, 1)[0], 0.);
    EXPECT_NEAR(leaf.mean(component, 0), mean, 1e-15);
  }
}


TEST(ScalingToMean, ReportsLeavesThatStayUnphysical)
{
  Leaf empty;
  for (unsigned int q = 0; q < n_nodes; ++q)
    empty.at(C::density, q)[0] = -1.;
  EXPECT_EQ(empty.restore()[0], 0.);

  Leaf negative;
  negative.at(C::density, 1)[0] = -0.5;
  EXPECT_EQ(negative.restore(false)[0], 0.);
}


// A node nearly at the bound is admissible: it must keep every bit, whichever
// leaves share the batch, since that depends on the ranks.
TEST(ScalingToMean, LeavesAdmissibleLanesAlone)
{
  for (const unsigned int component : {C::density, C::energy})
  {
    Leaf leaf;
    leaf.at(component, 1)[0] = 1e-12;
    leaf.at(component, 2)[1] = -0.5;
    const Leaf before = leaf;
    const Number good = leaf.restore();
    EXPECT_EQ(good[0], 1.);
    EXPECT_EQ(good[1], 1.);
    for (unsigned int i = 0; i < leaf.values.size(); ++i)
      EXPECT_EQ(leaf.values[i][0], before.values[i][0]) << "value " << i;
    EXPECT_GT(leaf.at(component, 2)[1], 0.);
  }
}
