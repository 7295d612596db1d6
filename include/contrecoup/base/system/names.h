// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// Position of @p name in @p names, the order of an enumeration.
/// @param kind of what has these names, for the message: "slope limiter"
/// @throws InputError that suggests the nearest name if there is none
std::size_t position_of(const std::string &name,
                        const std::vector<std::string> &names,
                        const std::string &kind);
} // namespace contrecoup
