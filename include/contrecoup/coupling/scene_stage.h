// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>
#include <contrecoup/base/simulation.h>
#include <contrecoup/coupling/scene_words.h>
#include <contrecoup/coupling/stage_files.h>

#include <functional>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/**
 * An application as a stage of a scene, see StageFiles. A stage that finished
 * with the same key, and whose results are all as they were written, is not run
 * again.
 */
class SceneStage
{
public:
  /// Runs the application with these arguments; with --check notes what it
  /// would cost. Collective.
  using Runner =
    std::function<Failure(const std::vector<std::string> &, CostEstimate &)>;

  /// How the stage stands in the scene's folder.
  struct Standing
  {
    bool has_record = false;     ///< with whatever key
    bool is_finished = false;    ///< with this key
    bool is_other = false;       ///< finished, but with another key
    bool is_damaged = false;     ///< finished once, but not as it was
    bool is_begun = false;       ///< with this key
    bool is_new = false;         ///< what is begun, or will be, stands beside
    bool has_checkpoint = false; ///< of what is begun, with whatever key
  };

  /**
   * @param name of the application, see source_digest()
   * @param text of the parameter file
   * @param names of the files that the application writes
   * @param upstream keys of the stages whose results this one takes
   * @param can_resume whether the application takes --resume
   */
  SceneStage(const std::string &name,
             const std::string &scene_folder,
             const std::string &text,
             const io::FileNames &names,
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
    return files_.folder(false);
  }

  /// What the results depend on, in short: the parameters, the contents of
  /// files that these name, the sources of the program, and the stages before.
  const std::string &key() const
  {
    return record_.key;
  }

  /// Finds out how the stage stands. Collective.
  void inspect(Collective &collective);

  /// Brings to its end what a process was killed in, and makes sure that
  /// nothing of somebody else is where the stage will write. By the first
  /// rank.
  /// @throws InputError when there is
  void prepare() const;

  const Standing &standing() const
  {
    return standing_;
  }

  /// Makes it anew although it is finished.
  void discard_result()
  {
    standing_.is_finished = false;
    standing_.is_begun = false;
    standing_.is_new = true;
  }

  bool is_finished() const
  {
    return standing_.is_finished;
  }

  const StageRecord &record() const
  {
    return record_;
  }

  /// What stopped the run, if something did.
  const Failure &stop() const
  {
    return stop_;
  }

  /// Further arguments for the application, "--set ..." and so on.
  void set_arguments(const std::vector<std::string> &arguments)
  {
    arguments_ = arguments;
  }

  /// What its entries are called in what it says.
  void set_words(const SceneWords &words)
  {
    words_ = words;
  }

  /// What one of them is called.
  void rename(const std::string &entry, const std::string &name)
  {
    words_.rename(entry, name);
  }

  /// What an entry of it is called in the scene.
  std::string named(const std::string &entry) const
  {
    return words_(entry);
  }

  /// Says what it would do and cost, and returns the latter. Collective.
  /// @throws InputError
  CostEstimate check(Collective &collective);

  /**
   * Runs it unless it is finished; goes on from its last checkpoint when that
   * is wanted and there is one with the same key. Returns whether it is
   * finished now; it is not when it was asked to stop. Collective.
   * @throws InputError, NumericsError, SystemError naming the stage
   */
  bool run(bool resume, Collective &collective);

private:
  Standing find_standing();
  void begin(bool goes_on);
  void take_summary(double wall_seconds);
  void end(double wall_seconds);

  /// Runs the application, whose messages then have the scene's words.
  Failure call(const std::vector<std::string> &arguments,
               CostEstimate &cost) const;

  std::string name_;
  SceneWords words_;
  StageFiles files_;
  std::string text_;
  io::FileNames names_;
  bool can_resume_;
  Runner runner_;
  std::vector<std::string> arguments_;
  StageRecord record_;
  Standing standing_;
  Failure stop_;
};


/// A short name for a text, by SHA-1: equal for equal texts, and different
/// for all others that are likely to be met.
std::string short_key(const std::string &text);
} // namespace contrecoup::coupling
