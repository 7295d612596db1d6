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

/// Largest finite double: "no bound" for the declarations below.
inline constexpr double unbounded = std::numeric_limits<double>::max();

/**
 * Enters a subsection for as long as the object lives, also when an
 * exception leaves the scope.
 */
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

/// @name Declaring entries. Every entry has its default as a string (so
/// that no digit is lost), its range, its SI unit ("-" for a pure number)
/// and one honest sentence. Names hold no "/" and no "=".
/// @{

/// A finite number in [@p smallest, @p largest].
void declare_double(ParameterHandler &prm,
                    const std::string &name,
                    const std::string &default_value,
                    double smallest,
                    double largest,
                    const std::string &unit,
                    const std::string &sentence);

/// A whole number in [@p smallest, @p largest].
void declare_integer(ParameterHandler &prm,
                     const std::string &name,
                     const std::string &default_value,
                     int smallest,
                     int largest,
                     const std::string &sentence);

/// "true" or "false".
void declare_bool(ParameterHandler &prm,
                  const std::string &name,
                  const std::string &default_value,
                  const std::string &sentence);

/// One of the @p choices, none of which holds a "|".
void declare_selection(ParameterHandler &prm,
                       const std::string &name,
                       const std::string &default_value,
                       const std::vector<std::string> &choices,
                       const std::string &sentence);

/// Any text, e.g. a file name or an expression.
void declare_string(ParameterHandler &prm,
                    const std::string &name,
                    const std::string &default_value,
                    const std::string &sentence);

/// A file that is read. A relative name is looked for beside the parameter
/// file that gives it first, then in the working directory; the run keeps the
/// absolute one. Empty: none.
void declare_file(ParameterHandler &prm,
                  const std::string &name,
                  const std::string &default_value,
                  const std::string &sentence);

/// @p least to @p most finite numbers in [@p smallest, @p largest],
/// separated by commas.
void declare_list(ParameterHandler &prm,
                  const std::string &name,
                  const std::string &default_value,
                  unsigned int least,
                  unsigned int most,
                  double smallest,
                  double largest,
                  const std::string &unit,
                  const std::string &sentence);

/// Points "x,y,z; x,y,z; ...", possibly none, of one to three coordinates.
void declare_points(ParameterHandler &prm,
                    const std::string &name,
                    const std::string &default_value,
                    const std::string &unit,
                    const std::string &sentence);
/// What declare_points() allows.
dealii::Patterns::List points_pattern();
/// @}

/// @name Reading entries of the current subsection, after they passed
/// their declared range. Booleans and strings: prm.get_bool(), prm.get().
/// @{
double read_double(const ParameterHandler &prm, const std::string &name);
int read_integer(const ParameterHandler &prm, const std::string &name);
unsigned int read_unsigned(const ParameterHandler &prm,
                           const std::string &name);

/// The numbers of a declare_list() entry.
std::vector<double> read_list(const ParameterHandler &prm,
                              const std::string &name);

/// The first @p dim numbers of a declare_list() entry as a point.
/// @throws InputError when there are fewer or more.
template <int dim>
dealii::Point<dim> read_point(const ParameterHandler &prm,
                              const std::string &name);

/// The points of a declare_points() entry.
/// @throws InputError when one has not exactly @p dim coordinates.
template <int dim>
std::vector<dealii::Point<dim>> read_points(const ParameterHandler &prm,
                                            const std::string &name);
/// @}
} // namespace contrecoup
