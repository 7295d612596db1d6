// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace contrecoup::study
{
/// Entries "Section/Subsection/Entry" with values.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// Relation of a factor's values to mesh refinement.
enum class Refinement
{
  none,
  by_level, ///< the value is a level: mesh width 2^-value
  by_count, ///< the value is a number of cells: mesh width 1 / value
  by_size   ///< the value is the mesh width
};

/// A factor of a study: one entry, or several that change together, with their
/// values. Subsection "Vary *".
struct Factor
{
  std::string name;
  std::string unit; ///< of its numbers; empty: none or unknown
  std::vector<std::string> entries;

  /// One row per value of the factor, with one text per entry. An empty text
  /// leaves the entry as in the parameter file.
  std::vector<std::vector<std::string>> values;
  std::vector<std::string> labels; ///< by row

  Refinement refinement = Refinement::none;

  /// Any number between two bounds, in place of rows.
  bool is_range = false;
  double lower = 0., upper = 0.;
  bool logarithmic = false;

  /// Declares the entries of a subsection "Vary *".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection "Vary @p name".
  /// @throws InputError for rows of wrong length
  void parse_parameters(dealii::ParameterHandler &prm, const std::string &name);

  /// Entries and non-empty texts of a row.
  Settings settings(std::size_t row) const;

  /// @throws InputError for two equal values or labels
  void require_different(const std::string &where) const;

  /// Numerical value of a row: of its label, or else of the beginning of its
  /// first text; NaN if neither is a number.
  double number(std::size_t row) const;

  /// Whether each of the values sets entry number @p entry.
  bool always_sets(std::size_t entry) const;
};

/// All factors of a study in the order of the file.
/// @throws InputError if there is none, or if one overrides all values that an
/// earlier one gives the same entry
std::vector<Factor> parse_factors(dealii::ParameterHandler &prm);

/// Parses settings of the form "Section/Entry=value; ...".
/// @param where origin of the text, for error messages
/// @throws InputError for another form
Settings parse_settings(const std::string &text, const std::string &where);

/// Number at the beginning of @p text, up to a comma or its end; NaN if there
/// is none.
double leading_number(const std::string &text);
} // namespace contrecoup::study
