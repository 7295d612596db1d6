// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup::coupling
{
/**
 * SHA-1 of the sources of an application at the time of the build: of all files
 * of this project that its header in this folder leads to. Compilers, their
 * options and other libraries do not count, nor do the names of commits.
 * @param application anatomy, blast or biomechanics
 */
std::string source_digest(const std::string &application);
} // namespace contrecoup::coupling
