// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
/// Version of Contrecoup, e.g. "0.1.0".
std::string version();

/// The git commit of the build, followed by "+" if files had been changed, or
/// by "?" if git was not available; "unknown" outside a git repository.
std::string git_revision();
} // namespace contrecoup
