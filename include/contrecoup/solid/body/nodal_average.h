// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace contrecoup::solid
{
/**
 * Averages over neighbours of what some elements have: a node has the mean of
 * its elements, weighted with their volumes, and an element the mean of its
 * corners.
 *
 * Pressures of elements whose corners carry all velocities are not unique
 * where matter is nearly incompressible: those that alternate from element to
 * element push no node between them. In a regular mesh this average removes
 * them exactly, as it multiplies a wave by cos^2(k h / 2) along each edge; a
 * wave of ten elements loses a tenth. The pressure is that of Bonet and
 * Burton, Commun. Numer. Meth. Engng. 14 (1998) 437, here for measures alone,
 * not for forces.
 */
class NodalAverage
{
public:
  using Corners = std::array<std::uint32_t, 8>;
  /// Adds up what ranks found, a number at each node of the mesh of this rank;
  /// those of its elements get the sum.
  using AddRanks = std::function<void(dealii::AlignedVector<double> &)>;

  /**
   * @param corners of the elements: nodes of the mesh of this rank
   * @param volumes of the elements [m^3]
   * @param n_nodes of the mesh of this rank
   * @param add_ranks none: no other rank has nodes of this one
   */
  void reinit(std::vector<Corners> corners,
              std::vector<double> volumes,
              const std::size_t n_nodes,
              AddRanks add_ranks);

  /// By element [m^3].
  const std::vector<double> &volumes() const
  {
    return volumes_;
  }

  /// The average of @p values, by element. Collective.
  std::vector<double> average(const std::vector<double> &values) const;

private:
  /// Sums over the elements of all ranks at each of nodes_.
  std::vector<double> nodal_sums(const std::vector<double> &values) const;

  AddRanks add_ranks_;
  std::size_t n_mesh_nodes_ = 0;
  std::vector<double> volumes_;
  std::vector<std::uint32_t> nodes_;    ///< of the elements
  std::vector<Corners> at_;             ///< in nodes_, by element
  std::vector<double> inverse_volumes_; ///< around nodes_ [1/m^3]
};
} // namespace contrecoup::solid
