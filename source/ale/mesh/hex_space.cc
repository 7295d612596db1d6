// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/hex_space.h>
#include <contrecoup/base/deal_ii/releases.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>

namespace contrecoup::ale
{
void require_valid_cells(const dealii::Triangulation<3> &mesh)
{
  for (const auto &cell : mesh.active_cell_iterators())
  {
    HexVectors<double> corners;
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        corners[i][d] = cell->vertex(vertex_of_corner[i])[d];
    if (smallest_corner_jacobian(corners) > 0.)
      continue;
    const auto x = cell->center();
    throw InputError("Mesh: cell " + std::to_string(cell->active_cell_index()) +
                     " at (" + std::to_string(x[0]) + ", " +
                     std::to_string(x[1]) + ", " + std::to_string(x[2]) +
                     ") m is inverted: at one of its corners the volume is "
                     "not positive");
  }
}


void HexSpace::reinit(const dealii::Triangulation<3> &mesh,
                      const MPI_Comm communicator,
                      const std::vector<bool> &slides)
{
  slides_ = slides;
  if (mesh.n_levels() > 1)
    throw InputError("Mesh: it has cells of different levels; flatten it");
  require_valid_cells(mesh);
  distribute(mesh, communicator);
  number_nodes();
  number_cells(mesh);
  find_faces();
  find_cells_around();
}


void HexSpace::distribute(const dealii::Triangulation<3> &mesh,
                          const MPI_Comm communicator)
{
  namespace Description = dealii::TriangulationDescription;
  dealii::Triangulation<3> copy;
  copy.copy_triangulation(mesh);
  dealii::GridTools::partition_triangulation_zorder(
    dealii::Utilities::MPI::n_mpi_processes(communicator), copy);
  dofs_.reset();
  triangulation_ =
    std::make_unique<dealii::parallel::fullydistributed::Triangulation<3>>(
      communicator);
  triangulation_->create_triangulation(
    Description::Utilities::create_description_from_triangulation(
      copy, communicator));
  dofs_ = std::make_unique<dealii::DoFHandler<3>>(*triangulation_);
  dofs_->distribute_dofs(dealii::FESystem<3>(dealii::FE_Q<3>(1), 3));
}


MPI_Comm HexSpace::communicator() const
{
  return communicator_of(*triangulation_);
}


std::vector<bool> HexSpace::find_double_vertices() const
{
  std::vector<bool> result(vertices_->locally_owned_size() +
                           vertices_->n_ghost_indices());
  if (std::find(slides_.begin(), slides_.end(), true) == slides_.end())
    return result;
  // Per vertex: number of cells of sliding, and of other regions.
  FieldExchange exchange;
  exchange.reinit(*vertices_, 2);
  dealii::AlignedVector<double> count(exchange.size());
  std::vector<dealii::types::global_dof_index> dofs(24);
  for (const auto &cell : dofs_->active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    cell->get_dof_indices(dofs);
    for (unsigned int v = 0; v < 8; ++v)
      count[2 * vertices_->global_to_local(dofs[3 * v] / 3) +
            (slides_[cell->material_id()] ? 1 : 0)] += 1.;
  }
  exchange.compress_add(count);
  exchange.update_ghost_values(count);
  for (std::size_t v = 0; v < result.size(); ++v)
    result[v] = count[2 * v] > 0. && count[2 * v + 1] > 0.;
  return result;
}


void HexSpace::number_nodes()
{
  const auto &own = dofs_->locally_owned_dofs();
  const dealii::IndexSet relevant =
    dealii::DoFTools::extract_locally_relevant_dofs(*dofs_);
  dealii::IndexSet own_vertices(own.size() / 3), other_vertices(own.size() / 3);
  for (const auto dof : relevant)
    if (dof % 3 == 0)
      (own.is_element(dof) ? own_vertices : other_vertices).add_index(dof / 3);
  vertices_ = std::make_shared<const dealii::Utilities::MPI::Partitioner>(
    own_vertices, other_vertices, communicator());
  number_nodes(find_double_vertices());
}


std::vector<HexSpace::VertexNodes>
HexSpace::numbers_of_nodes(const std::vector<bool> &is_double) const
{
  const std::size_t n_own = vertices_->locally_owned_size();
  const std::uint64_t n_pairs =
    std::count(is_double.begin(), is_double.begin() + n_own, true);
  std::uint64_t n_pairs_before = 0;
  const int error = MPI_Exscan(
    &n_pairs, &n_pairs_before, 1, MPI_UINT64_T, MPI_SUM, communicator());
  AssertThrowMPI(error);
  // Doubles represent these integers exactly.
  FieldExchange exchange;
  exchange.reinit(*vertices_, 2);
  dealii::AlignedVector<double> numbers(exchange.size());
  const std::uint64_t first = vertices_->local_range().first + n_pairs_before;
  std::uint64_t next = first + n_own;
  for (std::size_t v = 0; v < n_own; ++v)
  {
    numbers[2 * v] = static_cast<double>(first + v);
    numbers[2 * v + 1] =
      is_double[v] ? static_cast<double>(next++) : numbers[2 * v];
  }
  exchange.update_ghost_values(numbers);
  std::vector<VertexNodes> result(is_double.size());
  for (std::size_t v = 0; v < result.size(); ++v)
    for (unsigned int i = 0; i < 2; ++i)
      result[v][i] =
        static_cast<dealii::types::global_dof_index>(numbers[2 * v + i]);
  return result;
}


void HexSpace::number_nodes(const std::vector<bool> &is_double)
{
  const std::size_t n_own = vertices_->locally_owned_size();
  const auto numbers = numbers_of_nodes(is_double);
  const std::uint64_t n_pairs =
    std::count(is_double.begin(), is_double.begin() + n_own, true);
  const auto n =
    vertices_->size() + dealii::Utilities::MPI::sum(n_pairs, communicator());
  dealii::IndexSet own_nodes(n), other_nodes(n);
  for (std::size_t v = 0; v < numbers.size(); ++v)
    for (const auto number : numbers[v])
      (v < n_own ? own_nodes : other_nodes).add_index(number);
  nodes_ = std::make_shared<const dealii::Utilities::MPI::Partitioner>(
    own_nodes, other_nodes, communicator());

  n_own_nodes_ = own_nodes.n_elements();
  const std::size_t n_here = n_own_nodes_ + other_nodes.n_elements();
  node_numbers_.assign(n_here, 0);
  positions_.assign(n_here, dealii::Point<3>());
  first_dofs_.assign(n_here, dealii::numbers::invalid_dof_index);
  node_of_vertex_.resize(numbers.size());
  pairs_.clear();
  for (std::size_t v = 0; v < numbers.size(); ++v)
  {
    const auto node = nodes_->global_to_local(numbers[v][0]);
    node_of_vertex_[v] = node;
    first_dofs_[node] = 3 * vertices_->local_to_global(v);
    if (is_double[v])
      pairs_.push_back({nodes_->global_to_local(numbers[v][1]), node});
  }
}


void HexSpace::number_cells(const dealii::Triangulation<3> &mesh)
{
  std::vector<std::vector<unsigned int>> vertices(mesh.n_cells());
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      vertices[cell->index()].push_back(cell->vertex_index(v));

  cells_partitioner_ =
    triangulation_->global_active_cell_index_partitioner().lock();
  n_own_cells_ = cells_partitioner_->locally_owned_size();
  const std::size_t n = n_own_cells_ + cells_partitioner_->n_ghost_indices();
  cells_.assign(n, Cell());
  regions_.assign(n, 0);
  cell_numbers_.assign(n, 0);
  std::vector<std::uint32_t> sliding_node(n_nodes(), no_cell);
  for (const SlidingPair &pair : pairs_)
    sliding_node[pair.held] = pair.sliding;
  std::vector<dealii::types::global_dof_index> dofs(24);
  for (const auto &cell : dofs_->active_cell_iterators())
  {
    if (cell->is_artificial())
      continue;
    const auto c =
      cells_partitioner_->global_to_local(cell->global_active_cell_index());
    cell_numbers_[c] = cell->id().get_coarse_cell_id();
    regions_[c] = static_cast<unsigned char>(cell->material_id());
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < 8; ++i)
    {
      const unsigned int v = vertex_of_corner[i];
      const std::uint32_t node = node_of(dofs[3 * v]),
                          sliding = sliding_node[node],
                          number = vertices[cell_numbers_[c]][v];
      cells_[c][i] = slides(c) && sliding != no_cell ? sliding : node;
      node_numbers_[node] = number;
      positions_[node] = cell->vertex(v);
      if (sliding == no_cell)
        continue;
      // The cells of one side may be missing among ghost copies.
      node_numbers_[sliding] = number + mesh.n_vertices();
      positions_[sliding] = cell->vertex(v);
    }
  }
}


