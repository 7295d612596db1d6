// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * Finds which of the @p known names is meant: the same, or else the only one
 * that differs in case, or in blanks, "-" and "_" between letters or digits,
 * so that "C4" is "c-4". Empty if there is none, or more than one.
 */
std::string resolve_name(const std::string &name,
                         const std::vector<std::string> &known);

/**
 * Replaces names of subsections, entries and selections by those declared, see
 * resolve_name(), and yes, on, 1, no, off, 0 by true and false. Undeclared
 * names stay.
 */
std::vector<Assignment>
with_declared_names(const std::vector<Assignment> &assignments,
                    const dealii::ParameterHandler &prm);

/**
 * Warnings about possible oversights: a parameter file that sets no entry, and
 * entries that one file sets twice. Overrides and including files may set
 * entries again.
 * @param file name of the parameter file, empty for none
 * @param assignments with declared names
 */
std::vector<std::string>
find_oversights(const std::string &file,
                const std::vector<Assignment> &assignments);
} // namespace contrecoup
