// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/output/folder_claim.h>
#include <contrecoup/study/study_result.h>

namespace contrecoup::study
{
/// A study in its output folder.
class Study
{
public:
  /// @throws InputError for an invalid application, parameter file or entry
  Study(const StudyParameters &parameters, const std::string &output_folder);

  /// Prints the plan of the study.
  /// @throws InputError when the application refuses the first variant
  void check() const;

  /**
   * Runs all variants without outcome, and writes the results.
   * @param command with --resume, keeps finished variants of an earlier start
   * @param parameter_text all entries of the study, for parameters.prm
   * @param entries the same as a map
   * @throws InputError when the folder cannot be claimed, when there is
   * nothing to resume, or when all variants were refused
   * @throws NumericsError when the reference run failed
   * @throws Stopped after a signal
   */
  void execute(const io::CommandLine &command,
               const std::string &parameter_text,
               const std::map<std::string, std::string> &entries);

private:
  /// @throws InputError, naming its origin, for the first entry or value that
  /// the application does not know
  void require_known_entries() const;
  /// Name of a run for messages.
  std::string task_label(const Task &task) const;
  std::string plan_of_first() const;
  void require_known(const Settings &settings, const std::string &where) const;

  Task make_task(const Variant &variant) const;
  /// Sets identity and folder of all runs, and the file of the reference run.
  void identify_tasks();
  bool has_outcomes() const;
  void prepare(const std::string &parameter_text,
               bool resume,
               io::FolderClaim &claim);
  void report(const Task &task);
  void write_results(const std::string &status, double seconds);
  void write_recommendation(const StudyResult &result);
  void draw() const;
  std::string path(const std::string &name) const;

  StudyParameters parameters_;
  std::string folder_;
  ApplicationUnderStudy application_;
  std::map<std::string, std::string> base_entries_; ///< see identify_tasks()
  std::vector<Task> tasks_; ///< reference run first, if there is one
  bool has_reference_ = false;
  std::size_t n_done_before_ = 0;
  std::size_t n_done_ = 0;
  std::chrono::steady_clock::time_point begin_;
};
} // namespace contrecoup::study
