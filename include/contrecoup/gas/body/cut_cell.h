// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>

namespace contrecoup::gas
{
/**
 * The fraction of the unit segment (n = 2 corners), square (4) or cube (8)
 * where a function is positive that has these values at the corners, in
 * deal.II's order, and is linear in the simplices between the lowest and the
 * highest corner (Kuhn 1960). Exact for linear functions; cells that share a
 * face see the same on it, so that the cut surface is closed.
 */
template <unsigned int n>
double positive_fraction(const std::array<double, n> &corners);
} // namespace contrecoup::gas
