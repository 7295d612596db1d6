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
 * eigenvector, whose sign is open, by LAPACK. dealii::eigenvectors() has them,
 * too, but clang does not find those of a deal.II that g++ built.
 *
 * @throws dealii::LACExceptions::ExcLAPACKError for entries that are not finite
 */
std::array<std::pair<double, dealii::Tensor<1, 3>>, 3>
principal_axes(const dealii::SymmetricTensor<2, 3> &tensor);
} // namespace contrecoup
