// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/field_exchange.h>

#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/dofs/dof_handler.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace contrecoup::ale
{
/// @throws InputError for an inverted cell, naming it
void require_valid_cells(const dealii::Triangulation<3> &mesh);

/**
 * A distributed conforming hexahedral mesh on deal.II's fully distributed
 * triangulation, with the local numbering of cells, nodes and faces. Each rank
 * owns cells and nodes, and has ghost copies of the cells around its own and
 * of their nodes. Local numbers begin with the owned entities.
 */
class HexSpace
{
public:
  /// An interior or boundary face.
  struct Face
  {
    /// the cell whose outward normal is that of the face
    std::uint32_t inside;
    std::uint32_t outside; ///< the neighbour, or no_cell at the boundary
    /// Corners, counterclockwise seen from outside of `inside`.
    std::array<std::uint32_t, 4> nodes;
    dealii::types::boundary_id boundary;
  };
  static constexpr std::uint32_t no_cell = -1;

  /// Corner nodes, ordered as in HexMesh.
  using Cell = std::array<std::uint32_t, 8>;

  /// Two coincident nodes on an interface with slip: one of the sliding
  /// region, one of the other side.
  struct SlidingPair
  {
    std::uint32_t sliding;
    std::uint32_t held;
  };

  /**
   * Distributes @p mesh, which all ranks must pass identically, in the order
   * of its cells. Material ids are region numbers. Collective.
   * @param slides by material id: whether the region has separate nodes where
   * it meets regions that do not slide; may be empty
   * @throws InputError for an inverted cell, naming it, and for a mesh with
   * cells of different levels
   */
  void reinit(const dealii::Triangulation<3> &mesh,
              MPI_Comm communicator,
              const std::vector<bool> &slides = {});

  MPI_Comm communicator() const;

  /// Continuous trilinear elements with three components, without the
  /// duplicate nodes of sliding regions.
  const dealii::DoFHandler<3> &node_dofs() const
  {
    return *dofs_;
  }

  /// First of the three consecutive degrees of freedom of a node; invalid for
  /// duplicate nodes of sliding regions.
  dealii::types::global_dof_index first_dof(const std::size_t node) const
  {
    return first_dofs_[node];
  }

  /// Local node number of a locally relevant degree of freedom.
  std::uint32_t node_of(const dealii::types::global_dof_index dof) const
  {
    return node_of_vertex_[vertices_->global_to_local(dof / 3)];
  }

  /// All pairs among local nodes, ghost copies included.
  const std::vector<SlidingPair> &sliding_pairs() const
  {
    return pairs_;
  }
  bool is_sliding(const std::size_t node) const
  {
    return first_dofs_[node] == dealii::numbers::invalid_dof_index;
  }

  /// Whether a face lies on an interface with slip.
  bool is_sliding(const Face &face) const
  {
    return face.outside != no_cell &&
           slides(face.inside) != slides(face.outside);
  }

  /// Whether a cell belongs to a sliding region.
  bool slides(const std::size_t cell) const
  {
    return !slides_.empty() && slides_[regions_[cell]];
  }
  dealii::Triangulation<3> &triangulation()
  {
    return *triangulation_;
  }

  std::size_t n_locally_owned_cells() const
  {
    return n_own_cells_;
  }
  std::size_t n_cells() const
  {
    return cells_.size();
  }
  std::size_t n_locally_owned_nodes() const
  {
    return n_own_nodes_;
  }
  std::size_t n_nodes() const
  {
    return node_numbers_.size();
  }

  const Cell &cell(const std::size_t cell) const
  {
    return cells_[cell];
  }
  unsigned int region(const std::size_t cell) const
  {
    return regions_[cell];
  }

  /// Global numbers in the given mesh, independent of the number of ranks.
  std::uint32_t cell_number(const std::size_t cell) const
  {
    return cell_numbers_[cell];
  }
  std::uint32_t node_number(const std::size_t node) const
  {
    return node_numbers_[node];
  }

  /// Faces of owned cells. A face between owned cells of two ranks is stored
  /// identically on both.
  const std::vector<Face> &faces() const
  {
    return faces_;
  }

  /// Local cells around a node; all of them for nodes of owned cells.
  dealii::ArrayView<const std::uint32_t>
  cells_around(const std::size_t node) const
  {
    return {&around_[first_around_[node]],
            first_around_[node + 1] - first_around_[node]};
  }

  /// Node coordinates of the given mesh in the first three of @p width numbers
  /// per node [m].
  dealii::AlignedVector<double> positions(const unsigned int width) const;

  /// Parallel partitioning of nodes and cells.
  const dealii::Utilities::MPI::Partitioner &nodes() const
  {
    return *nodes_;
  }
  const dealii::Utilities::MPI::Partitioner &cells() const
  {
    return *cells_partitioner_;
  }

  /// Cells and nodes of all ranks; 0 before reinit().
  std::uint64_t n_global_cells() const
  {
    return cells_partitioner_ ? cells_partitioner_->size() : 0;
  }
  std::uint64_t n_global_nodes() const
  {
    return nodes_ ? nodes_->size() : 0;
  }

private:
  void distribute(const dealii::Triangulation<3> &mesh, MPI_Comm communicator);
  void number_nodes();
  /// Global numbers of the nodes at a vertex; twice the same number at a
  /// vertex with one node.
  using VertexNodes = std::array<dealii::types::global_dof_index, 2>;

  std::vector<bool> find_double_vertices() const;
  std::vector<VertexNodes>
  numbers_of_nodes(const std::vector<bool> &is_double) const;
  void number_nodes(const std::vector<bool> &is_double);
  void number_cells(const dealii::Triangulation<3> &mesh);
  void find_faces();
  void find_cells_around();

  std::unique_ptr<dealii::parallel::fullydistributed::Triangulation<3>>
    triangulation_;
  std::unique_ptr<dealii::DoFHandler<3>> dofs_;
  std::vector<bool> slides_; ///< by region; may be empty
  /// Partitioning of mesh vertices (three degrees of freedom each) and of
  /// nodes, of which two may belong to one vertex.
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> vertices_;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> nodes_;
  std::vector<std::uint32_t> node_of_vertex_;
  std::vector<dealii::types::global_dof_index> first_dofs_;
  std::vector<SlidingPair> pairs_;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> cells_partitioner_;
  std::size_t n_own_cells_ = 0;
  std::size_t n_own_nodes_ = 0;
  std::vector<Cell> cells_;
  std::vector<unsigned char> regions_;
  std::vector<std::uint32_t> cell_numbers_;
  std::vector<std::uint32_t> node_numbers_;
  std::vector<dealii::Point<3>> positions_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> first_around_;
  std::vector<std::uint32_t> around_;
};
} // namespace contrecoup::ale
