// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup::study
{
/// A time series of a quantity.
struct Curve
{
  std::vector<double> times;  ///< increasing [s]
  std::vector<double> values; ///< one for each time
};

/**
 * Reads the column @p name of probes.csv or history.csv, whose header is "name
 * [unit],...", as a function of the column "time".
 * @throws InputError, listing the columns, for an unknown name
 */
Curve read_curve(const std::string &file, const std::string &name);

/// Largest rise above the first value.
double peak(const Curve &curve);

/// Largest fall below the first value, not positive.
double lowest(const Curve &curve);

/// Maximum over time of the integral of the rise above the first value: for an
/// overpressure, the positive-phase impulse.
double impulse(const Curve &curve);

/// Time at which the rise above the first value first exceeds half of its
/// peak, with linear interpolation [s].
double arrival(const Curve &curve);

/**
 * Moving average of a piecewise linear curve: at each of its times the mean
 * over the interval of length @p width [s] around that time, clipped to the
 * curve's ends. Removes faster oscillations.
 */
Curve averaged(const Curve &curve, const double width);

/**
 * Integral over time of the absolute difference of two curves, over that of
 * the reference's rise above its first value [-]; up to the earlier end, with
 * linear interpolation.
 */
double relative_difference(const Curve &curve, const Curve &reference);
} // namespace contrecoup::study
