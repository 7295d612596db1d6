// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_mesh.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Face areas and volumes of the subcells of one batch of leaves of any shape.
 *
 * A leaf is the image of the unit cube under the multilinear map of its
 * vertices. Its n subcells per direction are equal in the unit cube; their
 * faces are bilinear surfaces. Area vectors and volumes are exact, and the
 * area vectors of a subcell sum to zero, so that the scheme preserves a
 * uniform flow.
 *
 * Each direction has layers f = 0 to n of faces; within its layer, a face is
 * numbered like the points of a leaf face, see LeafLayout.
 */
template <int dim>
class LeafMetric
{
public:
  using Number = Lanes<double>;
  using Vector = dealii::Tensor<1, dim, Number>;

  /// @param n subcells per direction
  explicit LeafMetric(const unsigned int n);

  /// Computes areas, centres and volumes for the leaves of @p batch; padding
  /// lanes repeat the last leaf.
  void reinit(const LeafMesh<dim> &mesh, const unsigned int batch);

  /// Area vector of a face [m^(dim-1)], in the direction of increasing index.
  const Vector &area(const unsigned int direction,
                     const unsigned int layer,
                     const unsigned int line) const
  {
    return areas_[face(direction, layer, line)];
  }

  /// Centre of a face [m].
  const Vector &face_center(const unsigned int direction,
                            const unsigned int layer,
                            const unsigned int line) const
  {
    return centers_[face(direction, layer, line)];
  }

  /// Unit tangent of a face along the other direction @p along of the leaf.
  Vector tangent(const unsigned int direction,
                 const unsigned int layer,
                 const unsigned int line,
                 const unsigned int along) const;

  /// Volume of the subcell of a point [m^dim].
  const Number &volume(const unsigned int point) const
  {
    return volumes_[point];
  }

protected:
  /// @param corners boundaries of the subcells along an edge of the unit cube,
  /// from 0 to 1
  explicit LeafMetric(const std::vector<double> &corners);

  unsigned int face(const unsigned int direction,
                    const unsigned int layer,
                    const unsigned int line) const
  {
    return (direction * (n_ + 1) + layer) * n_face_points_ + line;
  }

  /// Computes the vertices and the grid of subcell corners.
  void place_nodes(const LeafMesh<dim> &mesh, const unsigned int batch);

  /// Position of the reference coordinates @p x, relative to vertex 0 [m].
  Vector place(const std::array<double, dim> &x) const;

  dealii::AlignedVector<Vector> areas_;   ///< see face()
  dealii::AlignedVector<Vector> centers_; ///< see face()
  dealii::AlignedVector<Number> volumes_;
  Vector origin_; ///< vertex 0 of each leaf

private:
  /// Index in nodes_ of the lowest corner of a face.
  unsigned int first_node(const unsigned int direction,
                          const unsigned int layer,
                          const unsigned int line) const;

  void measure_face(const unsigned int direction,
                    const unsigned int layer,
                    const unsigned int line);
  void measure_volumes();

  std::vector<double> corners_;
  unsigned int n_;
  unsigned int n_face_points_;
  std::array<unsigned int, dim> node_stride_;
  std::array<Vector, 1U << dim> vertices_; ///< relative to vertex 0
  /// Subcell corners, relative to vertex 0
  dealii::AlignedVector<Vector> nodes_;
};
} // namespace contrecoup::gas
