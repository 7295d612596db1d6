// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/**
 * The application "scene": from a charge to what it does to a body, by the
 * stages anatomy, blast and biomechanics in folders of their own, and a
 * report. Collective; MPI is running. Never throws.
 * @param arguments of the command line, the program's name first
 */
Failure run_scene(const std::vector<std::string> &arguments);
} // namespace contrecoup::coupling
