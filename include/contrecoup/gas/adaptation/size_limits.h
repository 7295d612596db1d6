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
/// Least and most times that coarse leaves are halved, by place and time, as
/// subsections "Limit <name>" of "Adaptation" say.
class SizeLimits
{
public:
  struct Levels
  {
    unsigned int least = 0;
    unsigned int most = 0;
  };

  /// Declares subsection "Limit *" in the current one.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the limits; the current subsection is "Adaptation".
  /// @throws InputError for places without @p dim coordinates and for
  /// intervals of time or level that are empty.
  void parse_parameters(dealii::ParameterHandler &prm, const unsigned int dim);

  /**
   * Levels that a leaf may have: @p general, narrowed by all limits that
   * hold at @p place and @p time [s]. Where least and most contradict each
   * other, most counts.
   * @param place centre of the leaf [m]
   * @param reach from there to its corners [m]: whatever its size, a leaf
   * that touches a ball is kept as fine as the ball is to be, and as fine as
   * it may be where the limit is for what is outside
   */
  template <int dim>
  Levels levels(const dealii::Point<dim> &place,
                const double time,
                const Levels &general,
                const double reach = 0.) const;

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
    Region region;      ///< at time "from"
    double growth = 0.; ///< of the radius [m/s]
  };

  static void
  check(const Limit &limit, const std::string &where, const unsigned int dim);

  /// Whether a limit holds at a place; balls are larger by @p margin [m].
  template <int dim>
  static bool holds(const Limit &limit,
                    const dealii::Point<dim> &place,
                    const double time,
                    const double margin);

  std::vector<Limit> limits_;
};
} // namespace contrecoup::gas
