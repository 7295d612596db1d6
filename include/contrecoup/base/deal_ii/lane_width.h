// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * deal.II's SIMD vectors at the full width of the processor.
 *
 * A deal.II for any processor, as Debian's, is built with vectorization width
 * 0: its VectorizedArray<double> has one lane. That default must stay as in the
 * library (one-definition rule), but wider specialisations may be added: the
 * width is raised around vectorization.h only, and then restored. This header
 * must precede every other deal.II header; the precompiled header ensures
 * this. A deal.II built with a width keeps it.
 */

#include <deal.II/base/config.h>
#include <deal.II/base/numbers.h>

#if DEAL_II_VECTORIZATION_WIDTH_IN_BITS == 0
#  ifdef dealii_vectorization_h
#    error \
      "contrecoup/base/deal_ii/lane_width.h must precede deal.II's vectorization.h"
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
