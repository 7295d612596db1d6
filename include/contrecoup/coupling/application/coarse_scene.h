// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>

namespace contrecoup::coupling
{
/**
 * Coarsens a scene and its first stage: subcells become 2^@p levels times as
 * large. Halves the number of coarse leaves in each direction while it is even
 * in all, which keeps what is refined where; then lowers all entries that count
 * refinement levels and, once these are zero, halves the leaves rounding up.
 * @param prm all entries of application blast
 * @return whether the last of the levels still changed the scene
 */
bool coarsen_scene(ParameterHandler &prm, unsigned int levels);
} // namespace contrecoup::coupling
