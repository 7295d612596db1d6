// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/slip_ties.h>
#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/rezone/bounded_flows.h>
#include <contrecoup/ale/rezone/reconstruction.h>

namespace contrecoup::ale
{
/**
 * Conservative remap to a mesh of the same topology, by the volumes that faces
 * sweep. Mass, momentum and total energy are conserved to round-off:
 * - Momentum is advected with the mass as eight corner velocities per cell,
 *   and each node collects the eighths of its cells (half-index shift, Benson
 *   1992). Nodes that do not move keep their velocity to round-off.
 * - Advected kinetic energy is that of the advected momentum. The energy that
 *   the averaged nodal velocity loses becomes internal energy of the adjacent
 *   cells (DeBar 1974), which is Galilean invariant.
 *
 * With a strict limiter, density, specific internal energy, mass fraction and
 * velocity components stay within neighbouring values, except for the internal
 * energy gained from averaging, and as long as no cell loses more than its
 * volume.
 */
class Remap
{
public:
  /// @param is_at_rest whether a region's nodes never move, by material id;
  /// may be empty
  void reinit(const HexSpace &space,
              const std::vector<bool> &is_at_rest = {},
              const RemapLimiter limiter = RemapLimiter::keep_smooth_extrema);

  /**
   * @param walls impose the new wall velocities
   * @param position of the nodes after the remap. Nodes between regions may
   * only slide, and boundary nodes may only move along their boundary.
   * @throws NumericsError, naming the cell, when a node of a region at rest
   * would move, or when a cell loses more mass than it has
   */
  void apply(AleState &state,
             const SlipWalls &walls,
             const dealii::AlignedVector<double> &position);

private:
  /// Fields of the reconstruction: density, specific internal energy, mass
  /// fraction of products, corner velocities.
  static constexpr unsigned int density = 0, energy = 1, products = 2,
                                velocity = 3, n_fields = 27;
  /// Advected contents: mass, then mass times each other field, then corner
  /// kinetic energies.
  static constexpr unsigned int kinetic = n_fields, n_contents = n_fields + 8;

  /// Sums at each node: momentum, mass, kinetic energy, and eighths of the old
  /// masses of its cells.
  static constexpr unsigned int n_sums = 6;

  void fill_fields(const AleState &state);
  void carry_over(const AleState &state,
                  const dealii::AlignedVector<double> &position);
  void carry_face(const AleState &state,
                  const dealii::AlignedVector<double> &position,
                  const HexSpace::Face &face);
  /// Adds the gain of `inside` through a face, n_fields numbers.
  void add_flow(const HexSpace::Face &face,
                const std::uint32_t donor,
                const double *carried);
  /// Whether nothing passes through a face.
  bool is_closed(const HexSpace::Face &face) const;
  /// Whether the nodes of a cell never move; false for no_cell.
  bool rests(const std::uint32_t cell) const;
  void check_boundary(const AleState &state,
                      const HexSpace::Face &face,
                      const double swept) const;
  void check_masses(const AleState &state) const;
  /// Adds the part of the nodal mass beyond eighths of its cells, and replaces
  /// the old eighths by the factor on the heat.
  static void add_unadvected_mass(const AleState &state,
                                  const double *velocity,
                                  double *sum);
  void collect(AleState &state,
               const SlipWalls &walls,
               const dealii::AlignedVector<double> &position);

  const HexSpace *space_ = nullptr;
  std::vector<bool> is_at_rest_;             ///< by region
  std::vector<std::uint32_t> cells_;         ///< owned cells in the remap
  std::vector<std::uint32_t> cells_at_rest_; ///< the other owned cells
  SlipTies ties_;
  RemapLimiter limiter_ = RemapLimiter::keep_smooth_extrema;
  BoundedFlows flows_; ///< for the strict limiter
  Reconstruction reconstruction_;
  FieldExchange node_exchange_, cell_exchange_;
  dealii::AlignedVector<double> fields_; ///< of all cells
  std::vector<double> contents_;         ///< of owned cells after the remap
};
} // namespace contrecoup::ale
