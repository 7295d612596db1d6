// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * Units of the tables in publications [Pa].
 */

namespace contrecoup
{
constexpr double kilopascal = 1e3;
constexpr double megapascal = 1e6;
constexpr double gigapascal = 1e9;
} // namespace contrecoup
