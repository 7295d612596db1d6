// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <fstream>
#include <string>

namespace contrecoup
{
/**
 * What a run tells its user: lines on the screen and in log.txt, and one
 * redrawn status line on a terminal. Silent on all ranks but the first.
 */
class Log
{
public:
  /// The log of this process.
  static Log &instance();

  /// Switches the screen on or off; off on all ranks but the first.
  void set_active(bool active);

  /// Writes all lines since the last close() and all further ones into
  /// @p file as well, if active. @throws SystemError when it cannot be opened.
  void open(const std::string &file, bool append);

  /// Ends the file and the status line.
  void close();

  /// Writes a line. Never throws: see check().
  void line(const std::string &text);

  /// @throws SystemError when a line could not be written (disk full).
  void check() const;

  /// Redraws the status line; does nothing unless on_terminal().
  void status(const std::string &text);

  /// Whether the screen is a terminal that can redraw a line.
  bool on_terminal() const;

private:
  Log();
  void clear_status();

  std::ofstream file_;
  std::string held_;
  bool active_ = true;
  bool terminal_ = false;
  bool status_shown_ = false;
};

/// Short for Log::instance().line().
void log_line(const std::string &text);
} // namespace contrecoup
