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
/// A variant before or after its run.
struct Task
{
  Variant variant;
  std::string identity;
  std::string folder; ///< for all files of the task
  std::optional<Outcome> outcome;

  /// Output folder of the run.
  std::string run_folder() const;

  /// File with the outcome, for later starts of the study.
  std::string outcome_file() const;
};

/// Runs tasks as concurrent processes within a number of cores. Each task
/// writes its outcome to its folder when it ends.
class VariantRunner
{
public:
  /// @param cores total number; at least the ranks of one run
  /// @param time_limit of a run [s]; 0: none
  VariantRunner(const ApplicationUnderStudy &application,
                unsigned int cores,
                double time_limit);

  /**
   * Runs the tasks without outcome, in order.
   * @param report called after each task
   * @return false after a stop signal; running tasks are then ended without
   * outcome
   * @throws SystemError when a run could not write its files, which affects
   * all runs
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
  void poll_running(const std::function<void(const Task &)> &report);

  const ApplicationUnderStudy &application_;
  unsigned int slots_;
  double time_limit_;
  std::list<Running> running_;
};
} // namespace contrecoup::study
