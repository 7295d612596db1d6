// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/numerics/injury/injury_criteria.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * Thresholds of the user's own in place of the published ones of measures of
 * injury: subsections "Measure NAME". The report reads the same entries.
 */
class OwnThresholds
{
public:
  /// Declares "Measure *" in the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /**
   * Reads all "Measure NAME" of a section.
   * @param section path of the section that holds them: "Injury"
   * @throws InputError for an unknown measure, and for thresholds that are no
   * numbers with a meaning, out of range or not of increasing severity
   */
  void parse_parameters(dealii::ParameterHandler &prm,
                        const std::string &section);

  /// @throws InputError for a measure that is not among those that are taken;
  /// @p reason says why there are no others, may be empty
  void require(const std::vector<std::string> &taken,
               const std::string &reason) const;

  /// Names of the measures, in the order of the file.
  std::vector<std::string> measures() const;

  /// injury_criterion() with the user's thresholds, where there are any.
  InjuryCriterion criterion(const std::string &measure) const;

  /// Path of the subsection of a measure.
  std::string path(const std::string &measure) const;

  /// Entries of a measure with their values, without empty ones.
  std::vector<std::pair<std::string, std::string>>
  entries(const std::string &measure) const;

  /// Items for the plan of a run.
  std::vector<Assumption> assumptions() const;

private:
  struct Measure
  {
    std::string name;
    std::string path;
    std::string text; ///< of the thresholds
    std::string source;
    InjuryCriterion criterion;
  };

  const Measure *find(const std::string &name) const;

  std::vector<Measure> list_;
};
} // namespace contrecoup
