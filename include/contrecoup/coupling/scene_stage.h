// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>

#include <functional>
#include <string>
#include <vector>

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
 * An application as a stage of a scene: its parameter file NAME.prm, its
 * output folder NAME and its record NAME.stage.json in the scene's folder. A
 * stage that finished with the same key is not run again.
 */
class SceneStage
{
public:
  /// Runs the application with these arguments. Collective.
  using Runner = std::function<Failure(const std::vector<std::string> &)>;

  /**
   * @param name of the application, see source_digest()
   * @param text of the parameter file
   * @param upstream keys of the stages whose results this one takes
   * @param can_resume whether the application takes --resume
   */
  SceneStage(const std::string &name,
             const std::string &scene_folder,
             const std::string &text,
             const std::vector<std::string> &upstream,
             bool can_resume,
             const Runner &runner);

  const std::string &name() const
  {
    return name_;
  }

  /// Folder of the results.
  std::string folder() const
  {
    return scene_folder_ + "/" + name_;
  }

  /// What the results depend on, in short: the parameters, the contents of
  /// files that these name, the sources of the program, and the stages before.
  const std::string &key() const
  {
    return record_.key;
  }

  /// Whether it is finished with this key.
  bool is_finished() const
  {
    return record_.status == "finished";
  }

  /// Whether there is a record of it, with whatever key.
  bool has_record() const;

  const StageRecord &record() const
  {
    return record_;
  }

  /// Further arguments for the application, "--set ..." and so on.
  void set_arguments(const std::vector<std::string> &arguments)
  {
    arguments_ = arguments;
  }

  /// Says what it would do and cost. Collective. @throws InputError
  void check(Collective &collective);

  /**
   * Runs it unless it is finished; goes on from its last checkpoint when that
   * is wanted and there is one with the same key. Returns whether it is
   * finished now; it is not when it was asked to stop. Collective.
   * @throws InputError, NumericsError, SystemError naming the stage
   */
  bool run(bool resume, Collective &collective);

private:
  std::string file(const std::string &ending) const
  {
    return scene_folder_ + "/" + name_ + ending;
  }
  void read_record();
  void write_record() const;
  bool has_checkpoint() const;
  void take_summary(double wall_seconds);

  std::string name_;
  std::string scene_folder_;
  std::string text_;
  bool can_resume_;
  Runner runner_;
  std::vector<std::string> arguments_;
  StageRecord record_;
};


/// A short name for a text, by SHA-1: equal for equal texts, and different
/// for all others that are likely to be met.
std::string short_key(const std::string &text);
} // namespace contrecoup::coupling
