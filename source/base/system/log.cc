// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/log_words.h>

#include <unistd.h>

#include <iostream>
#include <utility>

namespace contrecoup
{
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
}

void Log::begin_part()
{
  n_kept_ = files_.size();
  held_.clear();
}

void Log::end_part()
{
  close();
  n_kept_ = 0;
}

void Log::line(const std::string &line)
{
  if (!active_)
    return;
  const std::string text = LogWords::of(line);
  clear_status();
  std::cout << text << std::endl;
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
  std::cout << "\r\033[K" << text << std::flush;
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
} // namespace contrecoup
