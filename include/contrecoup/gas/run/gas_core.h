// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/adaptation.h>
#include <contrecoup/gas/body/body_in_gas.h>
#include <contrecoup/gas/explosive/afterburn.h>
#include <contrecoup/gas/explosive/detonation.h>
#include <contrecoup/gas/kernel/time_stepper.h>
#include <contrecoup/gas/record/recorder.h>
#include <contrecoup/gas/run/work_forecast.h>

#include <memory>

namespace contrecoup::gas
{
/// The state of the gas and what changes it: octree, body, stepper, adaptation,
/// detonation and afterburn. It knows nothing of what is recorded.
template <int dim>
class GasCore
{
public:
  /// Keeps a reference to the scene.
  GasCore(const GasScene<dim> &scene, const MPI_Comm communicator);

  static void declare_parameters(dealii::ParameterHandler &prm);
  /// Call after the scene was parsed.
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Builds mesh and state from the initial state of the scene.
  /// @return lines for the log
  std::vector<std::string> set_up();

  /// Builds the octree, as far as the parameters rather than the state shape
  /// it, and finds the leaves that the body cuts.
  void build_octree();

  /// Takes a stable step of @p largest_step [s] at most.
  /// @throws NumericsError when no step size keeps the state physical
  StepReport advance(const double largest_step);

  /// Adapts the mesh, field and, unless they are empty, maps if it is due.
  /// Returns whether anything changed.
  bool adapt(BlastMaps<dim> &maps);

  /// What a checkpoint holds beside the leaves.
  void save(std::ostream &stream) const;
  void load(std::istream &stream);
  /// Rebuilds octree, state and, unless they are null, maps from the leaves of
  /// a checkpoint; then load(), then mesh_changed().
  void restore_leaves(const std::string &folder, BlastMaps<dim> *maps);

  /// Finds anew what depends on the mesh.
  void mesh_changed();

  /// The state after the last step.
  GasSnapshot<dim> snapshot() const;

  /// Totals and extremes. Collective.
  std::vector<NamedValue> totals() const;
  /// How the method fared. Collective.
  std::vector<NamedValue> measures() const;
  /// Part of the updates in this run that quiet leaves saved. Collective.
  double skipped_updates() const;

  /// Edge lengths of the smallest subcells that adaptation may make [m].
  dealii::Tensor<1, dim> smallest_subcell() const;

  /// See Simulation::expected_work(), for a front that is expected at a
  /// distance from @p centre that @p front gives of time.
  WorkForecast expected_work(const double end_time,
                             const dealii::Point<dim> &centre,
                             const std::function<double(double)> &front) const;

  const GasScene<dim> &scene() const
  {
    return scene_;
  }
  const LeafMesh<dim> &mesh() const
  {
    return mesh_;
  }
  const GasField &field() const
  {
    return field_;
  }
  const BodyInGas<dim> &body() const
  {
    return body_;
  }
  const Afterburn &afterburn() const
  {
    return afterburn_;
  }
  const AdaptationParameters &adaptation_parameters() const
  {
    return adaptation_parameters_;
  }
  bool skips_quiet_leaves() const
  {
    return skip_quiet_leaves_;
  }
  double time() const
  {
    return time_;
  }
  /// Whether there is explosive that the detonation has not passed.
  bool is_burning() const
  {
    return !has_burned_;
  }

private:
  void create_octree();
  void refine_octree();
  void fit_mesh_to_initial_state();
  std::vector<std::string> set_initial_state(const bool rough = false);
  void cut_leaves();
  void state_changed();
  void update_burn();
  /// Takes over the afterburn of the profile.
  void inherit_afterburn();
  void count_work(const double n_computed, const double fraction);
  [[noreturn]] void fail(const typename TimeStepper<dim>::Result &result);
  std::string describe_leaf(const unsigned int leaf);

  const GasScene<dim> &scene_;
  AdaptationParameters adaptation_parameters_;
  bool skip_quiet_leaves_ = true;

  LeafMesh<dim> mesh_;
  BodyInGas<dim> body_;
  GasField field_;
  std::unique_ptr<QuietLeaves<dim>> quiet_leaves_;
  std::unique_ptr<GasOperator<dim>> operator_;
  std::unique_ptr<TimeStepper<dim>> stepper_;
  std::unique_ptr<Adaptation<dim>> adaptation_;
  Detonation<dim> detonation_;
  /// Whether all explosive has burned. Once it has, changes of the cells'
  /// sizes must not take that back.
  bool has_burned_ = false;
  Afterburn afterburn_;

  double time_ = 0.;
  std::uint64_t n_steps_ = 0;
  double last_step_ = 0.;                 ///< size [s]
  std::array<double, 6> wall_force_ = {}; ///< in the last step
  /// Steps of this run with Stage::bound_velocity_slopes.
  double n_bounded_steps_ = 0.;
  /// Leaves computed by all stages of this run on all ranks.
  double n_computed_ = 0.;
  /// Leaves of this rank that the last hundred steps or so computed, and those
  /// that as much simulated time takes without retries; quiet ones count.
  double n_made_ = 0., n_needed_ = 0.;
};
} // namespace contrecoup::gas
