// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * SIMD lanes at the full width of the processor, independent of deal.II's
 * build.
 *
 * Debian builds deal.II with vectorization width 0, so that its default
 * VectorizedArray<double> has one lane. That default type must stay as in the
 * library (one-definition rule), but wider specialisations may be added: the
 * width is raised around vectorization.h only, and then restored. This header
 * must precede every other deal.II header; the precompiled header ensures
 * this.
 */

#include <deal.II/base/config.h>
#include <deal.II/base/numbers.h>

#if DEAL_II_VECTORIZATION_WIDTH_IN_BITS == 0
#  ifdef dealii_vectorization_h
#    error \
      "contrecoup/base/lanes/lanes.h must precede deal.II's vectorization.h"
#  endif
#  pragma push_macro("DEAL_II_VECTORIZATION_WIDTH_IN_BITS")
#  undef DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#  if defined(__AVX512F__)
#    define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 512
#    define CONTRECOUP_LANE_BITS 512
#  elif defined(__AVX__)
#    define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 256
#    define CONTRECOUP_LANE_BITS 256
#  elif defined(__SSE2__)
#    define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 128
#    define CONTRECOUP_LANE_BITS 128
#  else
#    define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 0
#    define CONTRECOUP_LANE_BITS 64
#  endif
#  include <deal.II/base/vectorization.h>
#  pragma pop_macro("DEAL_II_VECTORIZATION_WIDTH_IN_BITS")
#else
#  define CONTRECOUP_LANE_BITS DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#  include <deal.II/base/vectorization.h>
#endif

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
