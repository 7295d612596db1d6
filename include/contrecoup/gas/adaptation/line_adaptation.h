// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/leaf_carrier.h>

#include <functional>

namespace contrecoup::gas
{
// deal.II's own meshes in 1-D neither bound the levels of neighbours nor
// carry data over, as p4est does in 2-D and 3-D.

/// Changes the flags of leaves so that neighbours stay within one level and
/// siblings merge together.
void balance_line(LeafMesh<1> &mesh);

/// Halves and merges leaves as flagged, and carries their data over.
/// @param make_room makes field and maps fit for the new octree
void adapt_line(LeafMesh<1> &mesh,
                const LeafCarrier<1> &carrier,
                const std::function<void()> &make_room);
} // namespace contrecoup::gas
