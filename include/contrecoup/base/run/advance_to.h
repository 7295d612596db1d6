// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>

#include <cstdint>

namespace contrecoup
{
/// Advances a solver, after its setup(), to the time @p end [s] and adapts it
/// after each step, as RunLoop does, without output. Collective.
/// @return number of steps
/// @throws NumericsError when no step size gives a physical state
std::uint64_t advance_to(Simulation &simulation, const double end);
} // namespace contrecoup
