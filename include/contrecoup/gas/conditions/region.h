// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/// Region of simple shape in which a refinement level is prescribed.
class Region
{
public:
  /// Declares shape, corners, centres and radius in the current subsection.
  /// @param rule help text of entry "Shape"
  static void declare_parameters(dealii::ParameterHandler &prm,
                                 const std::string &rule);

  void parse_parameters(dealii::ParameterHandler &prm);

  /// @param where name of the subsection, for messages
  /// @throws InputError for points without @p dim coordinates.
  void check(const std::string &where, const unsigned int dim) const;

  bool is_ball() const
  {
    return shape_ == "ball";
  }

  /// Whether @p place [m] is in the region with its radius increased by @p
  /// margin [m].
  template <int dim>
  bool contains(const dealii::Point<dim> &place, const double margin) const;

  /// Whether the box between two corners [m] intersects the region. For
  /// "outside of ball", a box that only the union of several balls covers
  /// counts as outside.
  template <int dim>
  bool meets(const dealii::Point<dim> &lower,
             const dealii::Point<dim> &upper) const;

private:
  bool has_ball() const
  {
    return shape_ == "ball" || shape_ == "outside of ball";
  }

  std::string shape_ = "everywhere";
  std::vector<std::vector<double>> centers_; ///< [m]
  double radius_ = 0.;                       ///< [m]
  std::vector<double> lower_;                ///< [m]
  std::vector<double> upper_;                ///< [m]
};
} // namespace contrecoup::gas
