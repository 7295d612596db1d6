// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/silence.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/conditions/expression_field.h>
#include <contrecoup/gas/state/state_parameters.h>

#include <boost/math/constants/constants.hpp>

#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <sstream>

namespace contrecoup::gas
{
namespace
{
  const std::array<std::string, 3> velocity_names{
    {"Velocity x", "Velocity y", "Velocity z"}};

  /// Names of the entries, in the order of the components.
  std::vector<std::string> entry_names(const unsigned int dim)
  {
    std::vector<std::string> names{"Density"};
    names.insert(
      names.end(), velocity_names.begin(), velocity_names.begin() + dim);
    names.insert(names.end(), {"Pressure", "Products"});
    return names;
  }


  /// Parses an expression; throws deal.II's exceptions for an invalid one.
  /// @return value of the expression at the origin
  template <int dim>
  double try_expression(const std::string &variables,
                        const std::string &expression,
                        const std::map<std::string, double> &constants)
  {
    const Silence silence;
    dealii::FunctionParser<dim> function(1);
    function.initialize(variables, expression, constants);
    return function.value(dealii::Point<dim>());
  }
} // namespace


template <int dim>
void ExpressionField<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Expression");
  const UsedWith used("Initial state/Kind = expression");
  const std::string note =
    " as a muParser expression of the coordinates x, y, z of the domain and "
    "of pi.";
  declare_string(prm, "Density", "1.225", "[kg/m^3] Mass per volume" + note);
  for (const std::string &name : velocity_names)
    declare_string(prm, name, "0", "[m/s] Velocity component" + note);
  declare_string(prm, "Pressure", "101325", "[Pa] Absolute pressure" + note);
  declare_string(
    prm, "Products", "0", "[-] Mass fraction of explosive products" + note);
}


template <int dim>
ExpressionField<dim>::ExpressionField(ParameterHandler &prm,
                                      const GasMaterial &material)
  : material_(material)
  , function_(dim + 3)
{
  const Section section(prm, "Expression");
  const std::map<std::string, double> constants{
    {"pi", boost::math::double_constants::pi}};
  const std::string variables = std::string("x,y,z").substr(0, 2 * dim - 1);

  // Each expression is first parsed on its own, so that the message can name
  // the entry.
  std::vector<std::string> expressions;
  for (const std::string &name : entry_names(dim))
  {
    expressions.push_back(prm.get(name));
    double value = 0.;
    try
    {
      value = try_expression<dim>(variables, expressions.back(), constants);
    }
    catch (const std::exception &)
    {
      throw InputError("Initial state/Expression: " + name + " = " +
                       quotation(expressions.back()) +
                       " is no muParser expression of " + variables + ",pi");
    }
    if (!std::isfinite(value) &&
        !std::regex_search(expressions.back(), std::regex("\\b[xyz]\\b")))
      throw InputError("Initial state/Expression: " + name + " = " +
                       quotation(expressions.back()) + " is " + brief(value) +
                       " everywhere; a finite number is wanted");
  }
  function_.initialize(variables, expressions, constants);
}


template <int dim>
GasState<dim> ExpressionField<dim>::value(const dealii::Point<dim> &point) const
{
  GasState<dim> state;
  state.density = function_.value(point, 0);
  for (unsigned int d = 0; d < dim; ++d)
    state.velocity[d] = function_.value(point, 1 + d);
  state.pressure = function_.value(point, dim + 1);
  state.products = function_.value(point, dim + 2);

  std::ostringstream where;
  where << "Initial state/Expression, at (" << point << ") m";
  check_state(state, material_, where.str());
  return state;
}


template class ExpressionField<1>;
template class ExpressionField<2>;
template class ExpressionField<3>;
} // namespace contrecoup::gas
