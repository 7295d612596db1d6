// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/boundary.h>
#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/octree/scheme.h>

namespace contrecoup::gas
{
template <int dim>
class CutLeaves;

/// The parts of a problem that operators and their kernels read; they must
/// outlive them.
template <int dim>
struct OperatorContext
{
  const LeafMesh<dim> &mesh;
  const LeafLayout layout;
  const Scheme &scheme;
  const Boundary<dim> &boundary;
  const CutLeaves<dim> *cut_leaves = nullptr; ///< null: there is no body
};
} // namespace contrecoup::gas
