// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/node_exchange.h>
#include <contrecoup/solid/solid_mesh.h>

#include <vector>

namespace contrecoup::solid
{
/**
 * Averages over neighbours of what the elements of one tissue have: a node has
 * the mean of its elements of this tissue, weighted with their volumes, and an
 * element the mean of its corners.
 *
 * Pressures of elements whose corners carry all velocities are not unique
 * where matter is nearly incompressible: those that alternate from element to
 * element push no node between them. In a regular mesh this average removes
 * them exactly, as it multiplies a wave by cos^2(k h / 2) along each edge; a
 * wave of ten elements loses a tenth. The pressure is that of Bonet and
 * Burton, Commun. Numer. Meth. Engng. 14 (1998) 437, here for measures alone,
 * not for forces.
 */
class TissueAverage
{
public:
  /// @param tissue index in the mesh; one that it does not have is empty
  /// @param exchange of the mesh, is kept
  void reinit(const SolidMesh &mesh,
              const NodeExchange &exchange,
              const unsigned int tissue);

  /// The elements of the tissue, ascending: numbers in the mesh of this rank.
  const std::vector<std::uint32_t> &cells() const
  {
    return cells_;
  }

  /// Undeformed volumes of cells() [m^3].
  const std::vector<double> &volumes() const
  {
    return volumes_;
  }

  /// The average of @p values, by cells(). Collective.
  std::vector<double> average(const std::vector<double> &values) const;

private:
  /// Sums over the elements of all ranks at each node of the tissue.
  std::vector<double> nodal_sums(const std::vector<double> &values) const;

  const NodeExchange *exchange_ = nullptr;
  std::size_t n_mesh_nodes_ = 0;
  bool alone_ = true; ///< whether no other rank has nodes of this one
  std::vector<std::uint32_t> cells_;
  std::vector<double> volumes_;
  std::vector<std::uint32_t> nodes_;             ///< of the tissue
  std::vector<std::array<std::uint32_t, 8>> at_; ///< in nodes_, by cells_
  std::vector<double> inverse_volumes_;          ///< around nodes_ [1/m^3]
};
} // namespace contrecoup::solid
