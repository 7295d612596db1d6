// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/output/manifest.h>

#include <string>

namespace contrecoup::coupling
{
/// Record of a task, stored in its folder.
struct TaskRecord
{
  std::string key;          ///< hash of the task's inputs, see SceneTask::key()
  std::string status;       ///< started, finished, stopped, failed
  double wall_seconds = 0.; ///< wall-clock time of all starts
  double core_seconds = 0.; ///< core time of all starts and ranks
  double peak_memory = 0.;  ///< [byte]
  double disk = 0.;         ///< size of the folder [byte]
};


/**
 * Files of a task in the scene's folder: output folder NAME, parameter file
 * NAME.prm and record NAME.stage.json. If a task is run again while finished
 * results exist, it writes to NAME.new, which replaces NAME when complete.
 * Used by one rank.
 */
class TaskFiles
{
public:
  TaskFiles(const std::string &scene_folder, const std::string &name);

  /// Names of these files, for the scene's manifest.
  static io::FileNames names(const std::string &task);

  /// @param uses_new_folder true: the new run next to the finished one
  std::string folder(bool uses_new_folder) const;
  std::string parameter_file(bool uses_new_folder) const;
  std::string record_file(bool uses_new_folder) const;

  /// Reads the record; empty if it is missing or damaged.
  TaskRecord read_record(bool uses_new_folder) const;
  void write_record(bool uses_new_folder, const TaskRecord &record) const;

  /// Reason why the folder does not hold the results of a finished run
  /// unchanged; empty if it does. Reads all result files.
  std::string find_damage() const;

  /// Whether the folder has a complete checkpoint.
  bool has_checkpoint(bool uses_new_folder) const;

  /**
   * Replaces the old task by the new one. Files in the old folder that
   * Contrecoup has not written move to the new folder.
   *
   * @throws SystemError
   */
  void replace() const;

  /// Completes an interrupted replace().
  void complete_replace() const;

private:
  void clear_old() const;
  std::string path(const std::string &ending) const
  {
    return scene_folder_ + "/" + name_ + ending;
  }

  std::string scene_folder_;
  std::string name_;
};
} // namespace contrecoup::coupling
