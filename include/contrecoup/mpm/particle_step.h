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
/// Energies that steps added or lost since the start, summed over the particles
/// of this rank [J].
struct EnergyLedger
{
  double external_work = 0.; ///< work of external forces on the particles
  /// Kinetic energy that the grid gained but the particles did not.
  double transfer_loss = 0.;
  double contact_loss = 0.; ///< between velocity fields
};

/// Mass, momentum and energies of the particles of all ranks.
struct ParticleTotals
{
  double mass = 0.;
  std::array<double, 3> momentum{};
  double kinetic_energy = 0.;
  double internal_energy = 0.; ///< work of stresses since the start [J]
  double stored_energy = 0.;   ///< elastic energy of the present strains [J]
};

/**
 * One step of the material point method. Mass, momentum and forces are
 * transferred from the particles to the grid; the velocities of the grid are
 * transferred back; then strains and stresses of the particles are updated.
 * Stresses do work with the mean velocity of the step, so that the kinetic
 * energy of the grid and the internal energy are conserved together exactly;
 * the difference to the kinetic energy of the particles is the transfer loss.
 * Sulsky, Chen and Schreyer, Comput. Methods Appl. Mech. Eng. 118 (1994);
 * Nairn, CMES 4 (2003), for the order of the updates.
 */
class ParticleStep
{
public:
  /// Sets the external force column::force of the particles of a material [N].
  using OuterForces =
    std::function<void(const unsigned int material, ParticleBlock &particles)>;

  /// @param contact contact between velocity fields; by default the fields do
  /// not interact
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
  /// Contact force between velocity fields in the last step: sum of its
  /// magnitudes at the nodes of this rank [N].
  double field_force() const
  {
    return field_force_;
  }
  unsigned int n_retries() const
  {
    return n_retries_;
  }

  /// Computes the stresses of the initial particles.
  void start(const TileGrid &grid, Particles &particles) const;

  /// Computes the work values that steps need for particles read from a
  /// checkpoint.
  void resume(const TileGrid &grid, Particles &particles) const
  {
    smooth(grid, particles, true);
  }

  /**
   * Makes one step.
   * @param largest largest step size [s]; it is halved up to @p n_retries times
   * while the strain increment of a particle exceeds largest_strain
   * @return the step size
   * @throws NumericsError with position and state of the particle. Collective.
   */
  double advance(TileGrid &grid,
                 Particles &particles,
                 const double largest,
                 const unsigned int n_retries,
                 const OuterForces &forces);

  /// Totals of all ranks. Collective.
  ParticleTotals totals(const TileGrid &grid, const Particles &particles) const;

  /// Step size with a Courant number of 1 [s]. Collective.
  double signal_time(const TileGrid &grid, const Particles &particles) const;

  /// Strain increment of a particle beyond which the step size is halved [-].
  static constexpr double largest_strain = 0.2;

private:
  /// Nodal values of one velocity field.
  struct Field
  {
    NodeValues matter{7}; ///< mass, momentum, force
    NodeValues motion{6}; ///< acceleration, velocity after the step
    NodeValues before{3}; ///< velocity before the step
    NodeValues acceleration{3};
    std::vector<unsigned int> materials;
  };

  using Tile = std::pair<const TileGrid::Source *, Particles::TileBlocks *>;

  /// The tiles that contain particles of one of the given materials.
  std::vector<Tile> tiles(const std::vector<TileGrid::Source> &sources,
                          Particles &particles,
                          const std::vector<unsigned int> &materials) const;

  void deposit_fields(const TileGrid &grid,
                      Particles &particles,
                      const Deposit what);
  /// Adds volumes, and volumes times pressures or rates of dilatation, of a
  /// material to the nodes of linear splines; without exchange between ranks.
  void deposit_smoothed(const TileGrid &grid,
                        Particles &particles,
                        const unsigned int material,
                        const bool is_pressure,
                        NodeValues &sums) const;
  /// Interpolates the averages at the nodes of linear splines to
  /// column::smoothed of a material.
  void collect_smoothed(const TileGrid &grid,
                        Particles &particles,
                        const unsigned int material,
                        const NodeValues &values) const;
  /// Smooths pressures or rates of dilatation, and stores them in
  /// column::smoothed.
  void smooth(const TileGrid &grid,
              Particles &particles,
              const bool is_pressure) const;
  /// Replaces a nodal vector that was computed with lumped masses by that of
  /// the consistent mass matrix, in all fields, see
  /// TransferScheme::series_order. @param smallest_fraction nodes with a
  /// smaller fraction of the largest mass are treated as empty
  void apply_series(const TileGrid &grid,
                    Particles &particles,
                    const double smallest_fraction,
                    NodeValues Field::*vector);
  void multiply_mass_matrix(const TileGrid &grid,
                            Particles &particles,
                            std::vector<NodeValues> &from,
                            std::vector<NodeValues> &to) const;
  /// Finds the interfaces of velocity fields for the present particles.
  void find_interfaces(const TileGrid &grid, Particles &particles);
  void find_velocities(const TileGrid &grid, Particles &particles);
  void accelerate(const TileGrid &grid, Particles &particles);
  void set_motion(const TileGrid &grid, const double step);
  /// Applies the contact impulses between fields to the velocities after the
  /// step. Returns the sum of their magnitudes on this rank [N s].
  double apply_contact(const TileGrid &grid);
  /// Sets the velocities after the step to those before it, including contact
  /// impulses.
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
  /// Contact loss of the last set_motion(), of this rank [J].
  double step_contact_loss_ = 0.;
  double field_force_ = 0.;
  unsigned int n_retries_ = 0;
};
} // namespace contrecoup::mpm
