// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>

#include <memory>
#include <string>

namespace contrecoup
{
/// A muParser expression of x, y, z [m], t [s] and pi.
class Expression
{
public:
  /// @param entry path of the parameter entry, for error messages
  /// @throws InputError for invalid syntax, and for a constant expression that
  /// is not finite
  Expression(const std::string &entry, const std::string &text);

  /// Evaluates the expression. @throws InputError when the value is not finite
  double value(const dealii::Point<3> &point, double time = 0.) const;

  /// Whether the text is "0"; "0.0" is not.
  bool is_zero() const
  {
    return text_ == "0";
  }

  /// Whether the expression contains x, y or z.
  bool depends_on_place() const
  {
    return depends_on_place_;
  }

  const std::string &text() const
  {
    return text_;
  }

private:
  std::string entry_;
  std::string text_;
  bool depends_on_place_;
  std::shared_ptr<dealii::FunctionParser<3>> function_;
};
} // namespace contrecoup
