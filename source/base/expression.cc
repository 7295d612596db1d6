// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/expression.h>
#include <contrecoup/base/silence.h>
#include <contrecoup/base/text.h>

#include <boost/math/constants/constants.hpp>

#include <regex>

namespace contrecoup
{
Expression::Expression(const std::string &entry, const std::string &text)
  : text_(trim(text))
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
    throw InputError(entry + " = \"" + text_ +
                     "\" is no muParser expression of x, y, z, t and pi");
  }
}


double Expression::value(const dealii::Point<3> &point, const double time) const
{
  function_->set_time(time);
  return function_->value(point);
}
} // namespace contrecoup
