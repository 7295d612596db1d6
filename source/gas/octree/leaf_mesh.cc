// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_mesh.h>

#include <deal.II/base/exceptions.h>

namespace contrecoup::gas
{
template <int dim>
LeafMesh<dim>::LeafMesh(const MPI_Comm communicator)
  : communicator_(dim == 1 ? MPI_COMM_SELF : communicator)
{
  if constexpr (dim == 1)
    triangulation_ = std::make_unique<Tria>();
  else
  {
    triangulation_ = std::make_unique<Tria>(communicator,
                                            dealii::Triangulation<dim>::none,
                                            Tria::no_automatic_repartitioning);
    hanging_vertices_ = std::make_unique<HangingVertices<dim>>(*triangulation_);
  }
}


template <int dim>
void LeafMesh<dim>::create(const CoarseMesh<dim> &coarse_mesh,
                           const Precision precision,
                           const unsigned int cell_degree)
{
  precision_ = precision;
  width_ = batch_width(precision);
  coarse_mesh_ = coarse_mesh;
  triangulation_->clear();
  coarse_mesh.create(*triangulation_);
  curved_shapes_.reset();
  if (cell_degree > 1 && has_curved_manifold<dim>(*triangulation_))
    curved_shapes_ =
      std::make_unique<CurvedShapes<dim>>(*triangulation_, cell_degree);
}


template <int dim>
void LeafMesh<dim>::distribute()
{
  if constexpr (dim > 1)
    if (dealii::Utilities::MPI::n_mpi_processes(communicator_) > 1)
    {
      // deal.II keeps siblings, which merge on one rank alone, together if
      // there are weights, and not without.
      boost::signals2::scoped_connection equal_weights;
      if (triangulation_->signals.weight.empty())
        equal_weights = triangulation_->signals.weight.connect(
          [](const CellIterator &, const auto) { return 1U; });
      triangulation_->repartition();
    }
  rebuild();
}


template <int dim>
void LeafMesh<dim>::rebuild()
{
  if (curved_shapes_)
    curved_shapes_->reinit();
  else if constexpr (dim > 1)
    if (!coarse_mesh_.is_axis_aligned())
      hanging_vertices_->settle();
  number_leaves();
  ghosts_.clear();
  hanging_faces_.clear();
  hanging_index_.clear();
  unsorted_special_.clear();
  neighbors_.resize(lanes_begin(n_batches(), 0));
  matches_.resize(neighbors_.size());
  // Padding lanes hold the number of the last leaf, which is valid to read.
  for (unsigned int batch = 0; batch < n_batches(); ++batch)
    for (unsigned int face = 0; face < 2 * dim; ++face)
      for (unsigned int lane = 0; lane < width_; ++lane)
      {
        neighbors_[lanes_begin(batch, face) + lane] =
          std::min(batch * width_ + lane, n_owned() - 1);
        matches_[lanes_begin(batch, face) + lane] = {
          static_cast<unsigned char>(face ^ 1U), 0};
      }
  for (unsigned int leaf = 0; leaf < n_owned(); ++leaf)
    connect_leaf(leaf);
  if constexpr (dim == 1)
    if (coarse_mesh_.is_periodic(0))
      connect_periodic_line();
  sort_special_faces();
  set_geometry();
}


template <int dim>
void LeafMesh<dim>::number_leaves()
{
  cells_.clear();
  leaf_of_cell_.assign(triangulation_->n_active_cells(), no_leaf);
  for (auto cell = triangulation_->begin(0); cell != triangulation_->end(0);
       ++cell)
    append_leaves_below(cell);

  leaf_of_own_index_.assign(n_owned(), no_leaf);
  first_global_index_ = static_cast<std::uint64_t>(-1);
  for (unsigned int leaf = 0; leaf < n_owned(); ++leaf)
    first_global_index_ = std::min<std::uint64_t>(
      first_global_index_, cells_[leaf]->global_active_cell_index());
  for (unsigned int leaf = 0; leaf < n_owned(); ++leaf)
    leaf_of_own_index_[cells_[leaf]->global_active_cell_index() -
                       first_global_index_] = leaf;
}


template <int dim>
void LeafMesh<dim>::append_leaves_below(const CellIterator &cell)
{
  if (cell->has_children())
  {
    for (unsigned int child = 0; child < cell->n_children(); ++child)
      append_leaves_below(cell->child(child));
    return;
  }
  if (!cell->is_locally_owned())
    return;
  leaf_of_cell_[cell->active_cell_index()] = n_owned();
  cells_.push_back(cell);
}


template <int dim>
unsigned int
LeafMesh<dim>::leaf_of_global(const std::uint64_t global_index) const
{
  return leaf_of_own_index_[global_index - first_global_index_];
}


template <int dim>
void LeafMesh<dim>::connect_leaf(const unsigned int leaf)
{
  for (unsigned int face = 0; face < 2 * dim; ++face)
    connect_face(leaf, face);
}


template <int dim>
void LeafMesh<dim>::connect_face(const unsigned int leaf,
                                 const unsigned int face)
{
  const auto &cell = cells_[leaf];
  const bool periodic = dim > 1 && cell->has_periodic_neighbor(face);
  if (cell->at_boundary(face) && !periodic)
  {
    unsorted_special_.push_back(
      {leaf / width_,
       {SpecialFace::Kind::boundary,
        static_cast<unsigned char>(leaf % width_),
        static_cast<unsigned char>(face),
        0,
        static_cast<unsigned int>(cell->face(face)->boundary_id())}});
    return;
  }
  const auto neighbor =
    periodic ? cell->periodic_neighbor(face) : cell->neighbor(face);
  if (neighbor->level() < cell->level())
    connect_coarser(leaf, face, neighbor, periodic);
  else if (neighbor->has_children())
    connect_finer(leaf, face, neighbor, periodic);
  else
  {
    const std::size_t here = lanes_begin(leaf / width_, face) + leaf % width_;
    FaceMatch &match = matches_[here];
    if (!periodic)
      match = match_faces<dim>(
        cell, face, neighbor, cell->neighbor_of_neighbor(face));
    neighbors_[here] = stored_leaf(neighbor, match.face);
  }
}


template <int dim>
void LeafMesh<dim>::connect_periodic_line()
{
  const unsigned int last = n_owned() - 1;
  neighbors_[0] = last;
  neighbors_[lanes_begin(last / width_, 1) + last % width_] = 0;
  const auto is_end = [](const auto &item) {
    return item.second.kind == SpecialFace::Kind::boundary;
  };
  unsorted_special_.erase(
    std::remove_if(unsorted_special_.begin(), unsorted_special_.end(), is_end),
    unsorted_special_.end());
}


template <int dim>
void LeafMesh<dim>::connect_finer(const unsigned int leaf,
                                  const unsigned int face,
                                  const CellIterator &neighbor,
                                  const bool periodic)
{
  const auto &cell = cells_[leaf];
  FaceMatch match;
  if (periodic)
    match = {static_cast<unsigned char>(face ^ 1U), 0};
  else
    match =
      match_faces<dim>(cell, face, neighbor, cell->neighbor_of_neighbor(face));
  const unsigned int index = hanging_face(cell, face, match);
  hanging_faces_[index].coarse_leaf = leaf;
  for (unsigned int part = 0; part < HangingFace<dim>::n_fine; ++part)
  {
    const unsigned int other =
      matched_face_point(match.orientation, part % 2, part / 2, 2);
    hanging_faces_[index].fine_leaf[part] = stored_leaf(
      neighbor->child(face_corner<dim>(match.face, other % 2, other / 2)),
      match.face);
  }
  unsorted_special_.push_back({leaf / width_,
                               {SpecialFace::Kind::coarse_side,
                                static_cast<unsigned char>(leaf % width_),
                                static_cast<unsigned char>(face),
                                0,
                                index}});
}


template <int dim>
void LeafMesh<dim>::connect_coarser(const unsigned int leaf,
                                    const unsigned int face,
                                    const CellIterator &neighbor,
                                    const bool periodic)
{
  const auto &cell = cells_[leaf];
  const auto parent = cell->parent();
  unsigned int coarse_face = face ^ 1U;
  FaceMatch match = {static_cast<unsigned char>(face), 0};
  if (dim > 1 && !periodic)
  {
    coarse_face = cell->neighbor_of_coarser_neighbor(face).first;
    match = match_faces<dim>(neighbor, coarse_face, parent, face);
  }
  const unsigned int index = hanging_face(neighbor, coarse_face, match);
  hanging_faces_[index].coarse_leaf = stored_leaf(neighbor, coarse_face);
  unsigned int my_part = 0;
  for (unsigned int part = 0; part < HangingFace<dim>::n_fine; ++part)
  {
    const unsigned int other =
      matched_face_point(match.orientation, part % 2, part / 2, 2);
    if (parent->child(face_corner<dim>(face, other % 2, other / 2)) == cell)
      my_part = part;
  }
  hanging_faces_[index].fine_leaf[my_part] = leaf;
  unsorted_special_.push_back({leaf / width_,
                               {SpecialFace::Kind::fine_side,
                                static_cast<unsigned char>(leaf % width_),
                                static_cast<unsigned char>(face),
                                static_cast<unsigned char>(my_part),
                                index}});
}


template <int dim>
unsigned int LeafMesh<dim>::stored_leaf(const CellIterator &cell,
                                        const unsigned int face)
{
  unsigned int &leaf = leaf_of_cell_[cell->active_cell_index()];
  if (leaf == no_leaf)
  {
    leaf = first_ghost() + n_ghosts();
    ghosts_.push_back(
      {cell->subdomain_id(), cell->global_active_cell_index(), 0, cell});
  }
  if (leaf >= first_ghost())
    ghosts_[leaf - first_ghost()].faces |= 1U << face;
  return leaf;
}


template <int dim>
unsigned int LeafMesh<dim>::hanging_face(const CellIterator &coarse,
                                         const unsigned int face,
                                         const FaceMatch &match)
{
  const auto entry = hanging_index_.try_emplace(
    {coarse->active_cell_index(), face}, hanging_faces_.size());
  if (entry.second)
  {
    HangingFace<dim> hanging;
    hanging.coarse_face = face;
    hanging.match = match;
    hanging.fine_leaf.fill(no_leaf);
    hanging_faces_.push_back(hanging);
  }
  return entry.first->second;
}


template <int dim>
void LeafMesh<dim>::sort_special_faces()
{
  const auto key = [](const std::pair<unsigned int, SpecialFace> &entry) {
    return entry.first * 2 * dim + entry.second.face;
  };
  std::stable_sort(
    unsorted_special_.begin(),
    unsorted_special_.end(),
    [&](const auto &x, const auto &y) { return key(x) < key(y); });
  special_faces_.clear();
  special_start_.assign(n_batches() + 1, 0);
  for (const auto &[batch, special] : unsorted_special_)
  {
    special_faces_.push_back(special);
    ++special_start_[batch + 1];
  }
  for (unsigned int batch = 0; batch < n_batches(); ++batch)
    special_start_[batch + 1] += special_start_[batch];
  unsorted_special_.clear();
  unsorted_special_.shrink_to_fit();
}


template <int dim>
void LeafMesh<dim>::set_geometry()
{
  const bool is_single = precision_ == Precision::single_precision;
  extents_.resize(first_ghost() / double_width);
  origins_.resize(extents_.size());
  single_extents_.resize(is_single ? n_batches() : 0);
  for (unsigned int leaf = 0; leaf < first_ghost(); ++leaf)
  {
    const auto &cell = cells_[std::min(leaf, n_owned() - 1)];
    const auto &low = cell->vertex(0);
    const auto &high = cell->vertex((1U << dim) - 1);
    for (unsigned int d = 0; d < dim; ++d)
    {
      origins_[leaf / double_width][d][leaf % double_width] = low[d];
      extents_[leaf / double_width][d][leaf % double_width] = high[d] - low[d];
      if (is_single)
        single_extents_[leaf / width_][d][leaf % width_] = high[d] - low[d];
    }
  }
}


template <int dim>
double LeafMesh<dim>::n_global() const
{
  if constexpr (dim == 1)
    return n_owned();
  else
    return static_cast<double>(triangulation_->n_global_active_cells());
}


template <int dim>
std::size_t LeafMesh<dim>::memory() const
{
  return triangulation_->memory_consumption() +
         neighbors_.capacity() * sizeof(neighbors_[0]) +
         matches_.capacity() * sizeof(matches_[0]) +
         special_faces_.capacity() * sizeof(SpecialFace) +
         hanging_faces_.capacity() * sizeof(HangingFace<dim>) +
         cells_.capacity() * sizeof(CellIterator) +
         (curved_shapes_ ? curved_shapes_->memory() : 0);
}


template class LeafMesh<1>;
template class LeafMesh<2>;
template class LeafMesh<3>;
} // namespace contrecoup::gas
