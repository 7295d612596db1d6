// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/gas/adaptation/adaptation_parameters.h>
#include <contrecoup/gas/scene/gas_scene.h>

namespace contrecoup::gas
{
/// |u| + c [m/s].
template <int dim>
double signal_speed(const GasState<dim> &state, const GasMaterial &material);

/**
 * Predicts the cost of a run of @p scene on @p n_ranks ranks without building
 * its mesh: from the number of leaves after initial refinement and at the body,
 * the largest signal rate in the initial state, and the throughput of a typical
 * core.
 * @param has_maps whether each point has a BlastRecord
 */
template <int dim>
CostEstimate estimate_cost(const GasScene<dim> &scene,
                           const AdaptationParameters &adaptation,
                           const bool has_maps,
                           const unsigned int n_ranks);
} // namespace contrecoup::gas
