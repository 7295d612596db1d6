// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/heat_source.h>
#include <contrecoup/ale/record/contact_history.h>
#include <contrecoup/ale/record/head_measures.h>
#include <contrecoup/ale/record/probe_cells.h>
#include <contrecoup/ale/record/reference.h>
#include <contrecoup/ale/record/region_history.h>
#include <contrecoup/ale/rezone/rezone.h>
#include <contrecoup/base/run/recorder_set.h>
#include <contrecoup/base/run/simulation.h>

namespace contrecoup::ale
{
/// All recorders of a moving mesh.
using AleRecorders = RecorderSet<AleRecorder,
                                 ProbeCells,
                                 ContactHistory<AleSnapshot>,
                                 Reference,
                                 RegionHistory,
                                 HeadMeasures>;

/// Energies of the computed part that the balance refers to [J].
struct KnownEnergies
{
  double initial = 0.;
  double initial_kinetic = 0.;
  double largest = 0.;
};

/**
 * The ALE solver for solids and fluids: the mesh moves with the matter, and
 * the mesh of fluids is rezoned at intervals. Steps, energy balance and
 * output.
 */
class AleSimulation : public Simulation
{
public:
  explicit AleSimulation(MPI_Comm communicator)
    : communicator_(communicator)
  {}

  /// Declares every entry.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads every entry. @throws InputError
  void parse_parameters(dealii::ParameterHandler &prm);

  CostEstimate estimate() override;
  void setup() override;
  void restore(const std::string &folder) override;
  void save(const std::string &folder) override;
  double time() const override
  {
    return state_.time;
  }
  StepReport advance(double largest_step) override;
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
  std::pair<std::uint64_t, std::uint64_t> size() const override;
  void finish(const std::string &folder) override;

private:
  /// Energies, external work and the residual of the balance [J].
  struct EnergyLedger
  {
    AleTotals totals;
    double external_work;
    double interface_work;
    double residual; ///< [J]
  };

  void build();
  /// Compares the entries with one another and with the mesh.
  /// @throws InputError for those that contradict others or select nothing
  void check_scene(const dealii::Triangulation<3> &mesh);
  /// @throws InputError for a probe outside the mesh
  void check_probes(const dealii::Triangulation<3> &mesh) const;
  AleSnapshot snapshot() const;
  EnergyLedger ledger() const;
  void heat(const double begin, const double duration);
  ImpactPlan impact_plan() const;
  /// Finds further usable symmetry.
  void find_symmetry(ImpactPlan &plan) const;
  void restore_matter(const std::string &folder);

  MPI_Comm communicator_;
  ImpactScene impact_;
  Rezone rezone_;
  HeatSource heat_source_;
  InterfaceCoupling coupling_; ///< as in the parameter file

  std::vector<Region> regions_; ///< by material id
  HexSpace space_;
  LagrangeStep lagrange_;
  AleState state_;
  AleRecorders recorders_;
  KnownEnergies energies_;
  std::optional<ContactMeasures> contact_; ///< of all ranks, with planes
  double last_step_ = 0.;                  ///< 0: before the first step [s]
  /// Whether state_ is unchanged since the last step.
  bool forces_are_current_ = false;
};
} // namespace contrecoup::ale
