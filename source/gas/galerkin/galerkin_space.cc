// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/deal_ii/mapping_with_subfaces.h>
#include <contrecoup/base/deal_ii/matrix_free.h>
#include <contrecoup/gas/galerkin/galerkin_space.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>

namespace contrecoup::gas
{
namespace
{
  /// Whether a cell is a box along the axes, its vertices in their order.
  template <typename Cell>
  bool is_box(const Cell &cell)
  {
    const auto &low = cell->vertex(0);
    const auto &high = cell->vertex(cell->n_vertices() - 1);
    for (const unsigned int v : cell->vertex_indices())
      for (unsigned int d = 0; d < low.dimension; ++d)
        if (low[d] >= high[d] ||
            std::abs(cell->vertex(v)[d] - ((v >> d) & 1U ? high : low)[d]) >
              1e-12 * (high[d] - low[d]))
          return false;
    return true;
  }

  template <int dim>
  bool has_only_boxes(const LeafMesh<dim> &mesh)
  {
    if (mesh.curved_shapes() != nullptr)
      return false;
    if (mesh.coarse_mesh().is_axis_aligned())
      return true;
    for (const auto &cell : mesh.triangulation().cell_iterators_on_level(0))
      if (!is_box(cell))
        return false;
    return true;
  }

  /// The vertices alone shape a cell. MappingFE asks the manifold for them,
  /// and SphericalManifold moves vertices in three dimensions.
  template <int dim>
  class MultilinearMapping : public MappingWithSubfaces<dim>
  {
  public:
    MultilinearMapping()
      : MappingWithSubfaces<dim>(dealii::FE_Q<dim>(1))
    {}

    std::unique_ptr<dealii::Mapping<dim>> clone() const override
    {
      return std::make_unique<MultilinearMapping>(*this);
    }

  protected:
    std::vector<dealii::Point<dim>> compute_mapping_support_points(
      const typename dealii::Triangulation<dim>::cell_iterator &cell)
      const override
    {
      std::vector<dealii::Point<dim>> vertices;
      for (const unsigned int v : cell->vertex_indices())
        vertices.push_back(cell->vertex(v));
      return vertices;
    }
  };

