// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/log_words.h>
#include <contrecoup/base/system/text.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <utility>

namespace contrecoup
{
namespace
{
  /// Number of letters that a line of the terminal holds; large if unknown.
  std::size_t terminal_width()
  {
    winsize size = {};
    return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0
             ? size.ws_col
             : std::string::npos;
  }
} // namespace

// Under mpirun, stdout of the ranks is a terminal even if mpirun's own stdout
// is a file, but stderr never is.
Log::Log()
  : terminal_(isatty(STDOUT_FILENO) != 0 && isatty(STDERR_FILENO) != 0)
{}

Log &Log::instance()
{
  static Log log;
  return log;
}

void Log::set_active(const bool active)
{
  active_ = active;
}

void Log::open(const std::string &file, const bool append)
{
  if (!active_)
    return;
  std::ofstream stream(file, append ? std::ios::app : std::ios::trunc);
  if (!stream)
    throw SystemError("cannot write \"" + file + "\"");
  stream << held_ << std::flush;
  held_.clear();
  files_.push_back(std::move(stream));
}

void Log::close()
{
  clear_status();
  files_.resize(n_kept_);
  held_.clear();
  warnings_.clear();
  if (!in_part_)
    shown_warnings_.clear();
}

void Log::begin_part(const std::string &name, const bool quiet)
{
  part_name_ = name.empty() ? "" : name + ": ";
  in_part_ = true;
  part_is_quiet_ = quiet;
  n_kept_ = files_.size();
  held_.clear();
  warnings_.clear();
}

void Log::end_part()
{
  close();
  n_kept_ = 0;
  part_name_.clear();
  in_part_ = false;
  part_is_quiet_ = false;
}

bool Log::is_in_part() const
{
  return in_part_;
}

void Log::set_verbose(const bool verbose)
{
  verbose_ = verbose;
}

bool Log::is_verbose() const
{
  return verbose_;
}

bool Log::note_warning(const std::string &text)
{
  static const std::string mark = "WARNING: ";
  const std::string words = trim(text);
  if (!active_ || words.compare(0, mark.size(), mark) != 0)
    return false;
  const std::string warning = LogWords::of(words).substr(mark.size());
  if (std::find(warnings_.begin(), warnings_.end(), warning) == warnings_.end())
    warnings_.push_back(warning);
  return !part_is_quiet_ && shown_warnings_.insert(warning).second;
}

void Log::line(const std::string &text)
{
  const bool is_new_warning = note_warning(text);
  write(text, verbose_ || is_new_warning);
}

void Log::show(const std::string &text)
{
  const bool is_new_warning = note_warning(text);
  write(text, verbose_ || is_new_warning || !in_part_);
}

void Log::take_back(const std::string &text)
{
  write(text, verbose_ || !part_is_quiet_);
}

void Log::progress(const std::string &text)
{
  if (!active_)
    return;
  clear_status();
  std::cout << part_name_ << text << std::endl;
}

void Log::write(const std::string &line, const bool on_screen)
{
  if (!active_)
    return;
  const std::string text = LogWords::of(line);
  if (on_screen)
  {
    clear_status();
    std::cout << text << std::endl;
  }
  for (std::ofstream &file : files_)
    file << text << std::endl;
  if (files_.size() == n_kept_)
    held_ += text + '\n';
}

void Log::check() const
{
  for (const std::ofstream &file : files_)
    if (!file)
      throw SystemError("cannot write log.txt: is the disk full?");
}

void Log::status(const std::string &text)
{
  if (!active_ || !terminal_)
    return;
  std::cout << "\r\033[K" << (part_name_ + text).substr(0, terminal_width() - 1)
            << std::flush;
  status_shown_ = true;
}

bool Log::on_terminal() const
{
  return terminal_;
}

void Log::clear_status()
{
  if (status_shown_)
    std::cout << "\r\033[K" << std::flush;
  status_shown_ = false;
}

void log_line(const std::string &text)
{
  Log::instance().line(text);
}

void show_line(const std::string &text)
{
  Log::instance().show(text);
}
} // namespace contrecoup
