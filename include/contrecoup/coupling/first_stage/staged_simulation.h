// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/first_stage/first_stage.h>
#include <contrecoup/coupling/first_stage/front_path.h>

#include <optional>

namespace contrecoup::coupling
{
/**
 * Blast that begins with a first stage in fewer dimensions and continues in
 * the dimensions of the scene. The scene's gas takes over the profile of the
 * first stage between two steps (hand-over). Histories and probes are those of
 * the scene throughout; fields are those of the active stage.
 */
template <int dim>
class StagedSimulation : public Simulation
{
public:
  explicit StagedSimulation(const MPI_Comm communicator);

  /// Declares all entries: those of the gas and subsection "First stage".
  static void declare_parameters(ParameterHandler &prm);

  /// @throws InputError for scenes that cannot begin with a first stage.
  void parse_parameters(ParameterHandler &prm);

  CostEstimate estimate() override;
  void set_output_folder(const std::string &folder) override
  {
    scene_.set_output_folder(folder);
  }
  void setup() override;
  void restore(const std::string &folder) override;
  void save(const std::string &folder) override;
  double time() const override;
  StepReport advance(double largest_step) override;
  bool adapt() override;
  std::vector<NamedValue> history() override;
  std::vector<NamedValue> probes() override
  {
    return scene_.probes();
  }
  std::vector<FieldFile> write_fields(const std::string &folder,
                                      unsigned int index) override;
  std::vector<NamedValue> errors() override;
  std::vector<NamedValue> results() override;
  std::vector<NamedValue> checks() override;
  std::vector<Assumption> plan() override;
  std::vector<Assumption> audit() override;
  /// During the first stage, @p end_time is the time of its hand-over.
  WorkForecast expected_work(const double end_time) override;
  std::optional<double> expected_hand_over() override;
  unsigned int dimension() const override
  {
    return active().dimension();
  }
  std::vector<std::string> gaps() override;
  void finish(const std::string &folder) override
  {
    if (!first_)
      scene_.finish(folder);
  }
  std::pair<std::uint64_t, std::uint64_t> size() const override;

  /// Gas of the second stage; no mesh and no state before the hand-over.
  gas::GasSimulation<dim> &scene()
  {
    return scene_;
  }
  const gas::GasSimulation<dim> &scene() const
  {
    return scene_;
  }

  /// First stage; null after the hand-over.
  FirstStage<dim> *first_stage() const
  {
    return first_.get();
  }

private:
  /// Solver of the active stage.
  Simulation &active() const;
  /// @throws InputError when an axisymmetric stage would hand over before its
  /// spherical stage does.
  void check_hand_over_order() const;
  /// Records the state at all places after a step of the first stage [s].
  void read_probes(const double step);
  /// Distance of the front to the nearest side at which "auto" hands over [m].
  double margin() const;
  /// Distance of the front from the charge at the hand-over, unless the time
  /// is given [m].
  double hand_over_distance() const;
  /// Item about the front at the hand-over, for plan and audit.
  Assumption hand_over_item(const double radius) const;
  bool is_due();
  void hand_over();

  MPI_Comm communicator_;
  FirstStageParameters parameters_;
  FirstStageLayout<dim> plan_;
  /// Gas of the second stage; no mesh and no state before the hand-over.
  mutable gas::GasSimulation<dim> scene_;
  std::unique_ptr<FirstStage<dim>> first_; ///< null after the hand-over
  FrontPath front_path_;                   ///< front of the first stage
  double hand_over_time_ = 0.;             ///< [s]
  double hand_over_radius_ = 0.;           ///< [m]
  /// Volume of the body in the domain, cached [m^dim].
  std::optional<double> body_volume_;
};
} // namespace contrecoup::coupling
