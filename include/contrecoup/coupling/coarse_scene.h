// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters.h>

namespace contrecoup::coupling
{
/**
 * Makes the cells of a scene, and of its first stage, 2^@p levels times as
 * large: fewer refinements in all entries that count them and, when these are
 * used up, half as many coarse leaves in each direction, rounded up.
 * @param prm every entry of application blast
 * @return whether that changed the scene by the last of the levels
 */
bool coarsen_scene(ParameterHandler &prm, unsigned int levels);
} // namespace contrecoup::coupling
