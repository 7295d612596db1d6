// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/small_matrix.h>

/**
 * @file
 * Invariants of stress and strain for reports.
 */

namespace contrecoup::solid
{
/// Largest of the three principal values of a symmetric matrix.
double largest_principal(const Symmetric3<double> &matrix);

/// Von Mises stress [Pa].
double von_mises(const Symmetric3<double> &stress);

/// Pressure: minus a third of the trace [Pa].
double pressure_of(const Symmetric3<double> &stress);
} // namespace contrecoup::solid
