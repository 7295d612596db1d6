// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/collective.h>
#include <contrecoup/io/output/folder_claim.h>
#include <contrecoup/study/study_result.h>
#include <contrecoup/study/variant_forecast.h>

namespace contrecoup::study
{
/// A study in its output folder.
class Study
{
public:
  /// @throws InputError for an invalid application, parameter file or entry
  Study(const StudyParameters &parameters, const std::string &output_folder);

  /// Prints the plan of the study with the sum of the forecasts of its runs.
  /// @throws InputError for outputs that no run can have, and when the
  /// application refuses a variant
  void check() const;

  /**
   * Runs all variants without outcome, and writes the results.
   * @param command with --resume, keeps finished variants of an earlier start
   * @param parameter_text all entries of the study, for parameters.prm
   * @param entries the same as a map
   * @throws InputError when the folder cannot be claimed, when there is
   * nothing to resume, for outputs that no run has, or when all variants were
   * refused
   * @throws NumericsError when the reference run or a variant failed
   * @throws Stopped after a signal
   */
  void execute(const io::CommandLine &command,
               const std::string &parameter_text,
               const std::map<std::string, std::string> &entries);

private:
  /// Also sets the units of the factors.
  /// @throws InputError, naming its origin, for the first entry or value that
  /// the application does not know
  void require_known_entries();
  void require_known(const Settings &settings, const std::string &where) const;
  /// @throws InputError for outputs that no run with such a forecast can have
  void
  require_possible_outputs(const std::vector<VariantForecast> &forecasts) const;
  /// @throws InputError for variants that the application refuses
  void require_accepted(const std::vector<VariantForecast> &forecasts) const;
  void print_costs(const std::vector<VariantForecast> &forecasts) const;
  /// Size of outcomes, which name all entries, tables and pictures [byte].
  double size_of_own_files() const;
  bool is_reference(const Task &task) const;
  /// Name of a run for messages.
  std::string task_label(const Task &task) const;

  Task make_task(const Variant &variant) const;
  /// Sets identity and folder of all runs, and the file of the reference run.
  void identify_tasks();
  bool has_outcomes() const;
  void prepare(const std::string &parameter_text,
               bool resume,
               io::FolderClaim &claim);
  void report(const Task &task);
  void write_results(const std::string &status, double seconds);
  void write_outputs() const;
  void write_summary(const std::string &status,
                     double seconds,
                     std::size_t n_variants,
                     const StudyResult &result) const;
  /// Writes the recommendation and the pictures, and shows the conclusions.
  void conclude(const StudyResult &result);
  void draw() const;
  std::string path(const std::string &name) const;

  StudyParameters parameters_;
  std::string folder_;
  ApplicationUnderStudy application_;
  std::map<std::string, std::string> base_entries_; ///< see identify_tasks()
  std::vector<Task> tasks_; ///< reference run first, if there is one
  bool has_reference_ = false;
  std::size_t n_done_before_ = 0;
  std::size_t n_done_ = 0, n_usable_ = 0, n_failed_ = 0, n_parts_shown_ = 0;
  std::optional<Failure> failure_; ///< to end with
  std::chrono::steady_clock::time_point variants_begin_;
};
} // namespace contrecoup::study
