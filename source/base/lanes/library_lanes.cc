// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/library_lanes.h>

namespace contrecoup
{
template <unsigned int bits>
unsigned int library_has_lanes_of_bits()
{
  return bits;
}

template unsigned int library_has_lanes_of_bits<CONTRECOUP_LANE_BITS>();
} // namespace contrecoup
