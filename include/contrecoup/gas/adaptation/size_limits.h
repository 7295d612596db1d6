// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/region.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/// Smallest and largest refinement level as a function of position and time,
/// read from subsections "Limit <name>" of "Adaptation".
class SizeLimits
{
public:
  struct Levels
  {
    unsigned int min_level = 0;
    unsigned int max_level = 0;
  };

  /// Declares subsection "Limit *" in the current one.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the limits; the current subsection is "Adaptation".
  /// @throws InputError for points without @p dim coordinates and for empty
  /// intervals of time or level.
  void parse_parameters(dealii::ParameterHandler &prm, const unsigned int dim);

  /**
   * Refinement levels allowed for a leaf: @p general, restricted by all limits
   * that hold at @p place and @p time [s]. Where the restrictions conflict, the
   * largest level wins.
   *
   * @param place centre of the leaf [m]
   * @param corner_distance distance from the centre to the corners of the leaf
   * [m]: a leaf of any size that intersects a ball gets the ball's smallest
   * level and is exempt from a largest level that holds outside of the ball
   */
  template <int dim>
  Levels levels(const dealii::Point<dim> &place,
                const double time,
                const Levels &general,
                const double corner_distance = 0.) const;

  bool empty() const
  {
    return limits_.empty();
  }

private:
  struct Limit
  {
    Levels levels;
    double from = 0.;   ///< [s]
    double until = 0.;  ///< [s]
    Region region;      ///< region at time "from"
    double growth = 0.; ///< growth rate of the radius [m/s]
  };

  static void
  check(const Limit &limit, const std::string &where, const unsigned int dim);

  /// Whether a limit holds at a position; balls are enlarged by @p margin [m].
  template <int dim>
  static bool holds(const Limit &limit,
                    const dealii::Point<dim> &place,
                    const double time,
                    const double margin);

  std::vector<Limit> limits_;
};
} // namespace contrecoup::gas