void HexSpace::find_faces()
{
  faces_.clear();
  const auto local = [&](const auto &cell) {
    return static_cast<std::uint32_t>(
      cells_partitioner_->global_to_local(cell->global_active_cell_index()));
  };
  for (const auto &cell : triangulation_->active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    for (const unsigned int f : cell->face_indices())
    {
      // The cell with the smaller number defines the face's orientation.
      Face face{local(cell), no_cell, {}, 0};
      unsigned int number = f;
      if (cell->at_boundary(f))
        face.boundary = cell->face(f)->boundary_id();
      else
      {
        const auto other = cell->neighbor(f);
        face.outside = local(other);
        face.boundary = dealii::numbers::internal_face_boundary_id;
        if (cell_numbers_[face.outside] < cell_numbers_[face.inside])
        {
          if (other->is_locally_owned())
            continue;
          std::swap(face.inside, face.outside);
          number = cell->neighbor_of_neighbor(f);
        }
      }
      for (unsigned int i = 0; i < 4; ++i)
        face.nodes[i] = cells_[face.inside][hex_faces[number][i]];
      faces_.push_back(face);
    }
  }
}


void HexSpace::find_cells_around()
{
  first_around_.assign(n_nodes() + 1, 0);
  for (const Cell &cell : cells_)
    for (const std::uint32_t node : cell)
      ++first_around_[node + 1];
  for (std::size_t n = 0; n < n_nodes(); ++n)
    first_around_[n + 1] += first_around_[n];
  around_.assign(first_around_.back(), 0);
  // Global order makes the result independent of the ranks.
  std::vector<std::uint32_t> order(cells_.size());
  for (std::uint32_t c = 0; c < order.size(); ++c)
    order[c] = c;
  std::sort(order.begin(),
            order.end(),
            [&](const std::uint32_t a, const std::uint32_t b) {
              return cell_numbers_[a] < cell_numbers_[b];
            });
  std::vector<std::uint32_t> next(first_around_.begin(),
                                  first_around_.end() - 1);
  for (const std::uint32_t c : order)
    for (const std::uint32_t node : cells_[c])
      around_[next[node]++] = c;
}


dealii::AlignedVector<double>
HexSpace::positions(const unsigned int width) const
{
  dealii::AlignedVector<double> result(width * n_nodes());
  for (std::size_t n = 0; n < n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
      result[width * n + d] = positions_[n][d];
  return result;
}
} // namespace contrecoup::ale
