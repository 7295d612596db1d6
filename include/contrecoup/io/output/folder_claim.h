// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/output/folder_lock.h>
#include <contrecoup/io/output/manifest.h>
#include <contrecoup/io/run/command_line.h>

#include <functional>
#include <optional>

namespace contrecoup
{
namespace io
{
  /**
   * Exclusive use of an output folder by one run: creates it if necessary,
   * locks it, and makes sure that no foreign files have names the run will
   * write. Existing content stays until begin() or resume(). For use by one
   * rank.
   */
  class FolderClaim
  {
  public:
    /**
     * Claims the folder.
     * @throws InputError when it cannot be created, is the root or home
     * folder, is in use by another run, or holds foreign files with these
     * names
     */
    FolderClaim(const std::string &folder,
                const std::string &application,
                const FileNames &names,
                const RunInput &input);

    /// Calls discard().
    ~FolderClaim();

    /**
     * Whether the command may begin or resume here. If the same run has
     * finished here before, logs that and returns false.
     * @param can_resume whether --resume can continue an earlier run; empty for
     * an application without --resume
     * @param more what --resume would need to have work to do
     * @throws InputError when the command would remove results of an earlier
     * run without --resume or --overwrite
     */
    bool may_proceed(const CommandLine &command,
                     const std::function<bool()> &can_resume,
                     const std::string &more = "a later end") const;

    /**
     * Whether --resume continues an earlier run. A run of this application that
     * ended before it left anything to continue begins, which is logged.
     * @param can_resume whether there is something to continue; if not, true
     * means that the folder holds something else
     */
    bool goes_on(const CommandLine &command, bool can_resume) const;

    const Manifest &manifest() const
    {
      return manifest_;
    }

    /// Difference to the earlier run in this folder: application, an entry or
    /// a file, as one clause; empty if none.
    std::string difference() const;

    /// Removes the files of an earlier run, and logs this.
    void begin();

    /// Keeps the files of an earlier run.
    void resume();

    /// Sets the status of the run, see Manifest.
    void set_status(const std::string &status);

    /// If nothing was written, restores the initial state: removes a folder
    /// that was created.
    void discard();

  private:
    void make_folder();
    void require_own_names() const;

    std::string folder_;
    std::string application_;
    FileNames names_;
    RunInput input_;
    std::vector<std::string> made_; ///< created folders, innermost first
    std::optional<FolderLock> lock_;
    Manifest manifest_;
  };
} // namespace io
} // namespace contrecoup
