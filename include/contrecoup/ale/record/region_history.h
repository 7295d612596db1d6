// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/record/ale_recorder.h>

namespace contrecoup::ale
{
/// Extremes of each region in the cells of this rank; those of regions that are
/// left out are empty.
/// @param regions by material id
std::vector<RegionExtremes> region_extremes(const HexSpace &space,
                                            const LagrangeStep &lagrange,
                                            const AleState &state,
                                            const std::vector<Region> &regions,
                                            const bool with_solids = true);

/**
 * Records measures of each region for history.csv: smallest and largest
 * pressure; of a solid, largest shear strain and mean velocity; of a fluid,
 * largest speed; of a liquid, cavitated volume. Names end with that of the
 * region.
 */
class RegionHistory : public AleRecorder
{
public:
  void reinit(const AleSnapshot &now) override
  {
    extremes_.reinit(now.regions.size(), now.communicator);
  }
  void record_rezoned(const AleSnapshot &now) override;
  std::vector<NamedValue> history(const AleSnapshot &now) override;

  const ExtremeRecord &extremes() const
  {
    return extremes_;
  }

  void save(io::StateWriter &out) const override
  {
    extremes_.save(out);
  }
  void restore(const AleSnapshot & /*now*/, io::StateReader &in) override
  {
    extremes_.restore(in);
  }

private:
  ExtremeRecord extremes_;
};
} // namespace contrecoup::ale
