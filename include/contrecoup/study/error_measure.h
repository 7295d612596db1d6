// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/curve.h>
#include <contrecoup/study/factor.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace contrecoup::study
{
/**
 * How wrong a run is: by a number that it states itself, by the difference of
 * a quantity from a known value or from a reference run, or from what the
 * quantity tends to as the mesh is refined.
 */
class ErrorMeasure
{
public:
  /// Declares subsection "Error".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for entries that do not go together.
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Whether errors are measured at all.
  bool is_active() const;

  /// Whether errors follow from several runs by extrapolation.
  bool is_self_convergence() const;

  /// The reference run's entries, if the study is to make one.
  const std::optional<Settings> &reference_settings() const;

  /// The output folder of the reference run; empty without one.
  void set_reference_folder(const std::string &folder);
  const std::string &reference_folder() const
  {
    return reference_folder_;
  }

  /**
   * The error of a run; for self-convergence its quantity.
   * @param folder output folder of the run
   * @param summary content of its summary.json
   * @return NaN when the run has a number that is not finite there
   * @throws InputError when the run has no such quantity
   */
  double value(const std::string &folder, const nlohmann::json &summary) const;

  /// What the error is of, for tables and axes.
  std::string title() const;

  /// A short name for the error in summary.json, such as "density_L1".
  std::string short_name() const;

  /// The error that is good enough; 0: none was named.
  double wanted() const;

private:
  double quantity(const std::string &folder,
                  const nlohmann::json &summary) const;
  double difference(const std::string &folder) const;
  bool compares_files() const;

  /// What is taken from a curve, the last word of the quantity; empty of what
  /// is none.
  std::string of_curve() const;

  /// Of the run in this folder, from probes.csv or history.csv, averaged over
  /// the averaging time.
  Curve curve(const std::string &folder) const;

  std::string kind_;
  std::string quantity_;
  std::string name_;
  double known_ = 0.;
  double averaging_time_ = 0.; ///< of curves; 0: none [s]
  double wanted_ = 0.;
  std::optional<Settings> reference_settings_;
  std::string reference_folder_;
};
} // namespace contrecoup::study
