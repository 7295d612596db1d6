// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/shape.h>
#include <contrecoup/geometry/shape/triangle_mesh.h>

#include <array>
#include <cstdint>
#include <vector>

namespace contrecoup
{
/**
 * A solid bounded by triangles. The distance is exact. A point is inside where
 * the generalised winding number exceeds 1/2 (Jacobson, Kavan and
 * Sorkine-Hornung 2013), evaluated in a tree with a dipole as far field of
 * each node (Barill et al. 2018, first order). Pieces may thus overlap and
 * intersect. At missing triangles the value jumps, therefore repair() closes
 * holes.
 */
class TriangulatedSurface : public Shape
{
public:
  /// @param mesh at least one triangle, each with positive area
  explicit TriangulatedSurface(TriangleMesh mesh);

  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;
  double reach(const dealii::Tensor<1, 3> &direction) const override;

  /// Winding number of the surface around a point: 1 inside and 0 outside of a
  /// closed, outward oriented surface.
  double winding_number(const dealii::Point<3> &point) const;

  const TriangleMesh &mesh() const
  {
    return mesh_;
  }

private:
  /// A tree node; its children are the next node and `second`.
  struct Node
  {
    dealii::Point<3> lower;
    dealii::Point<3> upper;
    std::uint32_t begin; ///< range of triangles of a leaf
    std::uint32_t end;   ///< 0 for an inner node
    std::uint32_t second;
    dealii::Point<3> center;   ///< area-weighted
    dealii::Tensor<1, 3> area; ///< sum of the area vectors [m^2]
    double radius;             ///< of the ball around `center` [m]
  };

  /// The nearest point on the surface.
  struct Nearest
  {
    double square; ///< squared distance [m^2]
    dealii::Point<3> place;
    std::uint32_t triangle;
  };

  void build(std::uint32_t begin, std::uint32_t end);
  Node summarise(std::uint32_t begin, std::uint32_t end) const;
  Nearest nearest(const dealii::Point<3> &point) const;
  bool is_inside(const dealii::Point<3> &point) const;

  TriangleMesh mesh_; ///< sorted in the order of the tree
  std::vector<Node> nodes_;
};
} // namespace contrecoup
