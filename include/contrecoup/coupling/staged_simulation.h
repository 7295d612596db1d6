// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/first_stage.h>
#include <contrecoup/coupling/front_course.h>

#include <optional>

namespace contrecoup::coupling
{
/**
 * A blast that begins in fewer dimensions and goes on in those of its scene:
 * a first stage, and the scene's gas, which takes over its profile between
 * two steps. Histories and gauges are those of the scene throughout; fields
 * are those of the stage that is at work.
 */
template <int dim>
class StagedSimulation : public Simulation
{
public:
  explicit StagedSimulation(const MPI_Comm communicator);

  /// Declares all entries: those of the gas and subsection "First stage".
  static void declare_parameters(ParameterHandler &prm);

  /// @throws InputError for scenes that cannot be staged.
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
  std::vector<NamedValue> probes() override;
  std::string write_fields(const std::string &folder,
                           unsigned int index) override;
  std::vector<NamedValue> errors() override;
  std::vector<NamedValue> assumptions() override;
  std::vector<Assumption> plan() override;
  std::vector<Assumption> audit() override;
  /// In the first stage, @p end_time is that of its hand-over.
  WorkForecast expected_work(const double end_time) override;
  std::optional<double> expected_hand_over() override;
  unsigned int dimension() const override
  {
    return active().dimension();
  }
  void finish(const std::string &folder) override;
  std::pair<std::uint64_t, std::uint64_t> size() const override;

  /// The second stage, without mesh and state before the hand-over.
  gas::GasSimulation<dim> &scene()
  {
    return scene_;
  }
  const gas::GasSimulation<dim> &scene() const
  {
    return scene_;
  }

  /// The first stage; null after it.
  FirstStage<dim> *first_stage() const
  {
    return first_.get();
  }

private:
  /// The solver of the stage that is at work.
  Simulation &active() const;
  /// @throws InputError when an axisymmetric stage that begins in 1-D would
  /// end before it begins.
  void check_ways() const;
  void read_gauges();
  /// Distance before the nearest side at which "auto" hands over [m].
  double margin() const;
  /// Of the front from the charge at the hand-over, unless its time is
  /// given [m].
  double hand_over_distance() const;
  /// The front at the hand-over, for plan and audit.
  Assumption hand_over_item(const double radius) const;
  bool is_due();
  void hand_over();

  MPI_Comm communicator_;
  StageParameters parameters_;
  StagePlan<dim> plan_;
  /// The second stage, without mesh and state before the hand-over.
  mutable gas::GasSimulation<dim> scene_;
  std::unique_ptr<FirstStage<dim>> first_; ///< nullptr after it
  FrontCourse front_course_;               ///< of the first stage
  double hand_over_time_ = 0.;             ///< [s]
  double hand_over_radius_ = 0.;           ///< [m]
  /// In the domain, once it was asked for [m^dim].
  std::optional<double> body_volume_;
};
} // namespace contrecoup::coupling
