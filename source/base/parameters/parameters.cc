// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>

#include <cmath>
#include <cstdlib>

namespace contrecoup
{
namespace Patterns = dealii::Patterns;

namespace
{

  std::string documentation(const std::string &unit,
                            const std::string &sentence)
  {
    return UsedWith::annotate(unit.empty() ? sentence
                                           : "[" + unit + "] " + sentence);
  }

  double to_double(const std::string &text, const std::string &name)
  {
    char *end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value))
      throw InputError("entry \"" + name + "\": \"" + text +
                       "\" is not a finite number");
    return value;
  }

  template <int dim>
  dealii::Point<dim> to_point(const std::string &text, const std::string &name)
  {
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() != dim)
      throw InputError("entry \"" + name + "\": the point \"" + text +
                       "\" has " + std::to_string(parts.size()) +
                       " coordinates, this scene needs " + std::to_string(dim));
    dealii::Point<dim> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = to_double(parts[d], name);
    return point;
  }
} // namespace

Section::Section(ParameterHandler &prm, const std::string &name)
  : prm_(prm)
{
  prm_.enter_subsection(name);
}

Section::~Section()
{
  prm_.leave_subsection();
}

void declare_double(ParameterHandler &prm,
                    const std::string &name,
                    const std::string &default_value,
                    const double smallest,
                    const double largest,
                    const std::string &unit,
                    const std::string &sentence)
{
  prm.declare_entry(name,
                    default_value,
                    Patterns::Double(smallest, largest),
                    documentation(unit, sentence));
}

void declare_integer(ParameterHandler &prm,
                     const std::string &name,
                     const std::string &default_value,
                     const int smallest,
                     const int largest,
                     const std::string &sentence)
{
  prm.declare_entry(name,
                    default_value,
                    Patterns::Integer(smallest, largest),
                    UsedWith::annotate(sentence));
}

void declare_bool(ParameterHandler &prm,
                  const std::string &name,
                  const std::string &default_value,
                  const std::string &sentence)
{
  prm.declare_entry(
    name, default_value, Patterns::Bool(), UsedWith::annotate(sentence));
}

void declare_selection(ParameterHandler &prm,
                       const std::string &name,
                       const std::string &default_value,
                       const std::vector<std::string> &choices,
                       const std::string &sentence)
{
  prm.declare_entry(name,
                    default_value,
                    Patterns::Selection(join(choices, "|")),
                    UsedWith::annotate(sentence));
}

void declare_string(ParameterHandler &prm,
                    const std::string &name,
                    const std::string &default_value,
                    const std::string &sentence)
{
  prm.declare_entry(
    name, default_value, Patterns::Anything(), UsedWith::annotate(sentence));
}

void declare_file(ParameterHandler &prm,
                  const std::string &name,
                  const std::string &default_value,
                  const std::string &sentence)
{
  prm.declare_entry(
    name, default_value, Patterns::FileName(), UsedWith::annotate(sentence));
}

void declare_list(ParameterHandler &prm,
                  const std::string &name,
                  const std::string &default_value,
                  const unsigned int least,
                  const unsigned int most,
                  const double smallest,
                  const double largest,
                  const std::string &unit,
                  const std::string &sentence)
{
  prm.declare_entry(
    name,
    default_value,
    Patterns::List(Patterns::Double(smallest, largest), least, most),
    documentation(unit, sentence));
}

void declare_points(ParameterHandler &prm,
                    const std::string &name,
                    const std::string &default_value,
                    const std::string &unit,
                    const std::string &sentence)
{
  prm.declare_entry(
    name, default_value, points_pattern(), documentation(unit, sentence));
}

Patterns::List points_pattern()
{
  const Patterns::Double coordinate(-bounds::length, bounds::length);
  return Patterns::List(
    Patterns::List(coordinate, 1, 3), 0, Patterns::List::max_int_value, ";");
}

double read_double(const ParameterHandler &prm, const std::string &name)
{
  return to_double(trim(prm.get(name)), name);
}

int read_integer(const ParameterHandler &prm, const std::string &name)
{
  return static_cast<int>(prm.get_integer(name));
}

unsigned int read_unsigned(const ParameterHandler &prm, const std::string &name)
{
  const long int value = prm.get_integer(name);
  if (value < 0)
    throw InputError("entry \"" + name + "\": " + std::to_string(value) +
                     " is negative");
  return static_cast<unsigned int>(value);
}

std::vector<double> read_list(const ParameterHandler &prm,
                              const std::string &name)
{
  std::vector<double> values;
  for (const std::string &part : split(prm.get(name), ','))
    values.push_back(to_double(part, name));
  return values;
}

template <int dim>
dealii::Point<dim> read_point(const ParameterHandler &prm,
                              const std::string &name)
{
  return to_point<dim>(prm.get(name), name);
}

template <int dim>
std::vector<dealii::Point<dim>> read_points(const ParameterHandler &prm,
                                            const std::string &name)
{
  std::vector<dealii::Point<dim>> points;
  for (const std::string &part : split(prm.get(name), ';'))
    points.push_back(to_point<dim>(part, name));
  return points;
}

#define INSTANTIATE(dim)                                                \
  template dealii::Point<dim> read_point<dim>(const ParameterHandler &, \
                                              const std::string &);     \
  template std::vector<dealii::Point<dim>> read_points<dim>(            \
    const ParameterHandler &, const std::string &);
INSTANTIATE(1)
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE
} // namespace contrecoup
