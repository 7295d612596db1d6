// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup
{
/**
 * Hands assignments to declared entries, in order, later ones winning.
 *
 * A subsection declared with a name that ends in " *" is a pattern for
 * named items: after `Section s(prm, "Region *")` with its entries, a file
 * may hold `subsection Region ball` and `subsection Region ground`, each
 * with those entries. item_names() lists what the file named.
 *
 * @throws InputError, one line with origin, path and the nearest known name,
 *   for an unknown subsection or entry and for a value out of its range.
 */
void apply_assignments(const std::vector<Assignment> &assignments,
                       dealii::ParameterHandler &prm);

/**
 * The items of a pattern subsection in the order of the file: for
 * "Region" the subsections "Region ball" and "Region ground" give "ball"
 * and "ground". Nested ones are named by their path, "Initial state/Region".
 */
std::vector<std::string> item_names(const dealii::ParameterHandler &prm,
                                    const std::string &kind);

/// Every entry and its value as assignments, in order of declaration, for
/// another handler with the same declarations; named items included.
std::vector<Assignment> assignments_of(const dealii::ParameterHandler &prm);

/// "Section/Subsection/Entry" and value of every entry.
std::map<std::string, std::string>
parameter_values(const dealii::ParameterHandler &prm);

/**
 * The text of a parameter file with every entry; reading it back gives the
 * same values. With @p annotated each entry is preceded by its sentence,
 * allowed values and default, and pattern subsections are shown.
 */
std::string parameter_text(const dealii::ParameterHandler &prm, bool annotated);

/// What a deal.II pattern allows, in plain words: "a number from 0 to 1".
std::string plain_words(const std::string &pattern_description);
} // namespace contrecoup
