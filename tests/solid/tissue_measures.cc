// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/head_injury.h>
#include <contrecoup/solid/body/stress_invariants.h>
#include <contrecoup/solid/body/tissue_measures.h>

#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;


TEST(TissueMeasures, PercentileOfAllRanksIsThatOfTheWholeSample)
{
  const int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0., 1e5);
  std::uniform_real_distribution<double> uniform(0.1, 1.);
  std::vector<double> values, weights, own_values, own_weights;
  for (int i = 0; i < 1000; ++i)
  {
    // Some values several times.
    values.push_back(i % 5 == 4 ? values.back() : normal(random));
    weights.push_back(uniform(random));
    if (i % n_ranks == rank)
    {
      own_values.push_back(values.back());
      own_weights.push_back(weights.back());
    }
  }
  for (const double part : {0., 0.05, 0.5, 0.95, 1.})
    EXPECT_EQ(solid::percentile(own_values, own_weights, part, MPI_COMM_WORLD),
              weighted_percentile(values, weights, part))
      << part;
}


TEST(TissueMeasures, PercentileOfEqualValuesAndOfNone)
{
  const std::vector<double> ones(3, 1.), zeros(3, 0.);
  EXPECT_EQ(solid::percentile(ones, ones, 0.95, MPI_COMM_WORLD), 1.);
  EXPECT_EQ(solid::percentile(zeros, ones, 0.95, MPI_COMM_WORLD), 0.);
  EXPECT_EQ(solid::percentile({}, {}, 0.95, MPI_COMM_WORLD), 0.);
}


TEST(TissueMeasures, RaisedToPrincipalIsTheMaximum)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  unsigned int n_raised = 0;
  for (unsigned int i = 0; i < 1000; ++i)
  {
    Symmetric3<double> matrix;
    for (unsigned int k = 0; k < 6; ++k)
      matrix[k] = normal(random);
    const double value = 2. * normal(random),
                 largest = solid::largest_principal(matrix);
    EXPECT_EQ(solid::raised_to_principal(value, matrix),
              std::max(value, largest));
    n_raised += largest > value ? 1 : 0;
  }
  EXPECT_GT(n_raised, 200U);
  EXPECT_LT(n_raised, 900U);
}


TEST(TissueMeasures, ColumnsHaveNoBlanks)
{
  EXPECT_EQ(solid::tissue_column("mass", Tissue::soft_tissue),
            "mass_soft_tissue");
}
