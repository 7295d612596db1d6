// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/collective.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/**
 * Application "scene": from a charge to its effect on a body. Runs the tasks
 * anatomy, blast and biomechanics, each in its own folder, and writes a
 * report. Collective; MPI is initialised. Never throws.
 * @param arguments command line, program name first
 */
Failure run_scene(const std::vector<std::string> &arguments);
} // namespace contrecoup::coupling
