// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup::coupling
{
/**
 * SHA-1 of the sources of an application at build time: all files of this
 * project that the application's header includes, directly or indirectly.
 * Compiler, options, other libraries and commit names do not enter.
 *
 * @param application anatomy, blast or biomechanics
 */
std::string source_digest(const std::string &application);
} // namespace contrecoup::coupling
