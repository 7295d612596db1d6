// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>

#include <optional>
#include <string>

namespace contrecoup
{
namespace io
{
  /**
   * Keeps what scenes were found to cost for the next time that is asked, in
   * $XDG_CACHE_HOME/contrecoup or ~/.cache/contrecoup, one small file each.
   * Without such a folder nothing is kept. To be called by one rank.
   */
  class CostCache
  {
  public:
    /// @param scene everything that the cost depends on besides the machine
    ///   and the build: the entries as used, the number of ranks
    explicit CostCache(const std::string &scene);

    /// What was kept for this scene, processor and build.
    std::optional<CostEstimate> read() const;

    /// Keeps @p cost; never throws.
    void write(const CostEstimate &cost) const noexcept;

    /// Where; empty: nowhere.
    const std::string &file() const
    {
      return file_;
    }

  private:
    std::string key_;
    std::string file_;
  };
} // namespace io
} // namespace contrecoup
