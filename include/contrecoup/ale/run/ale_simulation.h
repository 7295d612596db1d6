// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/reference.h>
#include <contrecoup/ale/head/head_measures.h>
#include <contrecoup/ale/head/impact_scene.h>
#include <contrecoup/ale/lagrange/contact_record.h>
#include <contrecoup/ale/lagrange/heat_source.h>
#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/ale/rezone/rezone.h>
#include <contrecoup/base/run/simulation.h>

namespace contrecoup::ale
{
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
  void find_probe_cells();
  EnergyLedger ledger() const;
  void heat(const double begin, const double duration);
  ImpactPlan impact_plan() const;
  /// Finds further usable symmetry.
  void find_symmetry(ImpactPlan &plan) const;
  void restore_peaks(io::StateReader &in);

  MPI_Comm communicator_;
  ImpactScene impact_;
  Rezone rezone_;
  HeatSource heat_source_;
  InterfaceCoupling coupling_; ///< as in the parameter file
  ContactRecord contact_;
  Reference reference_;
  HeadMeasures head_;

  HexSpace space_;
  LagrangeStep lagrange_;
  AleState state_;
  std::uint64_t n_cells_ = 0;
  std::uint64_t n_nodes_ = 0;
  double initial_energy_ = 0.;
  double energy_scale_ = 0.;
  double initial_kinetic_energy_ = 0.;
  ExtremeRecord extremes_; ///< of the regions
  double last_step_ = 0.;  ///< 0: before the first step [s]
  /// Whether state_ is unchanged since the last step.
  bool is_as_left_ = false;
  /// Cell of each probe on the rank that owns the cell, elsewhere no_cell.
  std::vector<std::uint32_t> probe_cells_;
};
} // namespace contrecoup::ale
