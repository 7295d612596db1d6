// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <vector>

namespace contrecoup
{
/// A head injury criterion and the time that it is taken from.
struct HeadInjuryCriterion
{
  double value = 0.; ///< [s], with accelerations in parts of gravity
  double begin = 0.; ///< [s]
  double end = 0.;   ///< [s]
};

/**
 * The head injury criterion: the largest (t2 - t1) a^2.5 over all pairs of
 * times of the list no more than @p longest apart, with a the mean over these
 * of the magnitude of the acceleration of the head's centre, in parts of
 * 9.80665 m/s^2 (J. Versace 1971). 15 ms with a limit of 700 and 36 ms with
 * 1000 are customary for blunt impact (FMVSS 208); for blast there is no
 * limit that is agreed on.
 *
 * @param times increasing [s]
 * @param accelerations at these times, straight between them [m/s^2]
 * @param longest [s]
 * @throws InputError for times that do not increase or too few values
 */
HeadInjuryCriterion
head_injury_criterion(const std::vector<double> &times,
                      const std::vector<double> &accelerations,
                      const double longest);

/**
 * The same of velocities [m/s] at these times: the speed gained between two of
 * them is the magnitude of the velocity's change.
 */
HeadInjuryCriterion
head_injury_criterion(const std::vector<double> &times,
                      const std::vector<std::array<double, 3>> &velocities,
                      const double longest);

/**
 * The brain injury criterion [-]: root of the sum of squares of the largest
 * angular velocities about the x (forward), y and z axes of the head [rad/s]
 * over 66.25, 56.45 and 42.87 rad/s (E. G. Takhounts et al., Stapp Car Crash J.
 * 57 (2013) 243-266). Made for blunt impact.
 */
double brain_injury_criterion(const std::array<double, 3> &angular_velocities);

/**
 * The value below which a part of a weighted sample lies: of percentile strains
 * with volumes as weights. The smallest value whose weight together with all
 * smaller ones' is at least that part of the whole.
 *
 * @param part from 0 to 1 [-]
 * @throws InputError for an empty sample or other than one weight each
 */
double weighted_percentile(const std::vector<double> &values,
                           const std::vector<double> &weights,
                           const double part);

/// The part of the weights whose values exceed @p limit [-]: with largest
/// principal strains and volumes the cumulative strain damage measure.
/// @throws InputError as weighted_percentile()
double weighted_part_above(const std::vector<double> &values,
                           const std::vector<double> &weights,
                           const double limit);
} // namespace contrecoup
