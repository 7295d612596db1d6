// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/manifest.h>

#include <string>

namespace contrecoup::coupling
{
/// How a stage of a scene stands, as kept in its record.
struct StageRecord
{
  std::string key;          ///< of what it was made from
  std::string status;       ///< started, finished, stopped, failed
  double wall_seconds = 0.; ///< of all starts
  double core_seconds = 0.; ///< of all starts and ranks
  double peak_memory = 0.;  ///< [byte]
  double disk = 0.;         ///< of its folder [byte]
};


/**
 * What a stage has in the scene's folder: its output folder NAME, its parameter
 * file NAME.prm and its record NAME.stage.json. A stage that is made anew while
 * a finished one is there is made beside it, as NAME.new, and takes its place
 * when it is complete. Used by one rank.
 */
class StageFiles
{
public:
  StageFiles(const std::string &scene_folder, const std::string &name);

  /// The names of all of this, for the scene's manifest.
  static io::FileNames names(const std::string &stage);

  /// @param is_new of the stage that is made beside the finished one
  std::string folder(bool is_new) const;
  std::string parameter_file(bool is_new) const;
  std::string record_file(bool is_new) const;

  /// The record; an empty one if there is none, or if it is damaged.
  StageRecord read_record(bool is_new) const;
  void write_record(bool is_new, const StageRecord &record) const;

  /// Why the folder does not hold all results of a finished run as they were
  /// written; empty if it does. Reads every one.
  std::string damage() const;

  /// Whether a run in the folder left a complete checkpoint.
  bool has_checkpoint(bool is_new) const;

  /**
   * Lets the new stage take the place of the old one, of which only files that
   * Contrecoup has not written are kept, in the new folder.
   * @throws SystemError
   */
  void replace() const;

  /// Brings a replace() to its end in which the process was killed.
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
