// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/tissues.h>

namespace contrecoup
{
/// The tissues in a list of names, separated by commas.
/// @param entry that holds the list, for errors
/// @throws InputError for other names, and for "none"
std::vector<Tissue> find_tissues(const std::string &text,
                                 const std::string &entry);

/// The tissue with this name. @param entry that holds it, for errors
/// @throws InputError for other names, with a list, and for "none"
Tissue find_one_tissue(const std::string &name, const std::string &entry);
} // namespace contrecoup
