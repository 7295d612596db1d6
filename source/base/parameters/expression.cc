// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/silence.h>
#include <contrecoup/base/system/text.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <regex>

namespace contrecoup
{
Expression::Expression(const std::string &entry, const std::string &text)
  : entry_(entry)
  , text_(trim(text))
  , depends_on_place_(std::regex_search(text, std::regex("\\b[xyz]\\b")))
  , function_(std::make_shared<dealii::FunctionParser<3>>(1))
{
  try
  {
    const Silence silence;
    function_->initialize(
      "x,y,z,t", text_, {{"pi", boost::math::double_constants::pi}}, true);
    function_->value(dealii::Point<3>());
  }
  catch (const std::exception &)
  {
    throw InputError(entry + " = " + quotation(text_) +
                     " is no muParser expression of x, y, z, t and pi");
  }
  if (!std::regex_search(text_, std::regex("\\b[xyzt]\\b")))
    value(dealii::Point<3>());
}


double Expression::value(const dealii::Point<3> &point, const double time) const
{
  function_->set_time(time);
  const double result = function_->value(point);
  if (!std::isfinite(result))
    throw InputError(entry_ + " = " + quotation(text_) + " is " +
                     brief(result) + " at (" + coordinates(point) + ") m and " +
                     brief(time) + " s; a finite number is wanted");
  return result;
}
} // namespace contrecoup
