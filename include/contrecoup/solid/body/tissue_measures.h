// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/tissues.h>
#include <contrecoup/materials/small_matrix.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

/**
 * @file
 * What measures of tissues share.
 */

namespace contrecoup::solid
{
/// Words for the pressures that peaks are taken of: averaged over neighbours as
/// by TissueAverage, or of elements.
const std::vector<std::string> &peak_pressure_names();

/// "quantity_tissue", with underscores for blanks.
std::string tissue_column(const std::string &quantity, const Tissue tissue);

/**
 * The value below which a part of a weighted sample of all ranks lies, as
 * weighted_percentile() has it, without bringing the sample to one place: by
 * bisection, within 1e-12 of the largest magnitude. Collective.
 *
 * @param values of this rank
 * @param weights of these, such as volumes
 * @param part from 0 to 1 [-]
 * @return 0 for weights that are all zero
 */
double percentile(const std::vector<double> &values,
                  const std::vector<double> &weights,
                  const double part,
                  const MPI_Comm communicator);

/// The larger one of @p value and the largest principal value of a symmetric
/// matrix, which is only found when a bound lets it be the larger one.
double raised_to_principal(const double value,
                           const Symmetric3<double> &matrix);
} // namespace contrecoup::solid
