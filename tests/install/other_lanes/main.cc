// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/library_lanes.h>

int main()
{
  return static_cast<int>(contrecoup::library_lane_bits) % 2;
}
