// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// Position of @p name in @p names, which stand in the order of an enumeration.
/// @param kind what is chosen by name, for the message: "slope limiter"
/// @throws InputError that suggests the nearest name, for an unknown name
std::size_t position_of(const std::string &name,
                        const std::vector<std::string> &names,
                        const std::string &kind);
} // namespace contrecoup
