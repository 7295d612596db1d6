// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
namespace io
{
  /**
   * Keeps a folder for one run as long as it lives, by an advisory lock on the
   * file "lock" in it, which says who holds it. The system gives the lock back
   * however the process ends, so that nothing has to be cleaned up after
   * kill -9. It is a byte-range lock of an open file description (fcntl with
   * F_OFD_SETLK): unlike flock, Linux hands it on to NFS servers, so that runs
   * on several machines see each other, and unlike plain fcntl locks it is not
   * lost when the process opens and closes the file once more. A file system
   * that has no locks is said in the log, and then there is none. Used by one
   * rank.
   */
  class FolderLock
  {
  public:
    /// The file.
    static constexpr const char *name = "lock";

    /// @throws InputError when another run holds it, which it names, when the
    ///   folder takes no files, or when "lock" is a file of something else
    FolderLock(const std::string &folder, const std::string &application);

    /// Removes the file.
    ~FolderLock();
    FolderLock(const FolderLock &) = delete;
    FolderLock &operator=(const FolderLock &) = delete;

  private:
    bool try_to_take(const std::string &folder, const std::string &application);

    std::string file_;
    int descriptor_ = -1;
  };
} // namespace io
} // namespace contrecoup
