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
 * Brings the state of ghost leaves, and one number for each, from the ranks
 * that own them: the two layers of points at each face where this rank's own
 * leaves meet the ghost, which is all that the schemes read of it.
 */
template <int dim>
class GhostExchange
{
public:
  /// Agrees with the neighbouring ranks on what is sent. Collective.
  void reinit(const LeafMesh<dim> &mesh, const LeafLayout &layout);

  /// Fills the ghost leaves of @p state and the ghost part of
  /// @p leaf_values (one number per stored leaf). Collective.
  template <typename Real>
  void update(Real *state, Real *leaf_values);

private:
  struct Partner
  {
    unsigned int rank;
    std::vector<unsigned int> leaves; ///< leaf numbers on this rank
    std::vector<unsigned char> faces; ///< of each, bit f: face f is needed
    std::size_t n_values = 0;
    dealii::AlignedVector<char> buffer; ///< room for them
  };

  /// Positions of the values that the faces of a mask need.
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
  std::vector<Partner> owners_;  ///< of this rank's ghost leaves
  std::vector<Partner> readers_; ///< of this rank's own leaves
  std::vector<MPI_Request> requests_;
};
} // namespace contrecoup::gas
