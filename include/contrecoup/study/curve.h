// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup::study
{
/// A quantity at a probe over time.
struct Curve
{
  std::vector<double> times;  ///< rising [s]
  std::vector<double> values; ///< one for each time
};

/**
 * The column @p name of a table of a run, probes.csv or history.csv, whose
 * header reads "name [unit],...", against its column "time".
 * @throws InputError naming the columns when there is none of this name
 */
Curve read_curve(const std::string &file, const std::string &name);

/// The largest rise above the first value.
double peak(const Curve &curve);

/// The largest fall below the first value, a number of at most 0.
double lowest(const Curve &curve);

/// The largest value that the integral over time of the rise above the first
/// value reaches: of an overpressure, the impulse of its positive phase.
double impulse(const Curve &curve);

/// The time at which the rise above the first value passes half of its
/// peak first, between two points by linear interpolation [s].
double arrival(const Curve &curve);

/**
 * The moving average of a curve, taken as straight between its points: at each
 * of its times the mean over the interval of length @p width [s] around that
 * time, as far as the curve covers it. Takes away what oscillates faster.
 */
Curve averaged(const Curve &curve, const double width);

/**
 * Integral over time of the difference of two curves over that of the rise of
 * the reference above its first value [-], up to the earlier of the two ends,
 * both curves taken as straight between their points.
 */
double relative_difference(const Curve &curve, const Curve &reference);
} // namespace contrecoup::study
