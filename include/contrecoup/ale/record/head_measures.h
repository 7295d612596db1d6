// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/record/ale_recorder.h>
#include <contrecoup/ale/record/head_recorder.h>
#include <contrecoup/solid/body/nodal_average.h>

#include <vector>

namespace contrecoup::ale
{
/// Records the injury measures of a head on a moving mesh.
class HeadMeasures : public HeadRecorder<AleSnapshot>
{
public:
  /// Selects the cells of the undeformed mesh, after find().
  void reinit(const AleSnapshot &now) override;
  void record(const AleSnapshot &now) override;

private:
  void follow_brain(const LagrangeStep &lagrange, const AleState &state);
  void follow_motion(const HexSpace &space, const AleState &state);

  std::vector<std::uint32_t> cells_; ///< locally owned cells of the brain
  std::vector<double> heights_; ///< of their centres over that of the brain [m]
  solid::NodalAverage average_; ///< over cells_
};
} // namespace contrecoup::ale
