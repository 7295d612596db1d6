// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/field_exchange.h>

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

  /**
   * Distributes @p mesh, which every rank must have alike, along the order of
   * its cells. Material ids say to which region a cell belongs. Collective.
   * @throws InputError for an inverted cell, naming it, and for a mesh with
   * cells of different levels
   */
  void reinit(const dealii::Triangulation<3> &mesh, MPI_Comm communicator);

  MPI_Comm communicator() const
  {
    return triangulation_->get_communicator();
  }

  /// Three continuous trilinear components at the nodes: those of node n are
  /// the local degrees of freedom 3 n to 3 n + 2.
  const dealii::DoFHandler<3> &node_dofs() const
  {
    return *dofs_;
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
  void number_cells(const dealii::Triangulation<3> &mesh);
  void find_faces();
  void find_cells_around();

  std::unique_ptr<dealii::parallel::fullydistributed::Triangulation<3>>
    triangulation_;
  std::unique_ptr<dealii::DoFHandler<3>> dofs_;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> nodes_;
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
