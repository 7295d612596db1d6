// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes.h>

#include <type_traits>

namespace contrecoup::gas
{
/// Format of the numbers that the kernels compute and store.
enum class Precision
{
  double_precision, ///< 53 bits
  single_precision  ///< 24 bits, twice as many lanes
};

/// Width of the lanes over leaves in double precision.
inline constexpr unsigned int W = n_lanes<double>;

/// Width of the widest lanes over leaves; a multiple of W.
inline constexpr unsigned int largest_width = n_lanes<float>;

/// Leaves that stand side by side in a batch.
inline unsigned int batch_width(const Precision precision)
{
  return precision == Precision::single_precision ? n_lanes<float> : W;
}

/// The format of double or float.
template <typename Real>
inline constexpr Precision precision_of =
  std::is_same_v<Real, float> ? Precision::single_precision
                              : Precision::double_precision;

/// What kernels compute with where @p Real is asked for: single precision
/// exists in 3-D alone.
template <int dim, typename Real>
using kernel_number = std::conditional_t<dim == 3, Real, double>;

/// Calls @p function with a number of that format, whose value is nothing.
template <typename Function>
decltype(auto) visit_precision(const Precision precision,
                               const Function &function)
{
  return precision == Precision::single_precision ? function(float())
                                                  : function(double());
}
} // namespace contrecoup::gas
