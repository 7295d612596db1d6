// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/field_contact.h>
#include <contrecoup/mpm/node_values.h>
#include <contrecoup/mpm/particle_material.h>
#include <contrecoup/mpm/particles.h>
#include <contrecoup/mpm/tile_grid.h>
#include <contrecoup/mpm/transfer_kernels.h>
#include <contrecoup/mpm/transfer_scheme.h>

#include <functional>
#include <vector>

namespace contrecoup::mpm
{
/// What steps do with energy, this rank's sums from the start on [J].
struct EnergyLedger
{
  double external_work = 0.; ///< of forces from outside on the particles
  /// Kinetic energy that the grid gained and the particles did not.
  double transfer_loss = 0.;
  double contact_loss = 0.; ///< between velocity fields
};

/// Mass, momentum and energies of the particles, all ranks.
struct ParticleTotals
{
  double mass = 0.;
  std::array<double, 3> momentum{};
  double kinetic_energy = 0.;
  double internal_energy = 0.; ///< work of stresses so far [J]
  double stored_energy = 0.;   ///< in the present strains [J]
};

/**
 * One step of the material point method: particles give mass, momentum and
 * forces to the grid, get velocities back, and are strained. Energy of stress
 * work is that of the mean velocity of the step, so that the grid's kinetic
 * energy and the internal energy add up exactly; what particles' kinetic energy
 * misses is booked as loss of the transfer. Sulsky, Chen and Schreyer, Comput.
 * Methods Appl. Mech. Eng. 118 (1994); Nairn, CMES 4 (2003), for the orders.
 */
class ParticleStep
{
public:
  /// Sets column::force of the particles of a material [N].
  using OuterForces =
    std::function<void(const unsigned int material, ParticleBlock &particles)>;

  /// @param contact of velocity fields; none: they do not feel each other
  ParticleStep(const TransferScheme &scheme,
               const std::vector<ParticleMaterial> &materials,
               const FieldContact &contact = FieldContact());

  const std::vector<ParticleMaterial> &materials() const
  {
    return materials_;
  }
  const EnergyLedger &ledger() const
  {
    return ledger_;
  }
  void set_ledger(const EnergyLedger &ledger)
  {
    ledger_ = ledger;
  }
  /// Of velocity fields on each other in the last step, this rank's sum of
  /// magnitudes at the nodes [N].
  double field_force() const
  {
    return field_force_;
  }
  unsigned int n_retries() const
  {
    return n_retries_;
  }

  /// Stresses of the particles as they are.
  void start(const TileGrid &grid, Particles &particles) const;

  /// Makes what steps need of particles that come from a checkpoint.
  void resume(const TileGrid &grid, Particles &particles) const
  {
    smooth(grid, particles, true);
  }

  /**
   * Goes one step ahead.
   * @param largest step size, which is halved up to @p n_retries times while
   *   a particle would be strained by more than largest_strain
   * @return the step size
   * @throws NumericsError with the place and the state. Collective.
   */
  double advance(TileGrid &grid,
                 Particles &particles,
                 const double largest,
                 const unsigned int n_retries,
                 const OuterForces &forces);

  /// Of all ranks. Collective.
  ParticleTotals totals(const TileGrid &grid, const Particles &particles) const;

  /// The largest step size for a Courant number of 1 [s]. Collective.
  double signal_time(const TileGrid &grid, const Particles &particles) const;

  /// Strain of a particle in one step beyond which it is halved [-].
  static constexpr double largest_strain = 0.2;

private:
  /// One velocity field on the grid.
  struct Field
  {
    NodeValues matter{7}; ///< mass, momentum, force
    NodeValues motion{6}; ///< acceleration, velocity after the step
    NodeValues before{3}; ///< velocity before the step
    NodeValues acceleration{3};
    std::vector<unsigned int> materials;
  };

  using Tile = std::pair<const TileGrid::Source *, Particles::TileBlocks *>;

  /// Those that hold particles of some materials.
  std::vector<Tile> tiles(const std::vector<TileGrid::Source> &sources,
                          Particles &particles,
                          const std::vector<unsigned int> &materials) const;

  void deposit_fields(const TileGrid &grid,
                      Particles &particles,
                      const Deposit what);
  /// Volumes, and volumes times pressures or rates of dilatation, of a material
  /// at linear splines' nodes; added to those
  /// that are there; copies not added.
  void deposit_smoothed(const TileGrid &grid,
                        Particles &particles,
                        const unsigned int material,
                        const bool is_pressure,
                        NodeValues &sums) const;
  /// Averages at linear splines' nodes to column::smoothed of a material.
  void collect_smoothed(const TileGrid &grid,
                        Particles &particles,
                        const unsigned int material,
                        const NodeValues &values) const;
  /// Pressures or rates of dilatation to column::smoothed.
  void smooth(const TileGrid &grid,
              Particles &particles,
              const bool is_pressure) const;
  /// Makes a vector of lumped masses that of the consistent ones, in all
  /// fields. @param smallest_fraction of the largest mass, below which a node
  /// has none
  void apply_series(const TileGrid &grid,
                    Particles &particles,
                    const double smallest_fraction,
                    NodeValues Field::*vector);
  void multiply_mass_matrix(const TileGrid &grid,
                            Particles &particles,
                            std::vector<NodeValues> &from,
                            std::vector<NodeValues> &to) const;
  /// Where velocity fields meet, with the particles as they lie.
  void find_interfaces(const TileGrid &grid, Particles &particles);
  void find_velocities(const TileGrid &grid, Particles &particles);
  void accelerate(const TileGrid &grid, Particles &particles);
  void set_motion(const TileGrid &grid, const double step);
  /// Lets the velocities after the step of fields push each other. Returns
  /// the sum of impulses, this rank [N s].
  double apply_contact(const TileGrid &grid);
  /// Takes those before the step as those after it, with such pushes.
  void reset_to_velocities_before(const TileGrid &grid);
  void collect(const TileGrid &grid, Particles &particles, const double step);
  double largest_strain_rate(const Particles &particles,
                             const MPI_Comm communicator) const;
  void
  move_particles(const TileGrid &grid, Particles &particles, const double step);
  void collect_rates(const TileGrid &grid, Particles &particles) const;
  void
  strain(const TileGrid &grid, Particles &particles, const double step) const;
  [[noreturn]] void throw_step_failure(const Particles &particles,
                                       const double step,
                                       const MPI_Comm communicator) const;

  TransferScheme scheme_;
  std::vector<ParticleMaterial> materials_;
  std::vector<Field> fields_;
  FieldContact contact_;
  EnergyLedger ledger_;
  double step_contact_loss_ = 0.; ///< of the last motion, this rank [J]
  double field_force_ = 0.;
  unsigned int n_retries_ = 0;
};
} // namespace contrecoup::mpm
