// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_layout.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/mpi.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Exchanges the state of ghost leaves, and one value per ghost leaf, between
 * ranks. It sends only the two layers of points next to each face that a ghost
 * shares with an owned leaf: all that the schemes read.
 */
template <int dim>
class GhostExchange
{
public:
  /// Sets up the communication pattern. Collective.
  void reinit(const LeafMesh<dim> &mesh, const LeafLayout &layout);

  /// Updates the ghost leaves in @p state and in @p leaf_values (one value per
  /// stored leaf). Collective.
  template <typename Real>
  void update(Real *state, Real *leaf_values);

private:
  struct Partner
  {
    unsigned int rank;
    std::vector<unsigned int> leaves; ///< leaf numbers on this rank
    std::vector<unsigned char> faces; ///< per leaf; bit f: face f is needed
    std::size_t n_values = 0;
    dealii::AlignedVector<char> buffer; ///< holds n_values values
  };

  /// Indices, relative to a leaf's offset, of the values that the faces of the
  /// bit mask @p faces need.
  const std::vector<std::size_t> &values_of(const unsigned char faces);
  void
  add(Partner &partner, const unsigned int leaf, const unsigned char faces);
  template <typename Real>
  void pack(Partner &partner, const Real *state, const Real *values);
  template <typename Real>
  void unpack(const Partner &partner, Real *state, Real *values);

  MPI_Comm communicator_ = MPI_COMM_SELF;
  LeafLayout layout_;
  std::map<unsigned char, std::vector<std::size_t>> values_of_;
  std::vector<Partner> owners_;  ///< ranks that own this rank's ghosts
  std::vector<Partner> readers_; ///< ranks that read this rank's leaves
  std::vector<MPI_Request> requests_;
};
} // namespace contrecoup::gas
