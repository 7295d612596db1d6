// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_tree.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// Sets entries as "--set" does: "Section/Entry=value", each behind @p prefix.
inline void set_entries(dealii::ParameterHandler &prm,
                        const std::vector<std::string> &entries,
                        const std::string &prefix = "")
{
  std::vector<Assignment> assignments;
  for (const std::string &entry : entries)
    assignments.push_back(parse_override(prefix + entry));
  apply_assignments(assignments, prm);
}


/// What a parameter file with these entries describes.
template <typename Described>
Described described(const std::vector<std::string> &entries,
                    const std::string &prefix = "")
{
  dealii::ParameterHandler prm;
  Described::declare_parameters(prm);
  set_entries(prm, entries, prefix);
  Described result;
  result.parse_parameters(prm);
  return result;
}
} // namespace contrecoup
