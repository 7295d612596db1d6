// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
/// The version of Contrecoup, e.g. "0.1.0".
std::string version();

/// The git commit it was built from, with "+" after it when files had been
/// changed, or with "?" when git was not there to tell; "unknown" outside a git
/// repository.
std::string git_revision();
} // namespace contrecoup
