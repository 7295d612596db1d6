// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
/// The sentence of an entry that selects by place, name, label or condition,
/// see Selections. `--print-parameters "selects nothing"` finds these entries,
/// and tests/applications/selections.py asks each for its refusal.
inline std::string selecting(const std::string &sentence)
{
  return sentence + " Refused if it selects nothing.";
}
} // namespace contrecoup
