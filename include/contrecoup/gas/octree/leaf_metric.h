// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_mesh.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Areas and volumes of the subcells of one batch of leaves of any shape.
 *
 * A leaf is the image of the unit cube under the multilinear map of its
 * vertices; its n subcells a side are those of equal edges in the cube, so
 * that their faces are bilinear surfaces. Area vectors and volumes of these
 * are exact, and the areas around a subcell add up to zero: what flows
 * uniformly goes on so.
 *
 * Layers f = 0 to n of faces stand across each direction; a face is numbered
 * within its layer like the points of a leaf face, see LeafLayout.
 */
template <int dim>
class LeafMetric
{
public:
  using Number = Lanes<double>;
  using Vector = dealii::Tensor<1, dim, Number>;

  /// @param n subcells a side
  explicit LeafMetric(const unsigned int n);

  /// Computes everything for the leaves of @p batch; padding lanes repeat
  /// the last leaf.
  void reinit(const LeafMesh<dim> &mesh, const unsigned int batch);

  /// Area vector of a face [m^(dim-1)], towards increasing index.
  const Vector &area(const unsigned int direction,
                     const unsigned int layer,
                     const unsigned int line) const
  {
    return areas_[face(direction, layer, line)];
  }

  /// Place of the middle of a face [m].
  const Vector &face_center(const unsigned int direction,
                            const unsigned int layer,
                            const unsigned int line) const
  {
    return centers_[face(direction, layer, line)];
  }

  /// Unit vector in a face along another direction @p along of the leaf.
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
  /// @param corners ends of the subcells along an edge of the cube, from 0
  /// to 1
  explicit LeafMetric(const std::vector<double> &corners);

  unsigned int face(const unsigned int direction,
                    const unsigned int layer,
                    const unsigned int line) const
  {
    return (direction * (n_ + 1) + layer) * n_face_points_ + line;
  }

  /// Vertices and the grid of subcell corners.
  void place_nodes(const LeafMesh<dim> &mesh, const unsigned int batch);

  /// Where the place @p x in the unit cube is, from vertex 0 [m].
  Vector place(const std::array<double, dim> &x) const;

  dealii::AlignedVector<Vector> areas_;   ///< see face()
  dealii::AlignedVector<Vector> centers_; ///< see face()
  dealii::AlignedVector<Number> volumes_;
  Vector origin_; ///< vertex 0 of each leaf

private:
  /// Node of the grid of subcell corners at the low end of a face.
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
  dealii::AlignedVector<Vector> nodes_;    ///< likewise
};
} // namespace contrecoup::gas
