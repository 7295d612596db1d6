// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

/// Subsections and entries as declared in deal.II, for parameter_tree.cc,
/// parameter_names.cc and parameter_search.cc.
namespace contrecoup::declared
{
using Tree = nlohmann::ordered_json;

/// Declared entries in order of declaration, from deal.II's JSON output.
Tree tree_of(const dealii::ParameterHandler &prm);

/// Whether a node is an entry and not a subsection.
bool is_entry(const Tree &node);

/// Whether a subsection is a pattern: its name ends in " *".
bool is_pattern(const std::string &section);

/// Names of the entries in a subsection, or of its subsections.
std::vector<std::string> names(const Tree &node, bool entries);

/// The pattern subsection that matches @p section, or an empty string.
std::string pattern_of(const Tree &node, const std::string &section);

/// Text of a parameter file with these nodes, see parameter_text().
std::string text_of(const Tree &node, bool annotated);

/// The part of a pattern description between two marks.
std::string between(const std::string &text,
                    const std::string &first,
                    const std::string &last);
} // namespace contrecoup::declared
