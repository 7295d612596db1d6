// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/number_or_word.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/body_mass.h>

#include <cmath>

namespace contrecoup
{
namespace
{
  const std::string entry = "Body mass", of_body = "by body";
  constexpr double smallest = 1., largest = 500.; // [kg]
} // namespace


void declare_body_mass(dealii::ParameterHandler &prm,
                       const std::string &sentence)
{
  declare_number_or_word(prm,
                         entry,
                         of_body,
                         smallest,
                         largest,
                         "kg",
                         sentence + " By body: that of a phantom, else " +
                           exact(usual_body_mass) + " kg.");
}


bool is_mass_of_body(const dealii::ParameterHandler &prm)
{
  return !read_number(prm, entry, of_body);
}


double read_body_mass(const dealii::ParameterHandler &prm,
                      const double phantom_mass)
{
  return read_number(prm, entry, of_body)
    .value_or(std::isnan(phantom_mass) ? usual_body_mass : phantom_mass);
}
} // namespace contrecoup
