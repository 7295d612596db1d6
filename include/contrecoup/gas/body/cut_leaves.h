// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/neighborhoods.h>

namespace contrecoup::gas
{
/**
 * How a rigid body cuts the leaves, as the kernels see it: the shapes of
 * leaves, matched across hanging faces (FaceMatching), the neighbourhoods of
 * small cells (Neighborhoods), and which batches need the treatment.
 */
template <int dim>
class CutLeaves
{
public:
  using Cell = Subcell;
  using Shape = LeafShape<dim>;

  CutLeaves()
    : matching_(shapes_)
    , neighborhoods_(shapes_, matching_)
  {}
  CutLeaves(const CutLeaves &) = delete;
  CutLeaves &operator=(const CutLeaves &) = delete;

  /// See CutShapes::measure(). Call when the mesh changed. Collective.
  void reinit(const LeafMesh<dim> &mesh,
              const LeafLayout &layout,
              const RigidBody &body);

  RigidBody::Treatment treatment() const
  {
    return shapes_.is_staircase() ? RigidBody::Treatment::staircase
                                  : RigidBody::Treatment::embedded;
  }

  const OpenFractions &fractions() const
  {
    return shapes_.fractions();
  }

  /// Whether the batch has leaves for EmbeddedKernel: cut ones, and those whose
  /// stencil reaches a cut one.
  bool is_cut(const unsigned int batch) const
  {
    return batch_kind_[batch] == BatchKind::cut;
  }
  /// Whether the batch holds no gas.
  bool is_closed(const unsigned int batch) const
  {
    return batch_kind_[batch] == BatchKind::closed;
  }

  /// See CutShapes.
  const Shape *shape(const unsigned int leaf) const
  {
    return shapes_.shape(leaf);
  }
  dealii::Tensor<1, dim> wall(const Cell &cell) const
  {
    return shapes_.wall(cell);
  }
  double cell_volume(const Cell &cell) const
  {
    return shapes_.cell_volume(cell);
  }
  double opening(const Cell &cell, const unsigned int face) const
  {
    return shapes_.opening(cell, face);
  }

  /// Open part of the face between the two layers next to a face of an owned
  /// leaf, in the neighbour there; 1 where there is no equal neighbour.
  double inner_opening_beyond(const unsigned int leaf,
                              const unsigned int face,
                              const unsigned int line) const
  {
    const unsigned int other = matching_.neighbor(leaf, face);
    return other == no_leaf
             ? 1.
             : opening({other, shapes_.layout().face_point(face ^ 1U, line, 0)},
                       face);
  }

  /// See FaceMatching.
  bool is_cut_face(const unsigned int hanging_face) const
  {
    return matching_.is_cut_face(hanging_face);
  }
  double hanging_opening(const HangingFace<dim> &face,
                         const unsigned int part,
                         const unsigned int q) const
  {
    return matching_.hanging_opening(face, part, q);
  }

  /// See Neighborhoods.
  const std::vector<typename Neighborhoods<dim>::Neighborhood> &
  neighborhoods() const
  {
    return neighborhoods_.all();
  }
  unsigned int n_memberships(const Cell &cell) const
  {
    return neighborhoods_.n_memberships(cell);
  }

private:
  enum class BatchKind : char
  {
    open,
    cut,
    closed
  };

  bool reads_cut(const unsigned int leaf) const;
  void classify_batches();

  CutShapes<dim> shapes_;
  FaceMatching<dim> matching_;
  Neighborhoods<dim> neighborhoods_;
  std::vector<BatchKind> batch_kind_;
};
} // namespace contrecoup::gas
