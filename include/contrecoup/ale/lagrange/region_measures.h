// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/simulation.h>

namespace contrecoup::ale
{
/**
 * What is found in each region, for history.csv: least and largest pressure,
 * the largest shear strain and the mean velocity of a solid, the largest speed
 * in a fluid and the volume that a liquid has cavitated; names end with that of
 * the region. Collective.
 * @param regions by material id
 */
std::vector<NamedValue> region_measures(const HexSpace &space,
                                        const LagrangeStep &lagrange,
                                        const AleState &state,
                                        const std::vector<Region> &regions);
} // namespace contrecoup::ale
