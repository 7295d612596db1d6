// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
/// Indents a remark below the line that it belongs to. Warnings stay as they
/// are: Log recognises them by their beginning.
inline std::string remark_line(const std::string &remark)
{
  return remark.compare(0, 9, "WARNING: ") == 0 ? remark : "  " + remark;
}
} // namespace contrecoup
