// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/// Bounds of parameter entries [SI]. They lie far beyond practical values, and
/// keep sums, products and powers of user input finite.
namespace contrecoup::bounds
{
inline constexpr double length = 1e6;
inline constexpr double smallest_length = 1e-9;
inline constexpr double time = 1e9;
inline constexpr double speed = 3e8; // that of light
inline constexpr double density = 1e6;
inline constexpr double smallest_density = 1e-12;
inline constexpr double pressure = 1e15;
inline constexpr double mass = 1e6;
inline constexpr double energy = 1e18;
inline constexpr double specific_energy = 1e12;
/// For components of a direction vector of any length.
inline constexpr double direction = 1e6;
} // namespace contrecoup::bounds
