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

  /// Power of refinement with which a quantity grows in three trials, @p
  /// gap_before and @p gap levels apart: the smaller of both rates, as the
  /// first may be of a mesh that shows nothing yet, but at least 1. Steps grow
  /// faster than by the CFL condition alone where finer cells have faster gas.
  double agreed_power(double first,
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
