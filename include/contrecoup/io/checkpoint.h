// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>
#include <contrecoup/io/manifest.h>

#include <functional>
#include <optional>
#include <string>

namespace contrecoup
{
namespace io
{
  /**
   * The numbered checkpoints of an output folder, `checkpoint/0007/`. Each
   * holds the solver's files, `run.json` (what the run loop and the outputs
   * need to go on) and, written last, the marker `complete.json` with size
   * and CRC-32 of every other file. The names of solvers' files end in .bin or
   * .h5, so that nothing else is ever removed. The last two complete ones are
   * kept. Every function is collective; files are judged by the first rank.
   */
  class Checkpoints
  {
  public:
    /// A checkpoint whose files are all as they were written.
    struct Found
    {
      std::string folder;
      std::string run; ///< content of run.json
    };

    /// @param folder the folder "checkpoint" itself
    Checkpoints(const std::string &folder, Collective &collective);

    /**
     * Writes the next checkpoint and removes old ones.
     * @param run content of run.json
     * @param save writes the solver's files into the given folder
     * @throws SystemError when the disk is full; nothing of the new
     *   checkpoint is left then, and the earlier ones stay
     */
    void write(const std::string &run,
               const std::function<void(const std::string &)> &save);

    /// The newest complete checkpoint, checked byte by byte; older ones
    /// take the place of a damaged one, which the log then names.
    /// @throws InputError when all are damaged or incomplete.
    std::optional<Found> newest() const;

    /// Whether any was written to its end. Not collective.
    bool has_complete() const;

    /// The names of all files in checkpoints below @p folder.
    static FileNames files(const std::string &folder);

  private:
    std::string folder_;
    Collective &collective_;
  };
} // namespace io
} // namespace contrecoup
