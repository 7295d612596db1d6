// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * SIMD lanes as wide as the processor, whatever deal.II was built with.
 *
 * Debian builds deal.II with a vectorization width of 0, so its default
 * VectorizedArray<double> has one lane. That default type must stay as the
 * library has it (one-definition rule), but wider specialisations may be
 * added: the width is raised around vectorization.h alone and put back. This
 * header must precede every other deal.II header; the precompiled header
 * sees to that.
 */

#include <deal.II/base/config.h>
#include <deal.II/base/numbers.h>

#if DEAL_II_VECTORIZATION_WIDTH_IN_BITS == 0
#  ifdef dealii_vectorization_h
#    error "contrecoup/base/lanes.h must precede deal.II's vectorization.h"
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
/// Number of values of type @p Number that one instruction works on.
template <typename Number>
inline constexpr unsigned int
  n_lanes = (CONTRECOUP_LANE_BITS / (8 * sizeof(Number)) > 0)
              ? CONTRECOUP_LANE_BITS / (8 * sizeof(Number))
              : 1;

/// The lane type of all kernels: n_lanes<Number> values side by side.
template <typename Number>
using Lanes = dealii::VectorizedArray<Number, n_lanes<Number>>;
} // namespace contrecoup
