// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/output/folder_lock.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>

namespace contrecoup
{
namespace io
{
  namespace
  {
    const std::string mark = "Contrecoup: ";

    std::string read_start(const int descriptor)
    {
      char text[512];
      const ssize_t n = pread(descriptor, text, sizeof(text), 0);
      return std::string(text, n > 0 ? static_cast<std::size_t>(n) : 0);
    }

    /// Identifies this process to other users.
    std::string holder(const std::string &application)
    {
      char host[256] = "";
      gethostname(host, sizeof(host) - 1);
      const std::time_t now = std::time(nullptr);
      std::tm parts{};
      localtime_r(&now, &parts);
      char start[32] = "";
      std::strftime(start, sizeof(start), "%Y-%m-%d %H:%M:%S", &parts);
      return mark + application + ", process " + std::to_string(getpid()) +
             " on " + host + " since " + start + "\n";
    }

    /// Whether the file still exists under its name; its holder may have
    /// removed it.
    bool has_name(const int descriptor, const std::string &file)
    {
      struct stat opened
      {
      }, named{};
      return fstat(descriptor, &opened) == 0 &&
             stat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
             opened.st_dev == named.st_dev;
    }

    bool lock(const int descriptor)
    {
      struct flock range
      {};
      range.l_type = F_WRLCK;
      range.l_whence = SEEK_SET;
      return fcntl(descriptor, F_OFD_SETLK, &range) == 0;
    }
  } // namespace

  FolderLock::FolderLock(const std::string &folder,
                         const std::string &application)
    : file_(folder + "/" + name)
  {
    while (!try_to_take(folder, application))
      close(descriptor_);
  }

  bool FolderLock::try_to_take(const std::string &folder,
                               const std::string &application)
  {
    descriptor_ =
      open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ < 0)
      throw InputError("the output folder \"" + folder +
                       "\" is not writable: " + std::strerror(errno));
    const std::string content = read_start(descriptor_);
    if (!content.empty() && content.compare(0, mark.size(), mark) != 0)
    {
      close(descriptor_);
      throw InputError("\"" + file_ +
                       "\" was not written by Contrecoup, which needs this "
                       "name; move it away, or give another folder");
    }
    if (!lock(descriptor_))
    {
      const int reason = errno;
      if (reason == EAGAIN || reason == EACCES)
      {
        close(descriptor_);
        throw InputError("\"" + folder + "\" is in use by " +
                         (content.empty() ? "a run that begins just now"
                                          : trim(content.substr(mark.size()))) +
                         "; wait for it, or give another folder");
      }
      show_line("note: the file system of \"" + folder + "\" has no locks (" +
                std::strerror(reason) +
                "): nothing keeps two runs apart there");
    }
    if (!has_name(descriptor_, file_))
      return false;
    // A full disk does not matter: the lock file's content is only
    // informative.
    const std::string text = holder(application);
    if (ftruncate(descriptor_, 0) != 0 ||
        pwrite(descriptor_, text.data(), text.size(), 0) < 0)
      errno = 0;
    return true;
  }

  FolderLock::~FolderLock()
  {
    // In this order, no process takes a file that is about to be unlinked
    // unnoticed.
    unlink(file_.c_str());
    close(descriptor_);
  }
} // namespace io
} // namespace contrecoup
