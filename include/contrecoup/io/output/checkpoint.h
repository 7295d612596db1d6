// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/collective.h>
#include <contrecoup/io/output/manifest.h>

#include <functional>
#include <optional>
#include <string>

namespace contrecoup
{
namespace io
{
  /**
   * The numbered checkpoints of an output folder, `checkpoint/0007/`. Each
   * holds the solver's files, `run.json` (state of run loop and outputs) and,
   * written last, the marker `complete.json` with size and CRC-32 of every
   * other file. Names of solver files end in .bin or .h5, so that no other
   * file is ever removed. The last two complete checkpoints are kept. Every
   * function is collective; the first rank checks files.
   */
  class Checkpoints
  {
  public:
    /// A checkpoint with undamaged files.
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
     * @throws SystemError when the disk is full; the new checkpoint is then
     * removed, and earlier ones stay
     */
    void write(const std::string &run,
               const std::function<void(const std::string &)> &save);

    /// Returns the newest complete checkpoint after checking every byte. Falls
    /// back to older ones if it is damaged, and logs this.
    /// @throws InputError when all are damaged or incomplete
    std::optional<Found> newest() const;

    /// Whether any complete checkpoint exists. Not collective.
    bool has_complete() const;

    /// Names of all files in checkpoints below @p folder.
    static FileNames files(const std::string &folder);

  private:
    std::string folder_;
    Collective &collective_;
  };
} // namespace io
} // namespace contrecoup
