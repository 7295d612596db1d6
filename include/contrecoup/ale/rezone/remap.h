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
 * Carries what a mesh has over to the same mesh with nodes elsewhere, by what
 * each face sweeps. Mass, momentum and total energy stay to round-off:
 * - momentum goes with the mass as eight velocities of a cell, those at its
 *   corners, and each node collects the eighths of its cells (Benson 1992, half
 *   index shift): nodes that do not move keep their velocity to round-off;
 * - kinetic energy is carried as that of the momentum that a face passes, and
 *   what the mean velocity of a node lacks of it becomes internal energy of its
 *   cells (DeBar 1974): the same from whatever moving frame it is seen.
 * With a strict limiter no density, internal energy per mass, mass fraction or
 * component of the velocity is beyond those around, but for the energy that
 * velocities leave, and as long as no cell loses more than its volume.
 */
class Remap
{
public:
  /// @param is_at_rest whether a region's nodes never move, by material id;
  ///   may be empty
  void reinit(const HexSpace &space,
              const std::vector<bool> &is_at_rest = {},
              const RemapLimiter limiter = RemapLimiter::keep_smooth_extrema);

  /**
   * @param walls that the new velocities obey
   * @param position of the nodes afterwards; those between regions but sliding
   *   ones, and those of boundaries but along them, must not move
   * @throws NumericsError, naming the cell, when a node of a region at rest
   *   would move, or when a cell loses more mass than it has
   */
  void apply(AleState &state,
             const SlipWalls &walls,
             const dealii::AlignedVector<double> &position);

private:
  /// Linear functions in each cell: density, internal energy per mass, mass
  /// fraction of products, velocities at the corners.
  static constexpr unsigned int density = 0, energy = 1, products = 2,
                                velocity = 3, n_fields = 27;
  /// What is carried of each: the same times mass, which comes first, and
  /// kinetic energies of the corners.
  static constexpr unsigned int kinetic = n_fields, n_contents = n_fields + 8;

  /// Of each node: momentum, mass, kinetic energy, and eighths of the masses of
  /// its cells before.
  static constexpr unsigned int n_sums = 6;

  void fill_fields(const AleState &state);
  void carry_over(const AleState &state,
                  const dealii::AlignedVector<double> &position);
  void carry_face(const AleState &state,
                  const dealii::AlignedVector<double> &position,
                  const HexSpace::Face &face);
  /// Adds what `inside` gains through a face, n_fields numbers.
  void add_flow(const HexSpace::Face &face,
                const std::uint32_t donor,
                const double *carried);
  /// Whether nothing is carried through a face.
  bool is_closed(const HexSpace::Face &face) const;
  /// Whether the nodes of a cell never move; not those of no cell.
  bool rests(const std::uint32_t cell) const;
  void check_boundary(const AleState &state,
                      const HexSpace::Face &face,
                      const double swept) const;
  void check_masses(const AleState &state) const;
  /// Adds what the mass of a node has beyond eighths of its cells, and replaces
  /// the eighths before by what heat is multiplied with.
  static void
  add_rest(const AleState &state, const double *velocity, double *sum);
  void collect(AleState &state,
               const SlipWalls &walls,
               const dealii::AlignedVector<double> &position);

  const HexSpace *space_ = nullptr;
  std::vector<bool> is_at_rest_;             ///< by region
  std::vector<std::uint32_t> cells_;         ///< own ones, carried over
  std::vector<std::uint32_t> cells_at_rest_; ///< the other own ones
  SlipTies ties_;
  RemapLimiter limiter_ = RemapLimiter::keep_smooth_extrema;
  BoundedFlows flows_; ///< of a strict limiter
  Reconstruction reconstruction_;
  FieldExchange node_exchange_, cell_exchange_;
  dealii::AlignedVector<double> fields_; ///< of all cells
  std::vector<double> contents_;         ///< of own cells afterwards
};
} // namespace contrecoup::ale
