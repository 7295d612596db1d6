// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// Lines of a table for readers: each column is as wide as its widest cell.
std::vector<std::string>
aligned_rows(const std::vector<std::vector<std::string>> &rows);
} // namespace contrecoup
