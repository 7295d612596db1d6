// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/head/head_record.h>
#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/solid/body/nodal_average.h>

#include <vector>

namespace contrecoup::ale
{
/// Records the injury measures of a head on a moving mesh.
class HeadMeasures : public HeadRecord
{
public:
  /// Selects the cells of the undeformed mesh, after find(). Collective.
  void reinit(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state);

  /// Call before the first step and after each step. Collective.
  void follow(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state);

private:
  void follow_brain(const LagrangeStep &lagrange, const AleState &state);
  void follow_motion(const HexSpace &space, const AleState &state);

  std::vector<std::uint32_t> cells_; ///< locally owned cells of the brain
  std::vector<double> heights_; ///< of their centres over that of the brain [m]
  solid::NodalAverage average_; ///< over cells_
};
} // namespace contrecoup::ale
