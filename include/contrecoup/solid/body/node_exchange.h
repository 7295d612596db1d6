// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/solid_mesh.h>

namespace contrecoup::solid
{
/// Adds up what ranks found at the nodes that they share, in the order of the
/// ranks: all get the same bits.
class NodeExchange
{
public:
  void reinit(const SolidMesh &mesh, MPI_Comm communicator);

  /**
   * @p values holds @p stride numbers for each node, the first @p width of
   * which are added. Collective.
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
  std::vector<std::uint32_t> shared_; ///< each node once
};
} // namespace contrecoup::solid
