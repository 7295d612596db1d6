// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape.h>
#include <contrecoup/geometry/triangle_mesh.h>

#include <array>
#include <cstdint>
#include <vector>

namespace contrecoup
{
/**
 * A solid bounded by triangles. The distance is exact; inside is where the
 * generalised winding number (Jacobson, Kavan and Sorkine-Hornung 2013) is
 * above 1/2, evaluated in a tree with the far field of each node as a dipole
 * (Barill et al. 2018, first order). So pieces may overlap and pass through
 * each other; where triangles are missing the value jumps, and repair() closes
 * holes for that reason.
 */
class TriangulatedSurface : public Shape
{
public:
  /// @param mesh at least one triangle, all with an area
  explicit TriangulatedSurface(TriangleMesh mesh);

  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  dealii::BoundingBox<3> bounding_box() const override;

  /// Times that the surface goes around a point: 1 inside, 0 outside of one
  /// that is closed and looks outwards.
  double winding_number(const dealii::Point<3> &point) const;

  const TriangleMesh &mesh() const
  {
    return mesh_;
  }

private:
  /// A box of triangles; its children are the next node and `second`.
  struct Node
  {
    dealii::Point<3> lower;
    dealii::Point<3> upper;
    std::uint32_t begin; ///< triangles of a leaf
    std::uint32_t end;   ///< 0 for an inner node
    std::uint32_t second;
    dealii::Point<3> center;   ///< of the area
    dealii::Tensor<1, 3> area; ///< sum of the area vectors [m^2]
    double radius;             ///< of the ball around center [m]
  };

  /// The nearest point of the triangles.
  struct Nearest
  {
    double square; ///< of the distance [m^2]
    dealii::Point<3> place;
    std::uint32_t triangle;
  };

  void build(std::uint32_t begin, std::uint32_t end);
  Node summarise(std::uint32_t begin, std::uint32_t end) const;
  Nearest nearest(const dealii::Point<3> &point) const;
  bool is_inside(const dealii::Point<3> &point) const;

  TriangleMesh mesh_; ///< triangles in the order of the tree
  std::vector<Node> nodes_;
};
} // namespace contrecoup
