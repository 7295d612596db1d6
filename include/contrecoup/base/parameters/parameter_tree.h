// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup
{
/**
 * Applies assignments to declared entries, in order; later ones win.
 *
 * A subsection declared with a name that ends in " *" is a pattern for named
 * items: after `Section s(prm, "Region *")` with its entries, a file may
 * contain `subsection Region ball` and `subsection Region ground`, each with
 * these entries. item_names() lists the items of the file.
 *
 * @throws InputError, one line with origin, path and the nearest known name,
 * for an unknown subsection or entry and for a value out of range
 */
void apply_assignments(const std::vector<Assignment> &assignments,
                       dealii::ParameterHandler &prm);

/**
 * Items of a pattern subsection in the order of the file: for "Region", the
 * subsections "Region ball" and "Region ground" give "ball" and "ground".
 * Nested patterns are named by their path, "Initial state/Region".
 */
std::vector<std::string> item_names(const dealii::ParameterHandler &prm,
                                    const std::string &kind);

/// All entries and values as assignments, in order of declaration and
/// including named items, for another handler with the same declarations.
std::vector<Assignment> assignments_of(const dealii::ParameterHandler &prm);

/// All entries, "Section/Subsection/Entry", with their values.
std::map<std::string, std::string>
parameter_values(const dealii::ParameterHandler &prm);

/**
 * Text of a parameter file with all entries; reading it restores the values.
 * If @p annotated, help text, allowed values and default precede each entry,
 * and pattern subsections are included.
 */
std::string parameter_text(const dealii::ParameterHandler &prm, bool annotated);
} // namespace contrecoup
