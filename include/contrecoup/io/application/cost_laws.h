// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
namespace io
{
  /**
   * Extrapolates a quantity a 2^(low level) + b 2^(high level), a, b >= 0, by
   * @p levels beyond its value @p last. It was @p before at @p gap levels
   * earlier; 0: unknown, then the mean exponent applies. Quantities that grow
   * more slowly than a 2^(low level) keep their own rate, decreasing ones stay
   * constant.
   */
  double extrapolate(double before,
                     double last,
                     unsigned int levels,
                     double low,
                     double high,
                     unsigned int gap = 1);

  /**
   * Extrapolates the number of cells of an adaptive mesh by @p levels beyond @p
   * last; it was @p before at @p gap levels earlier, 0: unknown. Cells in
   * layers of some leaves along fronts and surfaces grow by more than
   * 2^(dimension - 1) a level and less than 2^dimension, by 2^(3/4 dimension)
   * within a fifth in runs of 2-D and 3-D blasts; the rest stays as it is.
   */
  double extrapolate_cells(double before,
                           double last,
                           unsigned int levels,
                           unsigned int dimension,
                           unsigned int gap);

  /**
   * Extrapolates a quantity a + b 2^-level by @p levels beyond its value @p
   * last. It was @p before at @p gap levels earlier.
   */
  double extrapolate_to_limit(double before,
                              double last,
                              unsigned int levels,
                              unsigned int gap = 1);

  /// Powers of refinement between which a quantity grows, see extrapolate().
  struct Powers
  {
    double low = 0., high = 1.;
  };

  /**
   * Powers with which steps grow after three trials, @p gap_before and @p gap
   * levels apart. By the CFL condition the largest is 1. Where both pairs of
   * trials have grown faster, a shock has met at the centre of the charge: the
   * sound speed there grows like that of the converging shock, like r^-0.39 in
   * air (Guderley, 1942), with r down to the cell size, and stays until the
   * end. Steps up to that moment grow with 1, those after it with 1.4, or with
   * the rate of both pairs if that is larger still.
   */
  Powers powers_of_steps(double first,
                         double middle,
                         double last,
                         unsigned int gap_before,
                         unsigned int gap);

  /// A quantity of a mesh of @p cells, linear in the cells, from those of two
  /// trials; but it grows at least like the given power of the cells, because
  /// noise in short trials hides the part that grows.
  double grow_with_cells(double cells_before,
                         double before,
                         double cells_last,
                         double last,
                         double cells,
                         double least_power);
} // namespace io
} // namespace contrecoup
