// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * SIMD lanes at the full width of the processor. This header must precede every
 * deal.II header; the precompiled header ensures this.
 */

#include <contrecoup/base/deal_ii/lane_width.h>

namespace contrecoup
{
/// Number of values of type @p Number in a SIMD register.
template <typename Number>
inline constexpr unsigned int
  n_lanes = (CONTRECOUP_LANE_BITS / (8 * sizeof(Number)) > 0)
              ? CONTRECOUP_LANE_BITS / (8 * sizeof(Number))
              : 1;

/// The lane type of all kernels: n_lanes<Number> values.
template <typename Number>
using Lanes = dealii::VectorizedArray<Number, n_lanes<Number>>;
} // namespace contrecoup
