// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
/// A remark as a line below another one, indented, unless it is a warning,
/// which Log knows by its beginning.
inline std::string remark_line(const std::string &remark)
{
  return remark.compare(0, 9, "WARNING: ") == 0 ? remark : "  " + remark;
}
} // namespace contrecoup
