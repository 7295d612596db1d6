// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace contrecoup
{
/// Output for the user. log.txt gets every line; the screen gets each warning
/// once, the lines of show() and take_back(), all lines if verbose, and on a
/// terminal one redrawn status line. A warning is a line that begins with
/// "WARNING: ". Silent on all ranks except the first.
class Log
{
public:
  /// The log of this process.
  static Log &instance();

  /// Switches output on or off; off on all ranks except the first.
  void set_active(bool active);

  /// If active, writes all lines since the last close() and all further ones
  /// to @p file as well. @throws SystemError when it cannot be opened
  void open(const std::string &file, bool append);

  /// Closes the files opened since the last begin_part(), or all of them, and
  /// ends the status line.
  void close();

  /// Begins and ends a part of the run that opens a log file of its own: the
  /// open files stay open alongside. Lines that a part shows are details of the
  /// whole, and so are its warnings if it is @p quiet. Parts are not nested.
  /// See LogPart.
  /// @param name precedes lines of progress
  void begin_part(const std::string &name, bool quiet);
  void end_part();

  bool is_in_part() const;

  /// Whether the screen gets all lines. True from the start.
  void set_verbose(bool verbose);
  bool is_verbose() const;

  /// Writes a line of detail, or a warning. Never throws; see check().
  void line(const std::string &text);

  /// Writes a line that the screen gets, unless it is one of a part. Never
  /// throws; see check().
  void show(const std::string &text);

  /// Writes a line that takes back a warning of before: the screen gets it as
  /// it got the warning. Never throws; see check().
  void take_back(const std::string &text);

  /// Writes a line of progress on the screen alone.
  void progress(const std::string &text);

  /// Warnings since the last close(), begin_part() or end_part(), in order,
  /// without "WARNING: " and each once; empty where not active.
  const std::vector<std::string> &warnings() const
  {
    return warnings_;
  }

  /// @throws SystemError when a line could not be written (disk full)
  void check() const;

  /// Redraws the status line, cut at the width of the terminal; no effect
  /// unless on_terminal().
  void status(const std::string &text);

  /// Whether the screen is a terminal on which a line can be redrawn.
  bool on_terminal() const;

private:
  Log();
  void clear_status();
  bool note_warning(const std::string &text);
  void write(const std::string &text, bool on_screen);

  std::vector<std::ofstream> files_;
  std::size_t n_kept_ = 0; ///< first files that close() leaves open
  std::string held_;       ///< lines for the file that is opened next
  std::vector<std::string> warnings_;
  std::set<std::string> shown_warnings_; ///< by this process, on the screen
  std::string part_name_;
  bool in_part_ = false;
  bool part_is_quiet_ = false;
  bool active_ = true;
  bool verbose_ = true;
  bool terminal_ = false;
  bool status_shown_ = false;
};

/// A part of the run, see Log::begin_part(), while this object exists.
class LogPart
{
public:
  explicit LogPart(const std::string &name = "", const bool quiet = false)
  {
    Log::instance().begin_part(name, quiet);
  }
  ~LogPart()
  {
    Log::instance().end_part();
  }
  LogPart(const LogPart &) = delete;
  LogPart &operator=(const LogPart &) = delete;
};

/// Short for Log::instance().line().
void log_line(const std::string &text);

/// Short for Log::instance().show().
void show_line(const std::string &text);
} // namespace contrecoup
