// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/solid/body/mesh_description.h>
#include <contrecoup/solid/body/solid_materials.h>
#include <contrecoup/solid/motion/solid_body.h>
#include <contrecoup/solid/record/displacement_field.h>
#include <contrecoup/solid/run/energy_audit.h>
#include <contrecoup/solid/run/solid_recorders.h>
#include <contrecoup/solid/run/solid_selections.h>

#include <deal.II/base/parameter_handler.h>

namespace contrecoup::solid
{
/// Choices of "Elements/Precision".
const std::vector<std::string> &solid_precision_names();

/**
 * The solid solver: explicit dynamics of a deformable body with materials,
 * supports, loads, energy audit and output.
 * @tparam Real number type of the state and of element arithmetic
 */
template <typename Real>
class SolidSimulation : public Simulation
{
public:
  explicit SolidSimulation(MPI_Comm communicator)
    : communicator_(communicator)
  {}

  /// Declares every entry.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads every entry. @throws InputError
  void parse_parameters(dealii::ParameterHandler &prm);

  CostEstimate estimate() override;
  std::vector<Assumption> plan() override;
  std::vector<Assumption> audit() override;
  void setup() override;
  void restore(const std::string &folder) override;
  void save(const std::string &folder) override;
  double time() const override
  {
    return body_.time();
  }
  StepReport advance(double largest_step) override;
  bool adapt() override
  {
    return false;
  }
  std::vector<NamedValue> history() override;
  std::vector<NamedValue> probes() override;
  std::vector<FieldFile> write_fields(const std::string &folder,
                                      unsigned int index) override;
  std::vector<NamedValue> errors() override;
  std::vector<NamedValue> results() override;
  std::vector<NamedValue> checks() override;
  std::vector<std::string> gaps() override;
  void finish(const std::string &folder) override;
  std::pair<std::uint64_t, std::uint64_t> size() const override;

private:
  void build();
  SolidSelectors selectors();

  /// Builds the mesh to find entries that select nothing; returns its number
  /// of nodes.
  /// @throws InputError
  std::uint64_t check_selections();
  void report_step() const;

  /// Warns once if elements turn although strains are to be small.
  void warn_of_rotation();

  /// Warns if nothing can move the body. @param ledger of the start
  void warn_of_rest(const EnergyLedger &ledger);

  void report_injury(const std::string &folder);
  EnergyLedger check_energy();
  double allowed_step();
  void tell_smaller_step(double allowed);

  MPI_Comm communicator_;
  MeshDescription mesh_description_;
  std::set<std::string> thin_parts_; ///< with holes in their layers
  SolidMaterials materials_;
  ElementOptions options_;
  Supports supports_;
  SlipTies slip_;
  SurfaceLoads loads_;
  Surroundings surroundings_;
  InitialMotion initial_;
  ReferenceMotion reference_;
  SolidRecorders<Real> recorders_;
  double safety_ = 0.9;
  double smallest_step_ = 0.; ///< of an element, for mass scaling [s]
  EnergyAudit audit_;
  double end_time_ = 0.;
  bool has_warned_of_rest_ = false;
  bool has_warned_of_rotation_ = false;

  SolidBody<Real> body_;
  StableStep stability_;
  double stable_step_ = 0.;
  double reduction_ = 1.; ///< factor on the step after retries
  double deformed_step_ = std::numeric_limits<double>::infinity();
  /// Until the next check of deformed elements.
  double steps_until_check_ = 0.;
  double told_step_ = 0.; ///< below which a step gets a line in the log
};
} // namespace contrecoup::solid
