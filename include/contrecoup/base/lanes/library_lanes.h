// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * Lets the linker refuse a program that is compiled for other SIMD lanes than
 * the library: the data of both would differ in size and order.
 */

#include <contrecoup/base/deal_ii/lane_width.h>

namespace contrecoup
{
/// Returns @p bits. The library has this function for its own width alone.
template <unsigned int bits>
unsigned int library_has_lanes_of_bits();

/// Width of the library's SIMD lanes [bit]. Each program asks by itself: a
/// variable that it shared with the library would be set already.
[[maybe_unused]] static const unsigned int library_lane_bits =
  library_has_lanes_of_bits<CONTRECOUP_LANE_BITS>();
} // namespace contrecoup
