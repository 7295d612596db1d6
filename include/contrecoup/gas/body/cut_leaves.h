// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/leaf_shape.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/state/open_fractions.h>

#include <boost/container/static_vector.hpp>
#include <boost/functional/hash.hpp>

#include <array>
#include <map>
#include <unordered_map>
#include <vector>

namespace contrecoup::gas
{
/**
 * How a rigid body cuts the leaves: the open part of each subcell's volume and
 * faces, from the signed distance at the subcells' corners (embedded) or
 * centres (staircase). The areas of what is closed add up, in each subcell,
 * to the area vector of the wall in it.
 *
 * Between leaves of different size the fine side's faces count, closed where
 * the coarse subcell has no gas; the open part of a coarse subcell's face is
 * their mean, so that the surface stays closed.
 *
 * Small cells, less than half open, share their change with a
 * neighbourhood: themselves and the next one or two cells along one direction,
 * the one nearest to the wall's normal that makes half a cell of volume
 * (state redistribution of Berger and Giuliani, J. Comput. Phys. 428, 109820,
 * 2021); among leaves of another size it ends with the first layer. Pockets,
 * in which none makes a quarter of a cell, or only with too large a surface,
 * are closed. Nothing here depends on how ranks share the leaves.
 *
 * In axisymmetric geometry, where the cut at z = 0 is turned about the axis,
 * cells count with the radius in their middle.
 */
template <int dim>
class CutLeaves
{
public:
  using Shape = LeafShape<dim>;

  /// A cell by leaf and point.
  struct Cell
  {
    unsigned int leaf = no_leaf;
    unsigned int point = 0;
    /// Its whole volume in parts of that of a neighbourhood's first cell [-].
    double size = 1.;

    friend bool operator<(const Cell &a, const Cell &b)
    {
      return a.leaf != b.leaf ? a.leaf < b.leaf : a.point < b.point;
    }
  };

  /// Cells side by side, at most 1 + 1 + 2^(dim-1).
  using Chain = boost::container::static_vector<Cell, 6>;

  /// A small cell and the next ones, across @p face, that it shares its
  /// change with.
  struct Neighborhood
  {
    unsigned int face;
    Chain cells;
  };

  /// Measures all leaves; the arguments must outlive this object, and body and
  /// layout stay the same from call to call. Call when the mesh changed.
  /// Collective.
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
    if (matched_of_[leaf] >= 0)
      return &matched_shapes_[matched_of_[leaf]];
    return shape_of_[leaf] < 0 ? nullptr : &memory_.shapes[shape_of_[leaf]];
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

  /// Whether leaves that meet there are cut or closed.
  bool is_cut_face(const unsigned int hanging_face) const
  {
    return is_cut_face_[hanging_face] != 0;
  }

  /// Open part of a fine subcell's face on a hanging face: of the fine leaf's
  /// face point @p q in a part of it, which is stored here.
  double hanging_opening(const HangingFace<dim> &face,
                         const unsigned int part,
                         const unsigned int q) const;

  /// Coarse face point that holds the fine face point @p q of a part.
  unsigned int coarse_face_point(const unsigned int part,
                                 const unsigned int q) const;

  /// Volume of a whole owned cell [m^dim], axisymmetric all around [m^3].
  double cell_volume(const Cell &cell) const;

  /// Open part of a face of an owned cell, or within a leaf.
  double opening(const Cell &cell, const unsigned int face) const;

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

  void measure(const LeafBox<dim> &box, const unsigned int leaf);
  /// Index of the shape of a leaf near the surface, or what it is instead; one
  /// that was known before is taken over, since bodies may be costly to ask.
  int find_shape(const LeafBox<dim> &box);
  /// Radius in the middle of a stored cell in axisymmetric geometry [m]; else
  /// 1.
  double radius(const Cell &cell) const;
  void measure_all();
  void find_neighbors();
  void connect(const unsigned int leaf);
  unsigned int line_of(const unsigned int point, const unsigned int d) const;
  /// Closes the faces between leaves of different size alike on both sides.
  void match_sizes();
  void match_cut_faces();
  void match_coarse_side(const HangingFace<dim> &face);
  void match_fine_side(const HangingFace<dim> &face, const unsigned int part);
  /// The shape of a leaf, for changes that hold while its neighbours have the
  /// sizes that they have.
  Shape &own_shape(const unsigned int leaf);
  /// The cell of equal size across a face; leaf no_leaf where there is none,
  /// or where the face is closed.
  Cell next(const Cell &cell, const unsigned int face) const;
  /// Adds to a chain what lies across a face, in leaves of another size, of
  /// its last cell; returns whether there is anything.
  bool cross(const unsigned int face, Chain &chain) const;
  /// The cell and the next @p length ones across a face, where leaves of
  /// another size end it; empty where there are not so many.
  Chain chain(const Cell &cell,
              const unsigned int face,
              const unsigned int length) const;
  unsigned char choose_direction(const Cell &cell) const;
  /// A number for the sizes of what is beyond the sides of an owned leaf.
  unsigned int kinds_of_sides(const unsigned int leaf) const;
  void choose_directions();
  /// For all small cells that are not yet known as pockets.
  void choose_in_leaf(const unsigned int leaf, Codes &codes) const;
  /// Closes the cells whose code is `pocket`; of ghosts as well. Collective.
  void close_pockets(std::map<unsigned int, Codes> pockets);
  void close(const Cell &cell);
  void find_neighborhoods();
  void share(std::map<unsigned int, Codes> &codes) const;
  bool reads_cut(const unsigned int leaf) const;
  void classify_batches();

  const LeafMesh<dim> *mesh_ = nullptr;
  const RigidBody *body_ = nullptr;
  LeafLayout layout_;
  OpenFractions fractions_;
  using Place = std::array<double, 2 * dim>;
  static constexpr int open = -1;
  static constexpr int closed = -2;
  /// Of leaves near the surface, by corner and edge lengths.
  struct Memory
  {
    std::vector<Shape> shapes;
    /// Per shape: directions_, and the kinds of sides for which they hold.
    std::vector<Codes> directions;
    std::vector<unsigned int> sides;
    std::unordered_map<Place, int, boost::hash<Place>> index;
  };
  Memory memory_;
  Memory former_memory_; ///< while leaves are measured
  /// Per stored leaf of an axisymmetric mesh: inner radius and radial edge of
  /// a subcell [m]; else empty.
  std::vector<std::array<double, 2>> radii_;
  std::vector<int> shape_of_;   ///< per stored leaf: index in memory_, or open
  std::vector<int> matched_of_; ///< per stored leaf: index, or open
  std::vector<Shape> matched_shapes_; ///< see own_shape()
  std::vector<char> is_cut_face_;     ///< per hanging face
  /// By leaf and face, where leaves of different size are cut: the hanging
  /// face, and the part of the fine leaf, no_leaf for the coarse one.
  using Side = std::pair<unsigned int, unsigned int>;
  std::map<std::pair<unsigned int, unsigned int>, Side> sides_;
  std::vector<BatchKind> batch_kind_;
  /// Of leaves at the surface: neighbours of equal size that are known.
  std::map<unsigned int, std::array<unsigned int, 2 * dim>> neighbors_;
  static constexpr unsigned char pocket = 255;
  /// Per leaf with small cells: 0, pocket, or 1 + face + 2 dim (length - 1).
  std::map<unsigned int, Codes> directions_;
  /// Per leaf with cells in others' neighbourhoods: how many of them.
  std::map<unsigned int, Codes> memberships_;
  std::vector<Neighborhood> neighborhoods_;
};
} // namespace contrecoup::gas
