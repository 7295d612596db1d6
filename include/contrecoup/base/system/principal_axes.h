// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <utility>

namespace contrecoup
{
/**
 * Eigenvalues of a symmetric tensor, the largest first, each with a unit
 * eigenvector of arbitrary sign, by LAPACK. dealii::eigenvectors() does the
 * same, but what clang compiles does not link with that of a deal.II by g++.
 *
 * @throws dealii::LACExceptions::ExcLAPACKError for entries that are not finite
 */
std::array<std::pair<double, dealii::Tensor<1, 3>>, 3>
principal_axes(const dealii::SymmetricTensor<2, 3> &tensor);
} // namespace contrecoup
