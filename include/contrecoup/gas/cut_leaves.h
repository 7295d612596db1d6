// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/leaf_layout.h>
#include <contrecoup/gas/leaf_mesh.h>
#include <contrecoup/gas/leaf_sampling.h>
#include <contrecoup/gas/open_fractions.h>
#include <contrecoup/gas/rigid_body.h>

#include <array>
#include <map>
#include <vector>

namespace contrecoup::gas
{
/**
 * How a rigid body cuts the leaves: the open part of each subcell's volume and
 * faces, from the signed distance at the subcells' corners (embedded) or
 * centres (staircase). The areas of what is closed add up, in each subcell,
 * to the area vector of the wall in it.
 *
 * Small cells, less than half open, share their change with a
 * neighbourhood: themselves and the next one or two cells along one direction,
 * the one nearest to the wall's normal that makes half a cell of volume
 * (state redistribution of Berger and Giuliani, J. Comput. Phys. 428, 109820,
 * 2021). Nothing here depends on how ranks share the leaves.
 */
template <int dim>
class CutLeaves
{
public:
  /// The shape of one leaf; open parts from 0 to 1 [-].
  struct Shape
  {
    /// Whether all of it is open.
    bool is_open() const;

    std::vector<double> fraction; ///< of each point's volume
    /// Of the subcell faces across each direction, [layer][line]; lines are
    /// numbered as in LeafKernel.
    std::array<std::vector<double>, dim> opening;
  };

  /// A cell by leaf and point.
  struct Cell
  {
    unsigned int leaf = no_leaf;
    unsigned int point = 0;

    friend bool operator<(const Cell &a, const Cell &b)
    {
      return a.leaf != b.leaf ? a.leaf < b.leaf : a.point < b.point;
    }
  };

  /// A small cell and the next ones, across @p face, that it shares its
  /// change with.
  struct Neighborhood
  {
    unsigned int face;
    std::vector<Cell> cells;
  };

  /// Measures all leaves; the arguments must outlive this object, and body and
  /// layout stay the same from call to call. Call when the mesh changed.
  /// Collective.
  /// @throws InputError when leaves of different size meet at the surface.
  void reinit(const LeafMesh<dim> &mesh,
              const LeafLayout &layout,
              const RigidBody &body);

  RigidBody::Treatment treatment() const
  {
    return body_->treatment();
  }

  const OpenFractions &fractions() const
  {
    return fractions_;
  }

  /// Whether the batch has leaves that need the treatment: cut ones, and
  /// those whose stencil reaches a cut.
  bool is_cut(const unsigned int batch) const
  {
    return batch_kind_[batch] == BatchKind::cut;
  }
  /// Whether the batch holds no gas.
  bool is_closed(const unsigned int batch) const
  {
    return batch_kind_[batch] == BatchKind::closed;
  }

  /// Shape of a stored leaf; null where it is open or closed throughout.
  const Shape *shape(const unsigned int leaf) const
  {
    return shape_of_[leaf] < 0 ? nullptr : &shapes_[shape_of_[leaf]];
  }

  /// Differences of the openings of an owned cell's low and high faces: the
  /// wall's area vector, out of the gas, in parts of the faces' areas.
  dealii::Tensor<1, dim> wall(const Cell &cell) const
  {
    dealii::Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = opening(cell, 2 * d) - opening(cell, 2 * d + 1);
    return result;
  }

  /// Open part of the face between the two layers next to a face of an owned
  /// leaf, in the neighbour there; 1 where there is no equal neighbour.
  double inner_opening_beyond(const unsigned int leaf,
                              const unsigned int face,
                              const unsigned int line) const;

  /// Neighbourhoods of which owned leaves hold cells.
  const std::vector<Neighborhood> &neighborhoods() const
  {
    return neighborhoods_;
  }
  /// Number of neighbourhoods that a cell belongs to, its own included.
  unsigned int n_memberships(const Cell &cell) const;

private:
  enum class BatchKind : char
  {
    open,
    cut,
    closed
  };
  using Codes = std::vector<unsigned char>;

  /// Classifies a stored leaf.
  void measure(const LeafBox<dim> &box, const unsigned int leaf);
  /// The shape of a leaf near the surface; one that was known before is taken
  /// over, since bodies may be costly to ask.
  Shape shape_in(const LeafBox<dim> &box);
  Shape cut_shape(const LeafBox<dim> &box) const;
  Shape staircase_shape(const LeafBox<dim> &box) const;
  void measure_all();
  void find_neighbors();
  /// Sets the neighbours of an owned leaf, and itself as one of ghosts.
  void connect(const unsigned int leaf);
  /// The line of a point across a direction.
  unsigned int line_of(const unsigned int point, const unsigned int d) const;
  double opening(const Cell &cell, const unsigned int face) const;
  /// The cell across a face; leaf no_leaf where there is none, or where the
  /// face is closed.
  Cell next(const Cell &cell, const unsigned int face) const;
  unsigned char choose_direction(const Cell &cell) const;
  void choose_directions();
  void find_neighborhoods();
  void share(std::map<unsigned int, Codes> &codes) const;
  bool reads_cut(const unsigned int leaf) const;
  void classify_batches();

  const LeafMesh<dim> *mesh_ = nullptr;
  const RigidBody *body_ = nullptr;
  LeafLayout layout_;
  OpenFractions fractions_;
  std::vector<int> shape_of_; ///< per stored leaf: index, or -1
  std::vector<Shape> shapes_;
  /// Where the shapes are: corners and edge lengths [m].
  std::map<std::array<double, 2 * dim>, std::size_t> place_of_shape_;
  std::map<std::array<double, 2 * dim>, std::size_t> former_places_;
  std::vector<Shape> former_shapes_; ///< while new ones are found
  std::vector<BatchKind> batch_kind_;
  /// Of leaves at the surface: neighbours of equal size that are known.
  std::map<unsigned int, std::array<unsigned int, 2 * dim>> neighbors_;
  /// Per leaf with small cells: 0, or 1 + face + 2 dim (length - 1).
  std::map<unsigned int, Codes> directions_;
  /// Per leaf with cells in others' neighbourhoods: how many of them.
  std::map<unsigned int, Codes> memberships_;
  std::vector<Neighborhood> neighborhoods_;
};
} // namespace contrecoup::gas
