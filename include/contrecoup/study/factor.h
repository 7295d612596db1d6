// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace contrecoup::study
{
/// Entries, as "Section/Subsection/Entry", and the values they are given.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// How the values of a factor refine the mesh.
enum class Refinement
{
  none,
  by_level, ///< each value is a level: the mesh width is 2^-value
  by_count, ///< each value counts cells: the mesh width is 1 / value
  by_size   ///< each value is the mesh width
};

/**
 * What a study varies: one entry, or several that change together, with the
 * values that they take. One subsection "Vary *" of the study's file.
 */
struct Factor
{
  std::string name;
  std::vector<std::string> entries;

  /// One row for each value of the factor, one text for each entry in it. An
  /// empty text leaves the entry as the base file has it.
  std::vector<std::vector<std::string>> values;
  std::vector<std::string> labels; ///< one for each row

  Refinement refinement = Refinement::none;

  /// Instead of rows, any number between two bounds.
  bool is_range = false;
  double lower = 0., upper = 0.;
  bool logarithmic = false;

  /// Declares the entries of a subsection "Vary *".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection, which has the name
  /// "Vary @p name". @throws InputError for rows of the wrong length.
  void parse_parameters(dealii::ParameterHandler &prm, const std::string &name);

  /// The entries and texts of a row, empty ones left out.
  Settings settings(std::size_t row) const;

  /// The number that a row stands for: its label, or else what its first text
  /// begins with; not a number if neither is one.
  double number(std::size_t row) const;
};

/// All factors of a study in the order of its file.
/// @throws InputError when there is none, or two have the same first entry.
std::vector<Factor> parse_factors(dealii::ParameterHandler &prm);

/// Settings as the user writes them: "Section/Entry=value; ...".
/// @throws InputError when @p text is not of this form; @p where says where
///   it stands.
Settings parse_settings(const std::string &text, const std::string &where);

/// The number that @p text begins with, up to a comma or its end; not a
/// number if it does not begin with one.
double leading_number(const std::string &text);
} // namespace contrecoup::study
