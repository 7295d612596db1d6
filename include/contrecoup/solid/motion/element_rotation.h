// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/node_fields.h>
#include <contrecoup/solid/body/solid_mesh.h>

namespace contrecoup::solid
{
/// Largest angle by which an element has turned [rad], from the antisymmetric
/// part of its mean displacement gradient: for small angles. Collective.
template <typename Real>
double largest_rotation(const SolidMesh &mesh,
                        const NodeFields<Real> &nodes,
                        MPI_Comm communicator);
} // namespace contrecoup::solid
