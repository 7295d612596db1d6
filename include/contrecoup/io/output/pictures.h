// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
namespace io
{
  /// Path of plot.py: of the installation to which the running application
  /// belongs, else of the source.
  std::string plot_program();

  /**
   * Runs applications/plot/plot.py on an output folder, and logs where its
   * pictures are, or that it failed, with the last line of its errors or the
   * signal: failure does not affect results. For one rank.
   * @param picture_command command of plot.py, e.g. "run", called with @p
   *   folder
   * @param what the command draws, e.g. "pictures"
   * @param where the files are in the folder
   * @return whether it succeeded
   */
  bool draw(const std::string &picture_command,
            const std::string &folder,
            const std::string &what,
            const std::string &where);
} // namespace io
} // namespace contrecoup
