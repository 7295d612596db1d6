// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/base/system/collective.h>
#include <contrecoup/coupling/task/scene_words.h>
#include <contrecoup/coupling/task/task_files.h>

#include <functional>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// What a task of a scene runs, and how.
struct TaskDescription
{
  /// Runs the application with the given arguments; --check stores its cost
  /// estimate, for which it spends this part of the usual time on trial runs.
  /// Collective.
  using Runner = std::function<
    Failure(const std::vector<std::string> &, double, CostEstimate &)>;

  std::string name;        ///< of the task and its folder
  std::string application; ///< see source_digest()
  std::string scene_folder;
  std::string text;    ///< content of the parameter file
  SceneWords words;    ///< translates names of entries in messages
  io::FileNames files; ///< that the application writes
  Runner runner;
  std::vector<std::string> upstream{}; ///< keys of tasks whose results are read
  /// Numbers in tables, see io::ApplicationDescription::tables.
  std::vector<std::string> tables{};
  bool can_resume = false;  ///< whether the application has --resume
  bool is_optional = false; ///< whether the scene is complete without the task
  /// Further arguments of the application, "--set ..." and so on; for a check,
  /// in place of what earlier tasks have not made yet.
  std::vector<std::string> arguments{}, check_arguments{};
  /// Finds more arguments in results of earlier tasks, on the first rank.
  std::function<std::vector<std::string>()> find_late_arguments{};
};


/**
 * Application as a task of a scene, see TaskFiles. A task that finished
 * with the same key and whose results are unchanged is not run again.
 */
class SceneTask
{
public:
  /// State of the task in the scene's folder.
  struct Status
  {
    bool has_record = false;      ///< has a record, with any key
    bool is_finished = false;     ///< with this key
    bool has_other_key = false;   ///< finished with another key
    bool is_damaged = false;      ///< finished, but results were changed since
    bool is_started = false;      ///< with this key
    bool uses_new_folder = false; ///< the unfinished or next run uses NAME.new
    /// The unfinished run has a checkpoint, any key
    bool has_checkpoint = false;
  };

  explicit SceneTask(const TaskDescription &description);

  const TaskDescription &description() const
  {
    return description_;
  }

  const std::string &name() const
  {
    return description_.name;
  }

  /// Folder of the results.
  std::string folder() const
  {
    return files_.folder(false);
  }

  /// Hash of everything that the results depend on: the parameters, the
  /// contents of files that they name, the sources of the program, and the
  /// keys of the tasks before.
  const std::string &key() const
  {
    return record_.key;
  }

  /// Determines status(). Collective.
  void inspect(Collective &collective);

  /// Completes an interrupted replace() and checks that the task will not
  /// overwrite files of others. Called by the first rank.
  /// @throws InputError for such files
  void prepare() const;

  const Status &status() const
  {
    return status_;
  }

  /// Marks the task to be run again although it is finished.
  void discard_result()
  {
    status_.is_finished = false;
    status_.is_started = false;
    status_.uses_new_folder = true;
  }

  bool is_finished() const
  {
    return status_.is_finished;
  }

  const TaskRecord &record() const
  {
    return record_;
  }

  /// Failure or signal that stopped the run, if any.
  const Failure &stop() const
  {
    return stop_;
  }

  /// Runs --check of the application and returns its cost estimate.
  /// Collective.
  /// @param trial_share part of the usual time for trial runs; 0: none
  /// @throws InputError
  CostEstimate check(double trial_share, Collective &collective);

  /**
   * Runs the task unless it is finished; if @p resume, continues from its
   * last checkpoint with the same key. Collective.
   * @return whether the task is finished; false if it was asked to stop
   * @throws InputError, NumericsError, SystemError naming the task
   */
  bool run(bool resume, Collective &collective);

private:
  Status find_status();
  void begin(bool goes_on);
  void take_summary(double wall_seconds);
  void end(double wall_seconds);

  /// Runs the application and translates its messages.
  Failure call(const std::vector<std::string> &arguments,
               double trial_share,
               CostEstimate &cost) const;

  TaskDescription description_;
  TaskFiles files_;
  TaskRecord record_;
  Status status_;
  Failure stop_;
};


/// Short hash of a text by SHA-1: equal for equal texts and, in practice,
/// different for different ones.
std::string short_key(const std::string &text);
} // namespace contrecoup::coupling
