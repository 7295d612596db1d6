// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/shell_word.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/io/output/pictures.h>

#include <dlfcn.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Output of a command, and the status that wait() gives; where it fails,
    /// the last line is that of its errors.
    std::pair<std::string, int> output_of(const std::string &command)
    {
      const std::string with_reason =
        "exec 3>&1; errors=$(" + command +
        " 2>&1 >&3) || { code=$?; printf '\\n%s\\n' \"$errors\" | tail -n 2; "
        "exit $code; }";
      FILE *stream = popen(with_reason.c_str(), "r");
      if (stream == nullptr)
        return {"", -1};
      std::string text;
      char part[512];
      while (std::fgets(part, sizeof(part), stream) != nullptr)
        text += part;
      return {text, pclose(stream)};
    }

    std::string last_line(const std::string &text)
    {
      std::string last;
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);)
        last = line;
      return last;
    }

    /// Why a command failed that printed @p text and ended with @p status.
    std::string failure_of(const std::string &text, const int status)
    {
      constexpr int first_signal = 128; // of exit codes of a shell
      const int ended_by = WIFSIGNALED(status)
                             ? WTERMSIG(status)
                             : WEXITSTATUS(status) - first_signal;
      if (const int asked = SignalGuard::stop_signal(); asked != 0)
        return Stopped(asked).what();
      return ended_by > 0 ? "ended by signal " + std::to_string(ended_by)
                          : last_line(text);
    }

    /// Lines that begin with two spaces: the first paragraphs that a screen has
    /// room for. Further lines of a paragraph begin with more spaces.
    std::vector<std::string> answer_of(const std::string &printed)
    {
      constexpr std::size_t most_lines = 10;
      std::vector<std::string> answer;
      std::size_t n_whole = 0;
      std::istringstream lines(printed);
      for (std::string line; std::getline(lines, line);)
      {
        if (line.compare(0, 2, "  ") != 0)
          continue;
        if (line.compare(0, 3, "   ") != 0)
          n_whole = answer.size();
        if (answer.size() == most_lines)
        {
          answer.resize(n_whole);
          return answer;
        }
        answer.push_back(line);
      }
      return answer;
    }
  } // namespace

  std::string plot_program()
  {
    // Where the library is installed, whichever program uses it.
    Dl_info library;
    static const char inside = 0;
    if (dladdr(&inside, &library) != 0)
    {
      namespace fs = std::filesystem;
      std::error_code ignored;
      fs::path folder = fs::canonical(library.dli_fname, ignored);
      while (folder.has_relative_path())
      {
        folder = folder.parent_path();
        if (fs::exists(folder / CONTRECOUP_INSTALLED_PLOT, ignored))
          return (folder / CONTRECOUP_INSTALLED_PLOT).string();
      }
    }
    return CONTRECOUP_SOURCE_PLOT;
  }

  bool draw(const std::string &picture_command,
            const std::string &folder,
            const std::string &what,
            const std::string &where)
  {
    Log::instance().status("drawing the " + what);
    const std::string program =
      shell_word(plot_program()) + " " + picture_command;
    const auto [printed, status] =
      output_of(program + " " + shell_word(folder));
    const bool works = status == 0;
    for (const std::string &line : answer_of(printed))
      show_line(line);
    show_line(works ? what + " in " + folder + "/" + where
                    : "WARNING: no " + what + ": " + program +
                        " failed: " + failure_of(printed, status));
    return works;
  }
} // namespace io
} // namespace contrecoup
