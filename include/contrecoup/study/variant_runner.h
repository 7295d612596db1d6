// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/application_under_study.h>
#include <contrecoup/study/design.h>
#include <contrecoup/study/outcome.h>

#include <functional>
#include <list>
#include <memory>

namespace contrecoup::study
{
/// A variant that is to be run, or was.
struct Task
{
  Variant variant;
  std::string identity;
  std::string folder; ///< of all that belongs to it
  std::optional<Outcome> outcome;

  /// The output folder of the run.
  std::string run_folder() const;

  /// The file that outlives the study's process.
  std::string outcome_file() const;
};

/**
 * Runs tasks as processes side by side within a number of cores. Each leaves
 * its outcome in its folder as soon as it ends.
 */
class VariantRunner
{
public:
  /// @param cores in all; at least the ranks of one run
  /// @param time_limit of a run [s]; 0: none
  VariantRunner(const ApplicationUnderStudy &application,
                unsigned int cores,
                double time_limit);

  /**
   * Runs the tasks that have no outcome, in their order.
   * @param report is called after each
   * @return false when a signal asked to stop; what was running then was
   *   ended, and has no outcome
   * @throws SystemError when a run could not write its files, as none could
   */
  bool run(std::vector<Task> &tasks,
           const std::function<void(const Task &)> &report);

private:
  struct Running
  {
    Task *task;
    std::unique_ptr<ChildProcess> process;
    bool timed_out = false;
  };

  void start(Task &task);
  void look_after(const std::function<void(const Task &)> &report);

  const ApplicationUnderStudy &application_;
  unsigned int slots_;
  double time_limit_;
  std::list<Running> running_;
};
} // namespace contrecoup::study
