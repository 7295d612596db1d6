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
 * Volume-weighted averaging of an element quantity: each node takes the mean
 * of its elements, weighted with their volumes, and each element takes the
 * mean of its corners.
 *
 * One-point pressures in nearly incompressible matter contain checkerboard
 * modes, which alternate from element to element and exert no nodal force. On
 * a regular mesh this average removes the checkerboard modes exactly: it
 * multiplies a wave by cos^2(k h / 2) along each edge, so that a wave of ten
 * elements loses a tenth of its amplitude. The averaged pressure is that of
 * Bonet and Burton, Commun. Numer. Meth. Engng. 14 (1998) 437. It is used for
 * measures only, not for forces.
 */
class NodalAverage
{
public:
  using Corners = std::array<std::uint32_t, 8>;
  /// Sums the values at shared nodes over all ranks. The vector has one value
  /// per node of this rank's mesh and receives the sums.
  using AddRanks = std::function<void(dealii::AlignedVector<double> &)>;

  /**
   * @param corners node numbers of each element, in this rank's mesh
   * @param volumes of the elements [m^3]
   * @param n_nodes number of nodes of this rank's mesh
   * @param add_ranks may be empty if no other rank shares nodes
   */
  void reinit(std::vector<Corners> corners,
              std::vector<double> volumes,
              const std::size_t n_nodes,
              AddRanks add_ranks);

  /// Volume of each element [m^3].
  const std::vector<double> &volumes() const
  {
    return volumes_;
  }

  /// Returns the average of @p values, both by element. Collective.
  std::vector<double> average(const std::vector<double> &values) const;

private:
  /// Sums over the elements of all ranks at each of nodes_.
  std::vector<double> nodal_sums(const std::vector<double> &values) const;

  AddRanks add_ranks_;
  std::size_t n_mesh_nodes_ = 0;
  std::vector<double> volumes_;
  std::vector<std::uint32_t> nodes_;    ///< nodes of the elements, each once
  std::vector<Corners> corner_indices_; ///< positions of the corners in nodes_
  std::vector<double> inverse_volumes_; ///< per node of nodes_ [1/m^3]
};
} // namespace contrecoup::solid
