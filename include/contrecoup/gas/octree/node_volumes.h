// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_box.h>

namespace contrecoup::gas
{
/// Integrals of the shape functions of a Galerkin leaf that is no box: what
/// its nodes stand for [m^dim].
template <int dim>
std::vector<double> node_volumes(const LeafBox<dim> &box,
                                 const LeafPoints<dim> &points);
} // namespace contrecoup::gas