  // MatrixFree takes cells for alike, or for parallelepipeds, whose geometry by
  // MappingQ differs by less than 2e-9: uniform flow would change by 5e-11. It
  // keeps 2e-13 with other mappings, in more time.
  template <int dim>
  std::unique_ptr<dealii::Mapping<dim>> mapping_of(const LeafMesh<dim> &mesh)
  {
    if (mesh.curved_shapes() != nullptr)
      return mesh.curved_shapes()->mapping().clone();
    if (has_only_boxes(mesh))
      return std::make_unique<dealii::MappingQ<dim>>(1);
    return std::make_unique<MultilinearMapping<dim>>();
  }
} // namespace


template <int dim, typename Real>
GalerkinSpace<dim, Real>::GalerkinSpace(const LeafMesh<dim> &mesh,
                                        const LeafLayout &layout)
  : mesh_(mesh)
  , layout_(layout)
  , record_layout_(layout)
  , is_collocated_(has_only_boxes(mesh))
  , element_(dealii::QGaussLobatto<1>(layout.n))
  , mapping_(mapping_of(mesh))
{
  record_layout_.n_points = layout.n_face_points;
}


template <int dim, typename Real>
void GalerkinSpace<dim, Real>::reinit()
{
  reinit_matrix_free();
  find_cells();
  faces_.clear();
  if (is_collocated_)
    find_box_faces();
  else
    find_mapped_faces();
  reserve_records();
  attach_records();
}


template <int dim, typename Real>
void GalerkinSpace<dim, Real>::reinit_matrix_free()
{
  dof_handler_.reinit(mesh_.triangulation());
  dof_handler_.distribute_dofs(element_);
  typename MatrixFree::AdditionalData data;
  data.tasks_parallel_scheme = MatrixFree::AdditionalData::none;
  data.mapping_update_flags =
    dealii::update_gradients | dealii::update_JxW_values;
  if (radial_exponent() > 0)
    data.mapping_update_flags |= dealii::update_quadrature_points;
  // Faces of boxes need no geometry; see find_box_faces().
  if (!is_collocated_)
  {
    data.mapping_update_flags_inner_faces = dealii::update_JxW_values |
                                            dealii::update_normal_vectors |
                                            dealii::update_quadrature_points;
    data.mapping_update_flags_boundary_faces =
      data.mapping_update_flags_inner_faces;
    // Both ranks at a face compute its flux: nothing is sent but the state.
    data.hold_all_faces_to_owned_cells = true;
  }
  // Leaves keep their Morton order.
  data.overlap_communication_computation = false;
  const dealii::Quadrature<1> quadrature =
    is_collocated_ ? dealii::Quadrature<1>(dealii::QGaussLobatto<1>(layout_.n))
                   : dealii::Quadrature<1>(dealii::QGauss<1>(layout_.n));
  const dealii::AffineConstraints<double> constraints;
  matrix_free_.reinit(*mapping_, dof_handler_, constraints, quadrature, data);
}


template <int dim, typename Real>
void GalerkinSpace<dim, Real>::find_cells()
{
  cells_.clear();
  place_of_leaf_.resize(mesh_.n_owned());
  for (unsigned int b = 0; b < matrix_free_.n_cell_batches(); ++b)
  {
    CellBatch batch;
    batch.n_filled = matrix_free_.n_active_entries_per_cell_batch(b);
    for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
    {
      batch.leaf[lane] = mesh_.leaf_of(matrix_free_.get_cell_iterator(b, lane));
      place_of_leaf_[batch.leaf[lane]] = b * width + lane;
    }
    std::fill(
      batch.leaf.begin() + batch.n_filled, batch.leaf.end(), batch.leaf[0]);
    batch.is_leaf_batch = batch.leaf[0] % width == 0;
    for (unsigned int lane = 0; lane < width; ++lane)
      batch.is_leaf_batch =
        batch.is_leaf_batch && batch.leaf[lane] == batch.leaf[0] + lane;
    for (LaneIndices &record : batch.record)
      record.fill(no_leaf);
    cells_.push_back(batch);
  }
}


template <int dim, typename Real>
void GalerkinSpace<dim, Real>::find_mapped_faces()
{
  const unsigned int n_batches = matrix_free_.n_inner_face_batches() +
                                 matrix_free_.n_boundary_face_batches() +
                                 matrix_free_.n_ghost_inner_face_batches();
  for (unsigned int b = 0; b < n_batches; ++b)
    if (!is_hanging_in_matrix_free(b))
      faces_.push_back(mapped_face_batch(b));
  add_mapped_hanging_faces();
}


template <int dim, typename Real>
bool GalerkinSpace<dim, Real>::is_hanging_in_matrix_free(
  const unsigned int index) const
{
  const auto &info = matrix_free_.get_face_info(index);
  return info.cells_exterior[0] != dealii::numbers::invalid_unsigned_int &&
         info.subface_index < dealii::GeometryInfo<dim>::max_children_per_cell;
}


template <int dim, typename Real>
typename GalerkinSpace<dim, Real>::FaceBatch
GalerkinSpace<dim, Real>::mapped_face_batch(const unsigned int index) const
{
  const auto &info = matrix_free_.get_face_info(index);
  const bool is_boundary =
    info.cells_exterior[0] == dealii::numbers::invalid_unsigned_int;
  FaceBatch batch;
  batch.evaluation = index;
  batch.kind =
    is_boundary ? FaceBatch::Kind::boundary : FaceBatch::Kind::regular;
  batch.boundary_id = is_boundary ? info.exterior_face_no : 0;
  batch.interior = 0;
  batch.face[0] = info.interior_face_no;
  batch.face[1] =
    is_boundary ? info.interior_face_no ^ 1U : info.exterior_face_no;
  batch.match = {static_cast<unsigned char>(batch.face[1]), 0};
  // deal.II numbers the points of a face as the side in standard orientation.
  batch.is_numbered_by_exterior = info.face_orientation >= 8;
  while (batch.n_filled < width && info.cells_interior[batch.n_filled] !=
                                     dealii::numbers::invalid_unsigned_int)
  {
    const unsigned int lane = batch.n_filled++;
    for (unsigned int side = 0; side < 2; ++side)
      batch.leaf[side][lane] = mesh_.leaf_of(
        matrix_free_.get_face_iterator(index, lane, side == 0 || is_boundary)
          .first);
  }
  for (auto &leaves : batch.leaf)
    std::fill(leaves.begin() + batch.n_filled, leaves.end(), leaves[0]);
  if (batch.kind == FaceBatch::Kind::regular)
  {
    const auto [cell, face] = matrix_free_.get_face_iterator(index, 0, true);
    const auto [other, other_face] =
      matrix_free_.get_face_iterator(index, 0, false);
    if (!cell->has_periodic_neighbor(face))
      batch.match = match_faces<dim>(cell, face, other, other_face);
  }
  return batch;
}


// Those of owned fine leaves, and all of owned coarse ones.
template <int dim, typename Real>
void GalerkinSpace<dim, Real>::add_mapped_hanging_faces()
{
  OpenBatches open;
  for (const HangingFace<dim> &hanging : mesh_.hanging_faces())
  {
    FaceBatch part;
    part.kind = FaceBatch::Kind::hanging;
    part.face = {{hanging.match.face, hanging.coarse_face}};
    part.match = hanging.match;
    for (part.quarter = 0; part.quarter < HangingFace<dim>::n_fine;
         ++part.quarter)
      if (hanging.fine_leaf[part.quarter] != no_leaf)
        add_face(
          open, part, hanging.fine_leaf[part.quarter], hanging.coarse_leaf);
  }
  close(open);
}


template <int dim, typename Real>
void GalerkinSpace<dim, Real>::add_face(OpenBatches &open,
                                        const FaceBatch &batch,
                                        const unsigned int left,
                                        const unsigned int right)
{
  const std::array<unsigned int, 4> key = {
    {static_cast<unsigned int>(batch.kind),
     batch.face[batch.interior],
     batch.kind == FaceBatch::Kind::boundary ? batch.boundary_id
                                             : batch.quarter,
     batch.face[1 - batch.interior] * 8U + batch.match.orientation}};
  FaceBatch &same = open.try_emplace(key, batch).first->second;
  same.leaf[0][same.n_filled] = left;
  same.leaf[1][same.n_filled] = right;
  if (++same.n_filled == width)
  {
    faces_.push_back(same);
    open.erase(key);
  }
}


template <int dim, typename Real>
void GalerkinSpace<dim, Real>::close(const OpenBatches &open)
{
  for (const auto &item : open)
  {
    faces_.push_back(item.second);
    for (auto &leaves : faces_.back().leaf)
      std::fill(
        leaves.begin() + faces_.back().n_filled, leaves.end(), leaves[0]);
  }
}


// deal.II 9.4 has no faces between periodic leaves of different sizes, and no
// periodic lines.
template <int dim, typename Real>
void GalerkinSpace<dim, Real>::find_box_faces()
{
  OpenBatches open;
  const auto add = [&](const FaceBatch &batch,
                       const unsigned int left,
                       const unsigned int right) {
    add_face(open, batch, left, right);
  };
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    add_faces_of_box(leaf, add);
  close(open);
}


// A face between owned leaves is added for the left leaf, a hanging face for
// the fine leaf.
template <int dim, typename Real>
template <typename Add>
void GalerkinSpace<dim, Real>::add_faces_of_box(const unsigned int leaf,
                                                const Add &add) const
{
  const unsigned int batch = leaf / width, lane = leaf % width;
  std::array<bool, 2 *dim> is_special = {};
  for (auto s = mesh_.special_begin(batch); s != mesh_.special_end(batch); ++s)
    if (s->lane == lane)
    {
      is_special[s->face] = true;
      if (s->kind == SpecialFace::Kind::boundary)
      {
        FaceBatch boundary = box_face_batch(s->face);
        boundary.kind = FaceBatch::Kind::boundary;
        boundary.boundary_id = s->index;
        add(boundary, leaf, leaf);
        continue;
      }
      const HangingFace<dim> &hanging = mesh_.hanging_faces()[s->index];
      const bool is_coarse = s->kind == SpecialFace::Kind::coarse_side;
      FaceBatch part = box_face_batch(hanging.coarse_face ^ 1U);
      part.kind = FaceBatch::Kind::hanging;
      for (part.quarter = 0; part.quarter < HangingFace<dim>::n_fine;
           ++part.quarter)
      {
        const unsigned int fine = hanging.fine_leaf[part.quarter];
        if (is_coarse ? fine >= mesh_.n_owned() : fine == leaf)
          add(part,
              part.interior == 0 ? fine : hanging.coarse_leaf,
              part.interior == 0 ? hanging.coarse_leaf : fine);
      }
    }
  for (unsigned int face = 0; face < 2 * dim; ++face)
    if (!is_special[face])
    {
      const unsigned int neighbor = mesh_.neighbors(batch, face)[lane];
      if (face % 2 == 1)
        add(box_face_batch(face), leaf, neighbor);
      else if (neighbor >= mesh_.n_owned())
        add(box_face_batch(face ^ 1U), neighbor, leaf);
    }
}


template <int dim, typename Real>
typename GalerkinSpace<dim, Real>::FaceBatch
GalerkinSpace<dim, Real>::box_face_batch(const unsigned int face)
{
  FaceBatch batch;
  batch.interior = 1 - face % 2;
  batch.face = {{face | 1U, face & ~1U}};
  batch.match = {static_cast<unsigned char>(face ^ 1U), 0};
  return batch;
}


template class GalerkinSpace<1, double>;
template class GalerkinSpace<2, double>;
template class GalerkinSpace<3, double>;
template class GalerkinSpace<3, float>;
} // namespace contrecoup::gas
