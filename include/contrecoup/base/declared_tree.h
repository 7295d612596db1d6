// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

/// Subsections and entries as deal.II tells them, for parameter_tree.cc and
/// parameter_names.cc.
namespace contrecoup::declared
{
using Tree = nlohmann::ordered_json;

/// The declared entries as deal.II prints them, in order of declaration.
Tree tree_of(const dealii::ParameterHandler &prm);

/// Whether it is an entry, not a subsection.
bool is_entry(const Tree &node);

/// Whether the name of a subsection ends in " *".
bool is_pattern(const std::string &section);

/// Names of the entries in a subsection, or of the subsections.
std::vector<std::string> names(const Tree &node, bool entries);

/// The pattern subsection that allows @p section, or an empty string.
std::string pattern_of(const Tree &node, const std::string &section);

/// What stands between two marks of a pattern description.
std::string between(const std::string &text,
                    const std::string &first,
                    const std::string &last);
} // namespace contrecoup::declared
