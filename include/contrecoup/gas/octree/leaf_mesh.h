// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <contrecoup/gas/octree/curved_shapes.h>
#include <contrecoup/gas/octree/hanging_vertices.h>
#include <contrecoup/gas/octree/leaf_face.h>
#include <contrecoup/gas/octree/precision.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <memory>
#include <type_traits>
#include <vector>

namespace contrecoup::gas
{
/**
 * View of the octree for the kernels. The locally owned leaves stand in Morton
 * order, width() leaves per batch, with their neighbours, edge lengths and
 * special faces (boundary or hanging). Leaf numbers: owned leaves from 0,
 * padded to whole batches, then the ghost leaves that share a face with an
 * owned leaf.
 */
template <int dim>
class LeafMesh
{
public:
  /// p4est has no 1-D meshes; a 1-D mesh lives on one rank.
  using Tria =
    std::conditional_t<dim == 1,
                       dealii::Triangulation<dim>,
                       dealii::parallel::distributed::Triangulation<dim>>;
  using CellIterator = typename Tria::cell_iterator;

  explicit LeafMesh(const MPI_Comm communicator);

  /// Creates the coarse mesh, unrefined, with the batch width of @p precision.
  /// Where the mesh has curved manifolds, leaves are polynomials of degree
  /// @p cell_degree. Call rebuild() after refinement.
  void create(const CoarseMesh<dim> &coarse_mesh,
              const Precision precision = Precision::double_precision,
              const unsigned int cell_degree = 1);

  /// Distributes the leaves over the ranks, by the triangulation's weights if
  /// it has any, else evenly, and calls rebuild(). Refinement alone moves no
  /// leaves to other ranks. Collective.
  void distribute();

  /// Renews numbers, connections, shapes after a change. Collective.
  void rebuild();

  Tria &triangulation()
  {
    return *triangulation_;
  }
  const Tria &triangulation() const
  {
    return *triangulation_;
  }
  const CoarseMesh<dim> &coarse_mesh() const
  {
    return coarse_mesh_;
  }
  /// Shapes of the leaves; nullptr: their vertices shape them.
  const CurvedShapes<dim> *curved_shapes() const
  {
    return curved_shapes_.get();
  }
  /// Communicator of the ranks that share this mesh: one rank in 1-D.
  MPI_Comm communicator() const
  {
    return communicator_;
  }

  unsigned int n_owned() const
  {
    return static_cast<unsigned int>(cells_.size());
  }
  /// Precision that determines the batch width.
  Precision precision() const
  {
    return precision_;
  }
  /// Number of leaves in a batch, one per lane.
  unsigned int width() const
  {
    return width_;
  }
  unsigned int n_batches() const
  {
    return (n_owned() + width_ - 1) / width_;
  }
  /// Leaf number of the first ghost.
  unsigned int first_ghost() const
  {
    return n_batches() * width_;
  }
  unsigned int n_ghosts() const
  {
    return static_cast<unsigned int>(ghosts_.size());
  }
  /// Number of batches of owned and ghost leaves together.
  unsigned int n_stored_batches() const
  {
    return n_batches() + (n_ghosts() + width_ - 1) / width_;
  }
  /// Number of leaves in this batch; the other lanes are padding.
  unsigned int n_filled_lanes(const unsigned int batch) const
  {
    return std::min(width_, n_owned() - batch * width_);
  }
  /// Number of leaves on all ranks.
  double n_global() const;

  const CellIterator &cell(const unsigned int leaf) const
  {
    return cells_[leaf];
  }
  /// Cell of an owned or ghost leaf.
  const CellIterator &stored_cell(const unsigned int leaf) const
  {
    return leaf < n_owned() ? cells_[leaf] : ghosts_[leaf - first_ghost()].cell;
  }
  /// Leaf number of a locally owned active cell; no_leaf for others.
  unsigned int leaf_of(const CellIterator &cell) const
  {
    return leaf_of_cell_[cell->active_cell_index()];
  }

