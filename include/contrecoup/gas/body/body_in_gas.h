// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/cut_leaves.h>
#include <contrecoup/gas/scene/gas_scene.h>
#include <contrecoup/gas/state/gas_field.h>

namespace contrecoup::gas
{
/// The rigid body of a scene in its mesh: the leaves that it cuts, the volume
/// that it takes up, and what its cells hold. Scenes without a body have an
/// empty one, with which nothing happens.
template <int dim>
class BodyInGas
{
public:
  /// Keeps references to scene and mesh.
  BodyInGas(const GasScene<dim> &scene, const LeafMesh<dim> &mesh)
    : scene_(scene)
    , mesh_(mesh)
  {}

  bool empty() const
  {
    return scene_.body.empty();
  }

  /// Finds the leaves that the body cuts. Call when the mesh changed.
  /// Collective.
  void mesh_changed();

  const CutLeaves<dim> &cut_leaves() const
  {
    return cut_leaves_;
  }

  /// Volume of the domain without gas [m^dim]. Collective.
  double volume() const;

  /// Gives gas at rest to the cells of @p field without gas. Collective.
  /// @throws InputError when the body leaves no gas, lies outside of the
  /// domain, or in a charge.
  void fill_closed_cells(GasField &field) const;

private:
  const GasScene<dim> &scene_;
  const LeafMesh<dim> &mesh_;
  CutLeaves<dim> cut_leaves_; ///< unused without a body
};
} // namespace contrecoup::gas
