// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/octree/leaf_points.h>

#include <vector>

namespace contrecoup::gas
{
/// The shape of a leaf: a box, or the multilinear image of the unit cube.
template <int dim>
struct LeafBox
{
  /// Corner of smallest coordinates of the leaf or the box around it [m].
  dealii::Point<dim> origin;
  dealii::Tensor<1, dim> extents; ///< edge lengths of that box [m]
  /// Vertices, in deal.II's order, of a leaf that is no box; else empty [m].
  std::vector<dealii::Point<dim>> vertices;

  bool is_box() const
  {
    return vertices.empty();
  }

  /// The place at relative coordinates @p x.
  dealii::Point<dim> place(const dealii::Point<dim> &x) const;

  /// Volume of the leaf per volume of relative coordinates at @p x [m^dim].
  double jacobian(const dealii::Point<dim> &x) const;
};

/// Volume of the gas that point @p q of a leaf stands for; see
/// LeafPoints::volume().
template <int dim>
double point_volume(const LeafBox<dim> &box,
                    const LeafPoints<dim> &points,
                    const unsigned int q);

/// The shape of a leaf of the mesh; an axis-aligned mesh has boxes.
template <int dim>
LeafBox<dim> leaf_box(const LeafMesh<dim> &mesh, const unsigned int leaf);
} // namespace contrecoup::gas
