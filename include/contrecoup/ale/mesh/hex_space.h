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
 * A conforming mesh of hexahedra on the ranks, by deal.II's fully distributed
 * triangulation, with the numbers that loops over elements need. Each rank owns
 * cells and nodes, and has copies of the cells around its own and of their
 * nodes; numbers here are those of the rank, the own ones first.
 */
class HexSpace
{
public:
  /// A face between cells, or of the boundary.
  struct Face
  {
    std::uint32_t inside;  ///< cell whose outward normal the face has
    std::uint32_t outside; ///< the other one; no_cell at the boundary
    /// Corners, counterclockwise seen from outside of `inside`.
    std::array<std::uint32_t, 4> nodes;
    dealii::types::boundary_id boundary;
  };
  static constexpr std::uint32_t no_cell = -1;

  /// Corners as in HexMesh.
  using Cell = std::array<std::uint32_t, 8>;

  /// Two nodes at one place of an interface along which a region slides: that
  /// of the region, and that of what it slides along.
  struct SlidingPair
  {
    std::uint32_t sliding;
    std::uint32_t held;
  };

  /**
   * Distributes @p mesh, which every rank must have alike, along the order of
   * its cells. Material ids say to which region a cell belongs. Collective.
   * @param slides by material id: whether the region has nodes of its own where
   *   it meets regions that do not slide; may be empty
   * @throws InputError for an inverted cell, naming it, and for a mesh with
   * cells of different levels
   */
  void reinit(const dealii::Triangulation<3> &mesh,
              MPI_Comm communicator,
              const std::vector<bool> &slides = {});

  MPI_Comm communicator() const
  {
    return triangulation_->get_communicator();
  }

  /// Three continuous trilinear components at the nodes that do not slide.
  const dealii::DoFHandler<3> &node_dofs() const
  {
    return *dofs_;
  }

  /// The first of the three degrees of freedom of a node, which follow each
  /// other; not of sliding nodes.
  dealii::types::global_dof_index first_dof(const std::size_t node) const
  {
    return first_dofs_[node];
  }

  /// The node of a degree of freedom that this rank knows.
  std::uint32_t node_of(const dealii::types::global_dof_index dof) const
  {
    return node_of_vertex_[vertices_->global_to_local(dof / 3)];
  }

  /// Of the nodes that this rank owns or has copies of.
  const std::vector<SlidingPair> &sliding_pairs() const
  {
    return pairs_;
  }
  bool is_sliding(const std::size_t node) const
  {
    return first_dofs_[node] == dealii::numbers::invalid_dof_index;
  }

  /// Whether the cells of a face have nodes of their own there.
  bool is_sliding(const Face &face) const
  {
    return face.outside != no_cell &&
           slides(face.inside) != slides(face.outside);
  }

  /// Whether the region of a cell slides along others.
  bool slides(const std::size_t cell) const
  {
    return !slides_.empty() && slides_[regions_[cell]];
  }
  dealii::Triangulation<3> &triangulation()
  {
    return *triangulation_;
  }

  std::size_t n_own_cells() const
  {
    return n_own_cells_;
  }
  std::size_t n_cells() const
  {
    return cells_.size();
  }
  std::size_t n_own_nodes() const
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

  /// Numbers in the mesh that was given, the same on any number of ranks.
  std::uint32_t cell_number(const std::size_t cell) const
  {
    return cell_numbers_[cell];
  }
  std::uint32_t node_number(const std::size_t node) const
  {
    return node_numbers_[node];
  }

  /// Faces of the own cells; those that own cells of two ranks share are with
  /// both, and the same there.
  const std::vector<Face> &faces() const
  {
    return faces_;
  }

  /// The cells around a node, as far as they are here: all of them for nodes of
  /// own cells.
  dealii::ArrayView<const std::uint32_t>
  cells_around(const std::size_t node) const
  {
    return {&around_[first_around_[node]],
            first_around_[node + 1] - first_around_[node]};
  }

  /// Coordinates of the nodes in the mesh that was given, @p width numbers at
  /// each, the first three of which are set [m].
  dealii::AlignedVector<double> positions(const unsigned int width) const;

  /// Who has which nodes and cells.
  const dealii::Utilities::MPI::Partitioner &nodes() const
  {
    return *nodes_;
  }
  const dealii::Utilities::MPI::Partitioner &cells() const
  {
    return *cells_partitioner_;
  }

private:
  void distribute(const dealii::Triangulation<3> &mesh, MPI_Comm communicator);
  void number_nodes();
  /// Numbers of the nodes of a vertex on all ranks; twice the same where it has
  /// but one.
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
  /// Vertices of the mesh, one for three degrees of freedom, and nodes, of
  /// which some are at the same vertex.
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
