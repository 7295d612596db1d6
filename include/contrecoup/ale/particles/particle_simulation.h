// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/particles/particle_head.h>
#include <contrecoup/ale/particles/particle_probes.h>
#include <contrecoup/ale/particles/particle_reference.h>
#include <contrecoup/ale/particles/particle_regions.h>
#include <contrecoup/ale/record/contact_history.h>
#include <contrecoup/base/run/recorder_set.h>
#include <contrecoup/mpm/particle_step.h>

#include <memory>
#include <vector>

namespace contrecoup::ale
{
/// All recorders of particles.
using ParticleRecorders = RecorderSet<ParticleRecorder,
                                      ParticleProbes,
                                      ContactHistory<ParticleSnapshot>,
                                      RegionContact,
                                      ParticleReference,
                                      ParticleRegions,
                                      ParticleHead>;

/// Largest energies over the history rows so far, of the whole matter [J].
struct LargestEnergies
{
  double any = 0.;        ///< kinetic or internal
  double given_back = 0.; ///< by the matter beyond what it had stored
  double wall_work = 0.;  ///< of planes and body forces, but for friction
};

/// Numbers of steps and of particles that adapt() has added and removed.
struct ResampledParticles
{
  std::uint64_t n_steps = 0;
  std::uint64_t n_split = 0;
  std::uint64_t n_merged = 0; ///< net decrease of the number of particles
};

/// Solids and liquids by the material point method: time steps, resampling,
/// energy balance and output.
class ParticleSimulation : public Simulation
{
public:
  explicit ParticleSimulation(MPI_Comm communicator)
    : communicator_(communicator)
  {}

  /// Reads the entries that AleSimulation and ParticleScene declare.
  /// @throws InputError
  void parse_parameters(dealii::ParameterHandler &prm);

  CostEstimate estimate() override;
  void setup() override;
  void restore(const std::string &folder) override;
  void save(const std::string &folder) override;
  double time() const override
  {
    return time_;
  }
  StepReport advance(double largest_step) override;
  /// Splits and merges particles.
  bool adapt() override;
  std::vector<NamedValue> history() override;
  std::vector<NamedValue> probes() override;
  std::vector<FieldFile> write_fields(const std::string &folder,
                                      unsigned int index) override;
  std::vector<NamedValue> errors() override;
  std::vector<NamedValue> results() override;
  std::vector<NamedValue> checks() override;
  std::vector<Assumption> plan() override;
  std::vector<Assumption> audit() override;
  void finish(const std::string &folder) override;
  std::pair<std::uint64_t, std::uint64_t> size() const override
  {
    return {n_particles_, 6 * n_particles_};
  }

private:
  /// Energies of all ranks, and the residual of the balance [J].
  struct EnergyLedger
  {
    mpm::ParticleTotals totals;
    double external_work, transfer_loss, contact_loss, residual;
  };

  /// @throws InputError for entries that only moving meshes have
  static void refuse_entries_of_meshes(dealii::ParameterHandler &prm);
  /// Compares the entries with one another and with the matter.
  /// @throws InputError for those that contradict others or select nothing
  void check_scene();
  void build_grid();
  /// Sets column::force to the body force at the initial positions.
  void set_body_force(mpm::ParticleBlock &block) const;
  void add_contact(const double step);
  ParticleSnapshot snapshot();
  EnergyLedger ledger() const;
  ImpactPlan impact_plan() const;
  /// Grid cells across each layer around the brain of a head.
  std::vector<NamedValue> cells_across() const;
  /// Whether the spline width resolves the layers of a head.
  Assumption layer_resolution() const;
  /// Reads the particles of tiles on this rank.
  void restore_part(io::StateReader &in);

  MPI_Comm communicator_;
  ImpactScene impact_;
  ParticleScene scene_;

  mpm::TileGrid grid_;
  mpm::Particles particles_;
  std::unique_ptr<mpm::ParticleStep> step_;
  mpm::WallContact contact_;
  ContactMeasures contact_now_; ///< of all ranks
  std::uint64_t n_particles_ = 0;
  ResampledParticles resampled_;
  double time_ = 0.;
  double initial_energy_ = 0.;
  LargestEnergies largest_;
  ParticleRecorders recorders_;
};
} // namespace contrecoup::ale
