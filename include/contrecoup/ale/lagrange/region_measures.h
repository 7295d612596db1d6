// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/run/simulation.h>

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
 * Measures of each region for history.csv: smallest and largest pressure; of a
 * solid, largest shear strain and mean velocity; of a fluid, largest speed; of
 * a liquid, cavitated volume. Names end with that of the region. Collective.
 * @param regions by material id
 * @param extremes of each region, of all ranks
 */
std::vector<NamedValue>
region_measures(const HexSpace &space,
                const AleState &state,
                const std::vector<Region> &regions,
                const std::vector<RegionExtremes> &extremes);
} // namespace contrecoup::ale
