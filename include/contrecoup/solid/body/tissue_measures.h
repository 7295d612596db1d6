// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/tissues.h>
#include <contrecoup/materials/small_matrix.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

/**
 * @file
 * Helper functions for measures of tissues.
 */

namespace contrecoup::solid
{
/// Choices for the pressure whose peaks are recorded: averaged as by
/// TissueAverage, or of each element.
const std::vector<std::string> &peak_pressure_names();

/// The column name "quantity_tissue", with underscores for blanks.
std::string tissue_column(const std::string &quantity, const Tissue tissue);

/**
 * Weighted percentile of a sample distributed over all ranks, as
 * weighted_percentile() defines it. Bisection finds it to 1e-12 of the largest
 * magnitude without gathering the sample. Collective.
 *
 * @param values of this rank
 * @param weights of the values, such as volumes
 * @param fraction of the total weight below the result, 0 to 1
 * @return 0 if all weights are zero
 */
double percentile(const std::vector<double> &values,
                  const std::vector<double> &weights,
                  const double fraction,
                  const MPI_Comm communicator);

/// Returns the larger of @p value and the largest principal value of @p
/// matrix. The eigenvalue is computed only if a cheap upper bound exceeds @p
/// value.
double raised_to_principal(const double value,
                           const Symmetric3<double> &matrix);
} // namespace contrecoup::solid
