// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace contrecoup
{
enum class ParameterForm
{
  text, ///< annotated parameter file, see parameter_text()
  /// deal.II's JSON (value, default_value, documentation, pattern,
  /// pattern_description of each entry), with "allowed" in words and, where
  /// they are known, "unit", "range" [least, most] (null without bound) and
  /// "choices"
  json
};

/**
 * One section or entry, by name or path such as "Body/Surface"; else all
 * entries whose name or help text has the words of @p what; all if it is empty.
 * Letter case does not matter.
 * @throws InputError when nothing is found, with the nearest name
 */
std::string find_parameters(const dealii::ParameterHandler &prm,
                            const std::string &what,
                            ParameterForm form);
} // namespace contrecoup
