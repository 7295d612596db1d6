// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/output/manifest.h>

#include <string>

namespace contrecoup::coupling
{
/// Record of a stage, stored in its folder.
struct StageRecord
{
  std::string key;    ///< hash of the stage's inputs, see SceneStage::key()
  std::string status; ///< started, finished, stopped, failed
  double wall_seconds = 0.; ///< wall-clock time of all starts
  double core_seconds = 0.; ///< core time of all starts and ranks
  double peak_memory = 0.;  ///< [byte]
  double disk = 0.;         ///< size of the folder [byte]
};


/**
 * Files of a stage in the scene's folder: output folder NAME, parameter file
 * NAME.prm and record NAME.stage.json. If a stage is run again while finished
 * results exist, it writes to NAME.new, which replaces NAME when complete.
 * Used by one rank.
 */
class StageFiles
{
public:
  StageFiles(const std::string &scene_folder, const std::string &name);

  /// Names of these files, for the scene's manifest.
  static io::FileNames names(const std::string &stage);

  /// @param is_new true: the new run beside the finished one
  std::string folder(bool is_new) const;
  std::string parameter_file(bool is_new) const;
  std::string record_file(bool is_new) const;

  /// Reads the record; empty if it is missing or damaged.
  StageRecord read_record(bool is_new) const;
  void write_record(bool is_new, const StageRecord &record) const;

  /// Reason why the folder does not hold the results of a finished run
  /// unchanged; empty if it does. Reads all result files.
  std::string damage() const;

  /// Whether the folder has a complete checkpoint.
  bool has_checkpoint(bool is_new) const;

  /**
   * Replaces the old stage by the new one. Files in the old folder that
   * Contrecoup has not written move to the new folder.
   *
   * @throws SystemError
   */
  void replace() const;

  /// Completes an interrupted replace().
  void mend() const;

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
