// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>

namespace contrecoup::gas
{
/**
 * Fraction of the unit segment (n = 2 corners), square (4) or cube (8) in
 * which a function is positive [-].
 *
 * The function has the values @p corners, in deal.II's order, and is linear in
 * each simplex from the lowest to the highest corner (Kuhn 1960). The fraction
 * is exact for linear functions. Cells that share a face agree on the fraction
 * of that face, so that the cut surface is closed.
 */
template <unsigned int n>
double positive_fraction(const std::array<double, n> &corners);
} // namespace contrecoup::gas
