// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/octree/leaf_points.h>

#include <vector>

namespace contrecoup::gas
{
/// Shape of a leaf: an axis-aligned box, the multilinear image of the unit
/// cube, or that by a polynomial of CurvedShapes.
template <int dim>
struct LeafBox
{
  /// Lower corner of the leaf or of its bounding box [m].
  dealii::Point<dim> origin;
  dealii::Tensor<1, dim> extents; ///< edge lengths of leaf or bounding box [m]
  /// Vertices in deal.II's order [m]; empty for an axis-aligned box.
  std::vector<dealii::Point<dim>> vertices;
  const CurvedShapes<dim> *curved_shapes = nullptr; ///< if not multilinear
  unsigned int cell = 0; ///< active cell, for curved_shapes

  bool is_box() const
  {
    return vertices.empty();
  }

  /// Position at reference coordinates @p x [m].
  dealii::Point<dim> place(const dealii::Point<dim> &x) const;

  /// Determinant of the Jacobian of the map from the unit cube at @p x
  /// [m^dim].
  double jacobian(const dealii::Point<dim> &x) const;
};

/// Volume of point @p q of a leaf; see LeafPoints::volume().
template <int dim>
double point_volume(const LeafBox<dim> &box,
                    const LeafPoints<dim> &points,
                    const unsigned int q);

/// Shape of a leaf; a box on axis-aligned meshes.
template <int dim>
LeafBox<dim> leaf_box(const LeafMesh<dim> &mesh, const unsigned int leaf);

/// Area vector out of an owned or ghost leaf, whatever its shape; see
/// outward_area() in leaf_face.h.
template <int dim>
dealii::Tensor<1, dim> outward_area(const LeafMesh<dim> &mesh,
                                    const unsigned int leaf,
                                    const unsigned int face,
                                    const double a,
                                    const double b);
} // namespace contrecoup::gas
