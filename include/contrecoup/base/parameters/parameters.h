// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <limits>
#include <string>
#include <vector>

namespace contrecoup
{
using dealii::ParameterHandler;

/// Largest finite double: "no bound" in the declarations below.
inline constexpr double unbounded = std::numeric_limits<double>::max();

/// Enters a subsection for its lifetime; leaves it also on exceptions.
class Section
{
public:
  Section(ParameterHandler &prm, const std::string &name);
  ~Section();
  Section(const Section &) = delete;
  Section &operator=(const Section &) = delete;

private:
  ParameterHandler &prm_;
};

/// @name Declaration of entries. Every entry has a default as text (so that no
/// digit is lost), a range, an SI unit ("-" for dimensionless numbers) and one
/// honest sentence. Names contain no "/" and no "=".
/// @{

/// Declares a finite number in [@p smallest, @p largest].
void declare_double(ParameterHandler &prm,
                    const std::string &name,
                    const std::string &default_value,
                    double smallest,
                    double largest,
                    const std::string &unit,
                    const std::string &sentence);

/// Declares an integer in [@p smallest, @p largest].
void declare_integer(ParameterHandler &prm,
                     const std::string &name,
                     const std::string &default_value,
                     int smallest,
                     int largest,
                     const std::string &sentence);

/// Declares an entry that is "true" or "false".
void declare_bool(ParameterHandler &prm,
                  const std::string &name,
                  const std::string &default_value,
                  const std::string &sentence);

/// Declares one of several @p choices, none of which contains a "|".
void declare_selection(ParameterHandler &prm,
                       const std::string &name,
                       const std::string &default_value,
                       const std::vector<std::string> &choices,
                       const std::string &sentence);

/// Declares a text, e.g. an expression.
void declare_string(ParameterHandler &prm,
                    const std::string &name,
                    const std::string &default_value,
                    const std::string &sentence);

/// Declares an input file. A relative name is resolved next to the parameter
/// file that contains it first, then in the working directory; the run stores
/// the absolute name. Empty: none.
void declare_file(ParameterHandler &prm,
                  const std::string &name,
                  const std::string &default_value,
                  const std::string &sentence);

/// Declares a list of @p least to @p most finite numbers in [@p smallest, @p
/// largest], separated by commas.
void declare_list(ParameterHandler &prm,
                  const std::string &name,
                  const std::string &default_value,
                  unsigned int least,
                  unsigned int most,
                  double smallest,
                  double largest,
                  const std::string &unit,
                  const std::string &sentence);

/// Declares points "x,y,z; x,y,z; ...", possibly none, with one to three
/// coordinates.
void declare_points(ParameterHandler &prm,
                    const std::string &name,
                    const std::string &default_value,
                    const std::string &unit,
                    const std::string &sentence);
/// The pattern of declare_points().
dealii::Patterns::List points_pattern();
/// @}

/// @name Reading entries of the current subsection, after validation against
/// their declared range. Booleans and texts: prm.get_bool(), prm.get().
/// @{
double read_double(const ParameterHandler &prm, const std::string &name);
int read_integer(const ParameterHandler &prm, const std::string &name);
unsigned int read_unsigned(const ParameterHandler &prm,
                           const std::string &name);

/// The numbers of a declare_list() entry.
std::vector<double> read_list(const ParameterHandler &prm,
                              const std::string &name);

/// The first @p dim numbers of a declare_list() entry as a point.
/// @throws InputError for another number of values
template <int dim>
dealii::Point<dim> read_point(const ParameterHandler &prm,
                              const std::string &name);

/// The points of a declare_points() entry.
/// @throws InputError unless all have @p dim coordinates
template <int dim>
std::vector<dealii::Point<dim>> read_points(const ParameterHandler &prm,
                                            const std::string &name);
/// @}
} // namespace contrecoup
