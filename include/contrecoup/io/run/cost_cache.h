// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>

#include <optional>
#include <string>

namespace contrecoup
{
namespace io
{
  /// A cost by trial runs, and what they tell of its steps.
  struct TriedCost : CostEstimate
  {
    /// Whether the last trial was the run itself.
    bool is_exact = false;
    /// Largest ratio of the steps of the last two trials to those that their
    /// first step would need, as deformed elements allow smaller ones only [-].
    double step_growth = 1.;
  };

  /**
   * Cache of measured costs of scenes, one small file each, in
   * $XDG_CACHE_HOME/contrecoup or ~/.cache/contrecoup. Without such a folder
   * nothing is cached. For use by one rank.
   */
  class CostCache
  {
  public:
    /// @param scene everything that determines the cost except machine and
    /// build: entries as used, number of ranks
    explicit CostCache(const std::string &scene);

    /// Cached cost for this scene, processor and build.
    std::optional<TriedCost> read() const;

    /// Stores @p cost; never throws.
    void write(const TriedCost &cost) const noexcept;

    /// File of the cache entry; empty: none.
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
