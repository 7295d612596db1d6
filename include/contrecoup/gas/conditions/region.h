// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/// A part of space of simple shape in which the size of leaves is set.
class Region
{
public:
  /// Declares shape, corners, centres and radius in the current subsection.
  /// @param rule what the sentence about the shapes says of leaves there
  static void declare_parameters(dealii::ParameterHandler &prm,
                                 const std::string &rule);

  void parse_parameters(dealii::ParameterHandler &prm);

  /// @param where name of the subsection
  /// @throws InputError for places without @p dim coordinates.
  void check(const std::string &where, const unsigned int dim) const;

  bool is_ball() const
  {
    return shape_ == "ball";
  }

  /// Whether a place is in the region, the radius larger by @p margin [m].
  template <int dim>
  bool contains(const dealii::Point<dim> &place, const double margin) const;

  /// Whether the box between two corners has points in the region [m]; what
  /// several balls cover together counts as outside of them.
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
