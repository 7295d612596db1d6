// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <type_traits>

namespace contrecoup::gas
{
/// Floating-point format in which the kernels compute and store.
enum class Precision
{
  double_precision, ///< 53-bit significand
  single_precision  ///< 24-bit significand, twice as many lanes
};

/// Lanes of a batch in double precision.
inline constexpr unsigned int double_width = n_lanes<double>;

/// Lanes of the widest batch (single precision); a multiple of double_width.
inline constexpr unsigned int max_batch_width = n_lanes<float>;

/// Number of leaves in a batch: one leaf per lane.
inline unsigned int batch_width(const Precision precision)
{
  return precision == Precision::single_precision ? n_lanes<float>
                                                  : double_width;
}

/// Precision of the type @p Real, double or float.
template <typename Real>
inline constexpr Precision precision_of =
  std::is_same_v<Real, float> ? Precision::single_precision
                              : Precision::double_precision;

/// Number type of a kernel that is requested for @p Real: single precision is
/// available only in 3-D.
template <int dim, typename Real>
using kernel_number = std::conditional_t<dim == 3, Real, double>;

/// Calls @p function with a zero of the type (float or double) that belongs to
/// @p precision, and returns its result; only the type of the argument matters.
template <typename Function>
decltype(auto) visit_precision(const Precision precision,
                               const Function &function)
{
  return precision == Precision::single_precision ? function(float())
                                                  : function(double());
}
} // namespace contrecoup::gas
