// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/column.h>
#include <contrecoup/study/curve.h>
#include <contrecoup/study/factor.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace contrecoup::study
{
/**
 * Error of a run: a value in its summary, the difference of a quantity from a
 * known value or a reference run, or the difference from the extrapolated
 * limit under mesh refinement.
 */
class ErrorMeasure
{
public:
  /// Declares subsection "Error".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for contradictory entries
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Whether errors are measured.
  bool is_active() const;

  /// Whether errors require several runs for extrapolation.
  bool is_self_convergence() const;

  /// Entries of the reference run, if the study has to run it.
  const std::optional<Settings> &reference_settings() const;

  /// Output folder of the reference run; empty: none.
  void set_reference_folder(const std::string &folder);
  const std::string &reference_folder() const
  {
    return reference_folder_;
  }

  /// @throws InputError unless an existing reference folder holds a finished
  /// run that has the quantity
  void require_reference() const;

  /**
   * Error of a run; for self-convergence the quantity itself.
   * @param folder output folder of the run
   * @param summary content of its summary.json
   * @return NaN if the value in the run is not finite
   * @throws InputError when the run has no such quantity
   */
  double value(const std::string &folder, const nlohmann::json &summary) const;

  /// Name of the error for tables and axes, with the title of the output if it
  /// is one of @p columns.
  std::string title(const std::vector<Column> &columns) const;

  /// " against a run with Domain/Coarse leaves = 1600", what a relative error
  /// is relative to; empty where there is no such run.
  std::string against() const;

  /// Short name of the error in summary.json, such as "density_L1".
  std::string short_name() const;

  /// Address of the output from which the error follows, see RunOutputs; empty
  /// for curves and planes.
  std::string address() const;

  /// Required error; 0: none given.
  double required_error() const;

private:
  double quantity(const std::string &folder,
                  const nlohmann::json &summary) const;
  double reference_quantity() const;
  double difference(const std::string &folder) const;
  /// Whether the quantity is a path in summary.json.
  bool is_in_summary() const;
  bool compares_files() const;

  /// Feature of a curve: last word of the quantity; empty for other
  /// quantities.
  std::string curve_feature() const;

  /// Curve from probes.csv or history.csv of the run in @p folder, averaged
  /// over the averaging time.
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
