// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/command_line.h>
#include <contrecoup/io/folder_lock.h>
#include <contrecoup/io/manifest.h>

#include <functional>
#include <optional>

namespace contrecoup
{
namespace io
{
  /**
   * An output folder that one run has for itself: made if need be, locked, and
   * with nothing of somebody else where the run will write. What is in it
   * stays as it is until begin() or go_on(). Used by one rank.
   */
  class FolderClaim
  {
  public:
    /**
     * Takes the folder.
     * @throws InputError when it cannot be made, is the root or the home
     *   folder, belongs to a run that goes on just now, or holds files of
     *   these names that Contrecoup has not written
     */
    FolderClaim(const std::string &folder,
                const std::string &application,
                const FileNames &names,
                const RunInput &input);

    /// As discard().
    ~FolderClaim();

    /**
     * Whether the command may begin or go on here. If the same run has
     * finished here before, says so in the log and returns false.
     * @param can_go_on tells whether an earlier run left something from which
     *   --resume goes on; empty for an application that has no --resume
     * @param more with which --resume has something to do here
     * @throws InputError when the command would take away what an earlier run
     *   left, and neither --resume nor --overwrite asks for that
     */
    bool admits(const CommandLine &command,
                const std::function<bool()> &can_go_on,
                const std::string &more = "a later end") const;

    const Manifest &manifest() const
    {
      return manifest_;
    }

    /// What differs from the run that was here before: application, an entry
    /// or a file, in one clause; empty if nothing does.
    std::string difference() const;

    /// Removes what an earlier run left, which the log says.
    void begin();

    /// Keeps what an earlier run left.
    void go_on();

    /// Says how the run stands, see Manifest.
    void set_status(const std::string &status);

    /// Leaves the folder as it was found if nothing was written: removes it
    /// if it was made.
    void discard();

  private:
    void make_folder();
    void require_own_names() const;

    std::string folder_;
    std::string application_;
    FileNames names_;
    RunInput input_;
    std::vector<std::string> made_; ///< folders, the innermost first
    std::optional<FolderLock> lock_;
    Manifest manifest_;
  };
} // namespace io
} // namespace contrecoup
