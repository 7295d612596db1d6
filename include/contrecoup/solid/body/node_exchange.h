// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/solid_mesh.h>

namespace contrecoup::solid
{
/// Sums values at nodes that ranks share. The summation follows the order of
/// ranks, so all ranks obtain bitwise identical sums.
class NodeExchange
{
public:
  void reinit(const SolidMesh &mesh, MPI_Comm communicator);

  /**
   * Sums the first @p width of @p stride values per node over all ranks.
   * Collective.
   */
  template <typename Real>
  void
  add(Real *values, const unsigned int width, const unsigned int stride) const;

private:
  template <typename Real>
  void add_up(Real *values,
              const unsigned int width,
              const unsigned int stride,
              const std::vector<Real> &own,
              const std::vector<std::vector<Real>> &in) const;

  MPI_Comm communicator_ = MPI_COMM_SELF;
  int rank_ = 0;
  std::vector<SolidMesh::Neighbor> neighbors_;
  std::vector<std::uint32_t> shared_; ///< shared nodes, each once
};
} // namespace contrecoup::solid
