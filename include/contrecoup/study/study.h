// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/folder_claim.h>
#include <contrecoup/study/study_result.h>

namespace contrecoup::study
{
/// A study in its output folder.
class Study
{
public:
  /// @throws InputError when application, base file or entries are wrong
  Study(const StudyParameters &parameters, const std::string &output_folder);

  /// Says what would be run.
  /// @throws InputError when the application refuses the first variant
  void check() const;

  /**
   * Runs what an earlier start has not run yet, and writes the results.
   * @param command with --resume keeps the variants that an earlier start has
   *   finished
   * @param parameter_text all entries of the study, for parameters.prm
   * @param entries the same
   * @throws InputError when the folder is not to be had, when there is nothing
   *   to resume, or when all variants were refused; NumericsError when the
   *   reference run failed; Stopped after a signal
   */
  void execute(const io::CommandLine &command,
               const std::string &parameter_text,
               const std::map<std::string, std::string> &entries);

private:
  /// @throws InputError for the first entry or value that the application
  ///   does not know, with where it stands
  void require_known_entries() const;
  /// How a run is called in what the study says.
  std::string told(const Task &task) const;
  std::string plan_of_first() const;
  void require_known(const Settings &settings, const std::string &where) const;

  Task make_task(const Variant &variant) const;
  /// What runs are called in the study's folder, and the file of the reference.
  void identify_tasks();
  bool has_outcomes() const;
  void prepare(const std::string &parameter_text,
               bool resume,
               io::FolderClaim &claim);
  void report(const Task &task);
  void write_results(const std::string &status, double seconds);
  void conclude(const StudyResult &result);
  void draw() const;
  std::string path(const std::string &name) const;

  StudyParameters parameters_;
  std::string folder_;
  ApplicationUnderStudy application_;
  std::map<std::string, std::string> base_entries_; ///< see identify_tasks()
  std::vector<Task> tasks_; ///< the reference run first, if there is one
  bool has_reference_ = false;
  std::size_t n_done_before_ = 0;
  std::size_t n_done_ = 0;
  std::chrono::steady_clock::time_point begin_;
};
} // namespace contrecoup::study
