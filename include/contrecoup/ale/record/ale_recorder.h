// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/ale/record/impact_recorder.h>

#include <cstdint>
#include <vector>

namespace contrecoup::ale
{
/// State of a moving mesh at the end of a time step, as passed to the
/// recorders.
struct AleSnapshot : ImpactSnapshot
{
  const HexSpace &space;
  const LagrangeStep &lagrange;
  const AleState &state;
  const std::vector<Region> &regions; ///< by material id
  /// Cell of each probe on the rank that owns the cell, elsewhere
  /// HexSpace::no_cell.
  const std::vector<std::uint32_t> &probe_cells;
  /// Whether the state is unchanged since the last Lagrangian step.
  bool forces_are_current = false;
};

using AleRecorder = ImpactRecorder<AleSnapshot>;
} // namespace contrecoup::ale
