// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_layout.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace contrecoup::gas
{
/**
 * The discontinuous Galerkin space on the leaves of this rank: deal.II's
 * degrees of freedom and MatrixFree, and the tables that lead from its batches
 * of cells and faces to leaves.
 *
 * The nodes of a leaf are the Gauss-Lobatto points, numbered as LeafLayout
 * says. Where all leaves are boxes along the axes, whatever mesh they come
 * from, they are the quadrature points, too; on other meshes these are Gauss
 * points, which keep the order of accuracy on distorted leaves. Leaves have the
 * shapes of LeafMesh::curved_shapes(), or those that their vertices give them.
 *
 * The fluxes through faces are kept in records, laid out as record_layout()
 * says. On boxes a record holds the flux per area towards larger coordinates at
 * the face nodes, for both sides at once where they are equal. On other meshes
 * each side has a record of its own: of each node, the flux out of that leaf
 * times the test function, integrated over the face. A coarse leaf has a record
 * for each finer neighbour, which add up in the order of the quarters, on any
 * number of ranks. Where batches of cells are updated in their order, a record
 * on boxes holds its flux from the first batch that needs it to the last.
 *
 * The pressure at node 0 of the leaf, its reference pressure, is subtracted
 * from pressures before they are integrated over its surface: a constant exerts
 * no net force, and gas at rest then keeps every bit.
 *
 * deal.II 9.4 gives a rank no hanging faces whose finer side is a ghost, and
 * none between periodic leaves of different sizes: hanging faces are taken from
 * LeafMesh, and each rank that owns a leaf next to one computes it.
 */
template <int dim, typename Real>
class GalerkinSpace
{
public:
  using Number = Lanes<Real>;
  using MatrixFree = dealii::MatrixFree<dim, Real, Number>;
  static constexpr unsigned int width = n_lanes<Real>;
  using LaneIndices = std::array<unsigned int, width>;

  /// A finer neighbour of the leaf in a lane.
  struct FinerNeighbor
  {
    unsigned int lane;
    unsigned int face;    ///< of the leaf
    unsigned int record;  ///< of the flux into the neighbour
    unsigned int quarter; ///< of the face
  };

  struct CellBatch
  {
    LaneIndices leaf; ///< unused lanes repeat lane 0
    unsigned int n_filled;
    bool is_leaf_batch; ///< the leaves of a batch of LeafMesh, in their order
    std::array<LaneIndices, 2 * dim> record;    ///< of each face
    std::vector<FinerNeighbor> finer_neighbors; ///< at quarters above 0
    std::vector<unsigned int> faces; ///< batches that hold these records
  };

  struct FaceBatch
  {
    enum class Kind
    {
      regular,
      hanging,
      boundary
    };
    Kind kind = Kind::regular;
    unsigned int boundary_id = 0;
    unsigned int n_filled = 0;
    /// deal.II's number of the batch, where that has it: on mapped meshes,
    /// unless the faces hang.
    unsigned int evaluation = 0;
    /// Part of the coarse leaf's face that a hanging face is; see
    /// HangingFace::fine_leaf.
    unsigned int quarter = 0;
    /// The side that deal.II calls interior: the finer one, or the only one.
    /// Side 0 is the left one: on boxes that of smaller coordinates, else
    /// the interior one.
    unsigned int interior = 0;
    std::array<LaneIndices, 2> leaf; ///< unused lanes repeat lane 0
    std::array<unsigned int, 2> face;
    std::array<unsigned int, 2> record; ///< of each side, for lane 0
    /// Match of the interior side, but of the coarse one on hanging faces of
    /// mapped leaves; the same in all lanes.
    FaceMatch match;
    /// Whether deal.II's quadrature points follow the exterior side's axes.
    bool is_numbered_by_exterior = false;

    bool has(const unsigned int side) const
    {
      return kind != Kind::boundary || side == interior;
    }
  };

  GalerkinSpace(const LeafMesh<dim> &mesh, const LeafLayout &layout);

  /// Renews everything after LeafMesh::rebuild().
  void reinit();

  const MatrixFree &matrix_free() const
  {
    return matrix_free_;
  }
  /// Whether all leaves are boxes and the nodes are the quadrature points.
  bool is_collocated() const
  {
    return is_collocated_;
  }
  /// Exponent m of the radius r in volumes and areas; 0 in plane geometry.
  unsigned int radial_exponent() const
  {
    return contrecoup::radial_exponent(mesh_.coarse_mesh().geometry());
  }
  const std::vector<CellBatch> &cells() const
  {
    return cells_;
  }
  const std::vector<FaceBatch> &faces() const
  {
    return faces_;
  }
  /// A batch of records, one for each lane of a face batch.
  const LeafLayout &record_layout() const
  {
    return record_layout_;
  }
  /// Size of all records together, for @p n_components values a face node.
  std::size_t n_values(const unsigned int n_components) const
  {
    return std::size_t(n_records_) * n_components * record_layout_.n_points;
  }
  /// Number of a face point of the interior side on a side's own face.
  unsigned int own_point(const FaceBatch &batch,
                         const unsigned int side,
                         const unsigned int point) const
  {
    const unsigned int n = layout_.n;
    return dim == 1 || side == batch.interior
             ? point
             : matched_face_point(
                 batch.match.orientation, point % n, point / n, n);
  }
  /// deal.II's number of the quadrature point that belongs to a face point of
  /// the interior side, on mapped meshes. Faces along z and x are numbered z
  /// fastest.
  unsigned int quadrature_point(const FaceBatch &batch,
                                const unsigned int point) const
  {
    const unsigned int n = layout_.n;
    const unsigned int side =
      batch.is_numbered_by_exterior ? 1 - batch.interior : batch.interior;
    const unsigned int own = own_point(batch, side, point);
    return dim == 3 && batch.face[side] / 2 == 1 ? own % n * n + own / n : own;
  }
  const LeafMesh<dim> &mesh() const
  {
    return mesh_;
  }

private:
  void reinit_matrix_free();
  void find_cells();
  /// Batches that still have room, by what their faces have in common.
  using OpenBatches = std::map<std::array<unsigned int, 4>, FaceBatch>;

  void find_mapped_faces();
  bool is_hanging_in_matrix_free(const unsigned int index) const;
  FaceBatch mapped_face_batch(const unsigned int index) const;
  void add_mapped_hanging_faces();
  void find_box_faces();
  /// Adds a face between two leaves to the batch that is like @p batch.
  void add_face(OpenBatches &open,
                const FaceBatch &batch,
                const unsigned int left,
                const unsigned int right);
  void close(const OpenBatches &open);
  /// Calls @p add(batch, left leaf, right leaf) for each face.
  template <typename Add>
  void add_faces_of_box(const unsigned int leaf, const Add &add) const;
  /// A batch whose interior side has face @p face.
  static FaceBatch box_face_batch(const unsigned int face);
  void reserve_records();
  /// Numbers of the batches of cells that need a batch of faces.
  std::pair<unsigned int, unsigned int>
  first_and_last_reader(const FaceBatch &batch) const;
  /// Whether the flux is the same for both sides.
  bool has_one_record(const FaceBatch &batch) const
  {
    return is_collocated_ && batch.kind != FaceBatch::Kind::hanging;
  }
  void attach_records();
  void attach_record(const unsigned int leaf,
                     const unsigned int side,
                     const unsigned int face_batch,
                     const unsigned int record);
  static void sort_finer_neighbors(CellBatch &batch);

  const LeafMesh<dim> &mesh_;
  const LeafLayout layout_;
  LeafLayout record_layout_;
  const bool is_collocated_;
  const dealii::FE_DGQArbitraryNodes<dim> element_;
  const std::unique_ptr<dealii::Mapping<dim>> mapping_;
  dealii::DoFHandler<dim> dof_handler_;
  MatrixFree matrix_free_;
  std::vector<CellBatch> cells_;
  std::vector<FaceBatch> faces_;
  unsigned int n_records_ = 0;
  std::vector<unsigned int> place_of_leaf_; ///< cell batch and lane
};
} // namespace contrecoup::gas
