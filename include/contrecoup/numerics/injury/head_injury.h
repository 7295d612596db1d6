// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <vector>

namespace contrecoup
{
/// Value of the head injury criterion, and its time interval.
struct HeadInjuryCriterion
{
  double value = 0.; ///< [s], with acceleration in multiples of g
  double begin = 0.; ///< [s]
  double end = 0.;   ///< [s]
};

/**
 * Head injury criterion (HIC): the largest (t2 - t1) a^2.5 over all pairs of
 * listed times at most @p longest apart, where a is the mean of the magnitude
 * of the acceleration of the head's centre in the interval, in multiples of
 * 9.80665 m/s^2 (J. Versace 1971). Common limits for blunt impact are 700 for
 * 15 ms and 1000 for 36 ms (FMVSS 208); there is no agreed limit for blast.
 *
 * @param times increasing [s]
 * @param accelerations at these times, linear in between [m/s^2]
 * @param longest interval [s]
 * @throws InputError for times that do not increase or too few values
 */
HeadInjuryCriterion
head_injury_criterion(const std::vector<double> &times,
                      const std::vector<double> &accelerations,
                      const double longest);

/// The same from velocities [m/s]: the integral of acceleration between two
/// times is the magnitude of the change of velocity.
HeadInjuryCriterion
head_injury_criterion(const std::vector<double> &times,
                      const std::vector<std::array<double, 3>> &velocities,
                      const double longest);

/**
 * Brain injury criterion (BrIC) [-]: root of the sum of squares of the largest
 * angular velocities about the x (forward), y and z axes of the head [rad/s],
 * divided by 66.25, 56.45 and 42.87 rad/s (E. G. Takhounts et al., Stapp Car
 * Crash J. 57 (2013) 243-266). Made for blunt impact.
 */
double brain_injury_criterion(const std::array<double, 3> &angular_velocities);

/**
 * Weighted percentile: the smallest sample value such that the total weight of
 * values up to it is at least the fraction @p part of all weight. For strains,
 * weights are volumes.
 *
 * @param part fraction, 0 to 1 [-]
 * @throws InputError for an empty sample or unequal numbers of values and
 * weights
 */
double weighted_percentile(const std::vector<double> &values,
                           const std::vector<double> &weights,
                           const double part);
} // namespace contrecoup
