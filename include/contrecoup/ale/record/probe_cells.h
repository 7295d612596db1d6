// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/record/ale_recorder.h>

namespace contrecoup::ale
{
/// Finds the cells that the probes are in at the start, and reads them.
class ProbeCells : public AleRecorder
{
public:
  void reinit(const AleSnapshot &now) override;

  /// As AleSnapshot::probe_cells.
  const std::vector<std::uint32_t> &cells() const
  {
    return cells_;
  }

  /// Pressure and density at each probe.
  std::vector<NamedValue> values(const AleSnapshot &now) const;

private:
  std::vector<std::uint32_t> cells_;
};
} // namespace contrecoup::ale
