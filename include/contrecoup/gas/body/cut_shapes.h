// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/leaf_shape.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/state/open_fractions.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <unordered_map>
#include <vector>

namespace contrecoup::gas
{
/// A subcell of a stored leaf.
struct Subcell
{
  unsigned int leaf = no_leaf;
  unsigned int point = 0;
  /// Its whole volume over that of a neighbourhood's first cell [-].
  double size = 1.;

  friend bool operator<(const Subcell &a, const Subcell &b)
  {
    return a.leaf != b.leaf ? a.leaf < b.leaf : a.point < b.point;
  }
};


/**
 * The shapes of the leaves that a rigid body cuts: the open fraction of each
 * subcell's volume and faces, from the signed distance at the subcells' corners
 * (embedded) or centres (staircase). The closed parts of a subcell's faces sum
 * to the area vector of the wall in it.
 *
 * In axisymmetric geometry, where the cut at z = 0 is turned about the axis,
 * subcells count with the radius in their middle.
 */
template <int dim>
class CutShapes
{
public:
  using Shape = LeafShape<dim>;

  /// Measures all stored leaves; the arguments must outlive this object, and
  /// body and layout stay the same from call to call. Leaves that are known are
  /// not measured again, since signed distances may be costly.
  void measure(const LeafMesh<dim> &mesh,
               const LeafLayout &layout,
               const RigidBody &body);

  const LeafMesh<dim> &mesh() const
  {
    return *mesh_;
  }
  const LeafLayout &layout() const
  {
    return layout_;
  }
  bool is_staircase() const
  {
    return body_->treatment() == RigidBody::Treatment::staircase;
  }

  const OpenFractions &fractions() const
  {
    return fractions_;
  }

  /// Shape of a stored leaf; null where it is open or closed throughout.
  const Shape *shape(const unsigned int leaf) const
  {
    if (changed_of_[leaf] >= 0)
      return &changed_shapes_[changed_of_[leaf]];
    return shape_of_[leaf] < 0 ? nullptr : &memory_.shapes[shape_of_[leaf]];
  }

  /// The shape of a leaf, for changes that hold until measure().
  Shape &changed_shape(const unsigned int leaf);
  /// Closes a subcell and its faces on this side of them; call
  /// update_fractions() for its leaf afterwards.
  void close(const Subcell &cell);
  /// Takes over the fractions of the changed shape of a leaf.
  void update_fractions(const unsigned int leaf)
  {
    fractions_.set(leaf, changed_shape(leaf).fraction);
  }

  /// Gives ghosts the changed shapes of their owners. Collective.
  void update_ghosts();

  /// Whether the surface was measured in a stored leaf.
  bool is_measured(const unsigned int leaf) const
  {
    return shape_of_[leaf] >= 0;
  }

  /// Open fraction of a face of a subcell.
  double opening(const Subcell &cell, const unsigned int face) const;

  /// Differences of the openings of a subcell's low and high faces: the wall's
  /// area vector, out of the gas, over the faces' areas.
  dealii::Tensor<1, dim> wall(const Subcell &cell) const
  {
    dealii::Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = opening(cell, 2 * d) - opening(cell, 2 * d + 1);
    return result;
  }

  /// Radius in the middle of a subcell in axisymmetric geometry [m]; else 1.
  double radius(const Subcell &cell) const;
  /// Volume of a whole owned subcell [m^dim], axisymmetric all around [m^3].
  double cell_volume(const Subcell &cell) const;

  /// The line across direction @p d that a point is on.
  unsigned int line_of(const unsigned int point, const unsigned int d) const
  {
    const unsigned int s = layout_.stride(d);
    return point % s + point / (s * layout_.n) * s;
  }
  /// Layer of a subcell's face among those across its direction.
  unsigned int layer_of(const Subcell &cell, const unsigned int face) const
  {
    return cell.point / layout_.stride(face / 2) % layout_.n + face % 2;
  }

private:
  static constexpr int open = -1;
  static constexpr int closed = -2;

  void measure(const LeafBox<dim> &box, const unsigned int leaf);
  /// Number of the shape of a leaf near the surface, or what it is instead.
  int find_shape(const LeafBox<dim> &box);

  /// Shapes of leaves near the surface, by corner and edge lengths.
  using Place = std::array<double, 2 * dim>;
  struct Memory
  {
    std::vector<Shape> shapes;
    std::unordered_map<Place, int, boost::hash<Place>> index;
  };

  const LeafMesh<dim> *mesh_ = nullptr;
  const RigidBody *body_ = nullptr;
  LeafLayout layout_;
  OpenFractions fractions_;
  Memory memory_;
  Memory former_memory_; ///< while leaves are measured
  /// Per stored leaf of an axisymmetric mesh: inner radius and radial edge of
  /// a subcell [m]; else empty.
  std::vector<std::array<double, 2>> radii_;
  std::vector<int> shape_of_;   ///< per stored leaf: index, open or closed
  std::vector<int> changed_of_; ///< per stored leaf: index, or open
  std::vector<Shape> changed_shapes_;
};
} // namespace contrecoup::gas
