// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/leaf_carrier.h>

#include <functional>

namespace contrecoup::gas
{
// deal.II's 1-D triangulations neither balance the levels of neighbours nor
// transfer data, as p4est does in 2-D and 3-D.

/// Corrects the refinement flags so that neighbours differ by one level at most
/// and siblings are coarsened together.
void balance_line(LeafMesh<1> &mesh);

/// Refines and coarsens leaves as flagged, and transfers their data.
/// @param resize_field_and_maps resizes field and maps for the new octree
void adapt_line(LeafMesh<1> &mesh,
                const LeafCarrier<1> &carrier,
                const std::function<void()> &resize_field_and_maps);
} // namespace contrecoup::gas