  /// Neighbour of equal size across a face, one leaf number per lane; the leaf
  /// itself where the face is special and in padding lanes.
  const unsigned int *neighbors(const unsigned int batch,
                                const unsigned int face) const
  {
    return neighbors_.data() + lanes_begin(batch, face);
  }
  /// Orientation of the neighbour's face, per lane; see neighbors().
  const FaceMatch *matches(const unsigned int batch,
                           const unsigned int face) const
  {
    return matches_.data() + lanes_begin(batch, face);
  }

  /// Special faces of a batch, ordered by face number.
  const SpecialFace *special_begin(const unsigned int batch) const
  {
    return special_faces_.data() + special_start_[batch];
  }
  const SpecialFace *special_end(const unsigned int batch) const
  {
    return special_faces_.data() + special_start_[batch + 1];
  }

  const std::vector<HangingFace<dim>> &hanging_faces() const
  {
    return hanging_faces_;
  }

  /// Edge lengths of axis-aligned leaves [m], for batches of n_lanes<Real>
  /// leaves, whatever width() is.
  template <typename Real = double>
  const std::array<Lanes<Real>, dim> &extents(const unsigned int batch) const
  {
    if constexpr (std::is_same_v<Real, float>)
      return single_extents_[batch];
    else
      return extents_[batch];
  }
  /// Lower corner of axis-aligned leaves [m], for batches of double_width.
  const std::array<Lanes<double>, dim> &origins(const unsigned int batch) const
  {
    return origins_[batch];
  }

  /// In the order of leaf numbers.
  const std::vector<GhostLeaf<dim>> &ghosts() const
  {
    return ghosts_;
  }
  /// Leaf number of a locally owned cell given by its global index.
  unsigned int leaf_of_global(const std::uint64_t global_index) const;

  /// Memory of the connectivity and the octree on this rank [bytes].
  std::size_t memory() const;

private:
  void number_leaves();
  void append_leaves_below(const CellIterator &cell);
  void connect_leaf(const unsigned int leaf);
  void connect_face(const unsigned int leaf, const unsigned int face);
  void connect_periodic_line();
  void connect_finer(const unsigned int leaf,
                     const unsigned int face,
                     const CellIterator &neighbor,
                     const bool periodic);
  void connect_coarser(const unsigned int leaf,
                       const unsigned int face,
                       const CellIterator &neighbor,
                       const bool periodic);
  /// Leaf number of @p cell, which shares its face @p face with an owned leaf;
  /// a ghost gets its number on the first call.
  unsigned int stored_leaf(const CellIterator &cell, const unsigned int face);
  unsigned int hanging_face(const CellIterator &coarse,
                            const unsigned int face,
                            const FaceMatch &match);
  void set_geometry();
  std::size_t lanes_begin(const unsigned int batch,
                          const unsigned int face) const
  {
    return (std::size_t(batch) * 2 * dim + face) * width_;
  }
  void sort_special_faces();

  MPI_Comm communicator_;
  std::unique_ptr<Tria> triangulation_;
  std::unique_ptr<HangingVertices<dim>> hanging_vertices_; ///< not in 1-D
  std::unique_ptr<CurvedShapes<dim>> curved_shapes_;
  CoarseMesh<dim> coarse_mesh_;
  Precision precision_ = Precision::double_precision;
  unsigned int width_ = double_width; ///< a power of two

  std::vector<CellIterator> cells_;
  std::vector<unsigned int> leaf_of_cell_;
  std::vector<GhostLeaf<dim>> ghosts_;
  std::vector<unsigned int> leaf_of_own_index_;
  std::uint64_t first_global_index_ = 0;

  std::vector<unsigned int> neighbors_; ///< see lanes_begin()
  std::vector<FaceMatch> matches_;

  std::vector<std::pair<unsigned int, SpecialFace>> unsorted_special_;
  std::vector<SpecialFace> special_faces_;
  std::vector<unsigned int> special_start_;
  std::vector<HangingFace<dim>> hanging_faces_;
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> hanging_index_;

  dealii::AlignedVector<std::array<Lanes<double>, dim>> extents_;
  dealii::AlignedVector<std::array<Lanes<double>, dim>> origins_;
  dealii::AlignedVector<std::array<Lanes<float>, dim>> single_extents_;
};
} // namespace contrecoup::gas
