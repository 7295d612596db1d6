// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
namespace io
{
  /**
   * Has applications/plot/plot.py draw what a run left in its output folder,
   * and logs where that is, or that it failed: results stand without their
   * pictures. For one rank.
   * @param picture_command e.g. "run", which is given @p folder
   * @param what it makes, e.g. "pictures"
   * @param where in the folder they are then
   */
  void draw(const std::string &picture_command,
            const std::string &folder,
            const std::string &what,
            const std::string &where);
} // namespace io
} // namespace contrecoup
