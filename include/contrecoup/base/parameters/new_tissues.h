// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/tissues.h>

namespace contrecoup
{
/// Adds a tissue of the user's own to tissue_names(), for the rest of the
/// process, and returns it. A known name gives the tissue that has it. All
/// ranks must add the same names in the same order.
/// @throws InputError for a name that no list of names can hold
Tissue add_tissue(const std::string &name);

/// Whether the tissue was added by add_tissue().
bool is_new(Tissue tissue);
} // namespace contrecoup
