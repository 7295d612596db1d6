// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/run/simulation.h>

namespace contrecoup::ale
{
/**
 * Measures of each region for history.csv: smallest and largest pressure; of a
 * solid, largest shear strain and mean velocity; of a fluid, largest speed; of
 * a liquid, cavitated volume. Names end with that of the region. Collective.
 * @param regions by material id
 */
std::vector<NamedValue> region_measures(const HexSpace &space,
                                        const LagrangeStep &lagrange,
                                        const AleState &state,
                                        const std::vector<Region> &regions);
} // namespace contrecoup::ale
