// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/log.h>
#include <contrecoup/io/output/pictures.h>

#include <boost/algorithm/string/replace.hpp>

#include <cstdlib>
#include <filesystem>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Quotes a word for the shell.
    std::string quoted(const std::string &text)
    {
      return "'" + boost::replace_all_copy<std::string>(text, "'", "'\\''") +
             "'";
    }
  } // namespace

  std::string plot_program()
  {
    std::error_code ignored;
    const std::filesystem::path application =
      std::filesystem::read_symlink("/proc/self/exe", ignored);
    const std::filesystem::path installed =
      application.parent_path().parent_path() / CONTRECOUP_INSTALLED_PLOT;
    return std::filesystem::exists(installed, ignored) ? installed.string()
                                                       : CONTRECOUP_SOURCE_PLOT;
  }

  void draw(const std::string &picture_command,
            const std::string &folder,
            const std::string &what,
            const std::string &where)
  {
    const std::string program = quoted(plot_program()) + " " + picture_command;
    const std::string command =
      program + " " + quoted(folder) + " > /dev/null 2>&1";
    log_line(std::system(command.c_str()) == 0
               ? what + " in " + folder + "/" + where
               : "no " + what + ": " + program + " failed");
  }
} // namespace io
} // namespace contrecoup
