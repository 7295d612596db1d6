// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * Knowledge of the literature on measures of injury. All of it is in
 * injury_criteria.json next to the source, each figure with its origin;
 * the report reads the same file.
 */

namespace contrecoup
{
/// Probability of an event by a measure of injury.
struct InjuryCurve
{
  std::string name;
  std::string event;  ///< in words
  std::string source; ///< publication
  std::string valid;  ///< range of validity

  /**
   * The probability [-] at @p value, 0 unless that is positive. "lognormal":
   * normal distribution of ln x with a mean and a deviation; "probit": of
   * intercept + slope ln x about 5; "weibull": 1 - exp(-(x / scale)^exponent).
   */
  double probability(const double value) const;
};

/// The curve of that name, see injury_criteria.json.
/// @throws InputError for an unknown name
const InjuryCurve &injury_curve(const std::string &name);

/// A number of a curve in injury_criteria.json.
double injury_curve_constant(const std::string &curve, const std::string &name);

/// Thresholds of a measure of injury.
struct InjuryCriterion
{
  /// Limits in the unit of the measure (SI), of increasing severity, and what
  /// it means to exceed them. For levels that overlap, a limit is where one
  /// begins or ends, and its meaning names all that apply from there on.
  std::vector<std::pair<double, std::string>> thresholds;
  std::string source;              ///< publication
  std::string limits;              ///< of validity
  std::string limits_of_impact;    ///< the same without a blast
  std::vector<std::string> curves; ///< names of probabilities by this measure
  std::string unit;                ///< of the measure; "-" for none
  /// Measured object: head, chest, loads at gauges, people in the air, or a
  /// check of the numerics.
  std::string of;
  double largest; ///< of the measure: 1 for fractions, else infinity

  /// The worst threshold that @p value exceeds in words; "none" below all.
  /// Negative limits are exceeded by lower values.
  std::string meaning(const double value) const;

  /// Thresholds and their source, as a line of text.
  std::string in_words() const;
};

/// Criterion of the measure of that name, see injury_criteria.json.
/// @throws InputError for an unknown name
const InjuryCriterion &injury_criterion(const std::string &name);

/// Names of all measures of these kinds, see InjuryCriterion::of.
std::vector<std::string>
injury_measures_of(const std::vector<std::string> &kinds);
} // namespace contrecoup
