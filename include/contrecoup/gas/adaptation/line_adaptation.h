// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_mesh.h>

namespace contrecoup::gas
{
// deal.II's 1-D triangulations do not balance the levels of neighbours, as
// p4est does in 2-D and 3-D.

/// Corrects the refinement flags so that neighbours differ by one level at most
/// and siblings are coarsened together.
void balance_line(LeafMesh<1> &mesh);
} // namespace contrecoup::gas
