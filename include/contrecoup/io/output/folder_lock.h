// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
namespace io
{
  /**
   * Advisory lock on a folder for the lifetime of the object, on its file
   * "lock", which names the holder. The system releases the lock however the
   * process ends, so nothing needs cleaning up after kill -9. The lock is a
   * byte-range lock of an open file description (fcntl with F_OFD_SETLK).
   * Unlike flock, Linux passes it on to NFS servers, so that runs on several
   * machines see each other; unlike plain fcntl locks it survives when the
   * process opens and closes the file again. On a file system without locks, a
   * line in the log says so, and the folder is not locked. For use by one
   * rank.
   */
  class FolderLock
  {
  public:
    /// Name of the lock file.
    static constexpr const char *name = "lock";

    /// @throws InputError when another run holds the lock (names it), when the
    /// folder is not writable, or when "lock" is a foreign file
    FolderLock(const std::string &folder, const std::string &application);

    /// Releases the lock and removes the file.
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
