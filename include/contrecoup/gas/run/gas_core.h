// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/adaptation.h>
#include <contrecoup/gas/body/body_in_gas.h>
#include <contrecoup/gas/explosive/afterburn.h>
#include <contrecoup/gas/explosive/detonation.h>
#include <contrecoup/gas/record/recorder.h>
#include <contrecoup/gas/run/work_forecast.h>
#include <contrecoup/gas/stepping/time_stepper.h>

#include <memory>

namespace contrecoup::gas
{
/// State of the gas and all that advances it in time: octree, body, time
/// stepper, adaptation, detonation and afterburn. Does not depend on recorders
/// other than the maps, which adaptation transfers.
template <int dim>
class GasCore
{
public:
  /// Keeps a reference to the scene.
  GasCore(const GasScene<dim> &scene, const MPI_Comm communicator);

  static void declare_parameters(dealii::ParameterHandler &prm);
  /// Call after the scene has been parsed.
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Builds mesh and state from the initial state of the scene.
  /// @return lines for the log
  std::vector<std::string> set_up();

  /// Builds the octree without the refinement that depends on the state, and
  /// finds the leaves that the body cuts.
  void build_octree();

  /// Advances by one stable step of at most @p largest_step [s].
  /// @throws NumericsError when no step size keeps the state physical
  StepReport advance(const double largest_step);

  /// Adapts the mesh if due, and transfers the field and, unless they are
  /// empty, the maps. Returns whether the mesh changed.
  bool adapt(BlastMaps<dim> &maps);

  /// Writes and reads the data of a checkpoint other than leaves.
  void save(std::ostream &stream) const;
  void load(std::istream &stream);
  /// Rebuilds octree, state and, unless null, maps from the leaves of a
  /// checkpoint. Call load() and then mesh_changed() afterwards.
  void restore_leaves(const std::string &folder, BlastMaps<dim> *maps);

  /// Updates all data that depend on the mesh.
  void mesh_changed();

  /// The state after the last step.
  GasSnapshot<dim> snapshot() const;

  /// Conserved totals and extrema, for history.csv. Collective.
  std::vector<NamedValue> totals() const;
  /// Measures of the numerical method, for the summary. Collective.
  std::vector<NamedValue> checks() const;
  /// Fraction of the updates of this run that were skipped in quiet leaves [-].
  /// Collective.
  double skipped_updates() const;

  /// Edge lengths of the smallest subcells that adaptation allows [m].
  dealii::Tensor<1, dim> smallest_subcell() const;

  /// See Simulation::expected_work().
  /// @param front expected distance of the blast front from @p centre [m] as a
  /// function of time [s]
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
  /// Whether unburned explosive is left.
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
  /// Starts from the released afterburn energy of the profile.
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
  std::unique_ptr<TimeStepper<dim>> stepper_;
  std::unique_ptr<Adaptation<dim>> adaptation_;
  Detonation<dim> detonation_;
  /// Whether all explosive has burned. Stays true when adaptation changes
  /// subcell sizes, which enter the burn times.
  bool has_burned_ = false;
  Afterburn afterburn_;

  double time_ = 0.;
  std::uint64_t n_steps_ = 0;
  double last_step_ = 0.;                 ///< size [s]
  std::array<double, 6> wall_force_ = {}; ///< in the last step
  /// Steps with Stage::bound_velocity_slopes.
  double n_bounded_steps_ = 0.;
  /// Leaf updates in all stages on all ranks: computed, and possible without
  /// skipping.
  double n_computed_ = 0., n_possible_ = 0.;
  /// Leaf updates of this rank in about the last hundred steps, and those that
  /// the same simulated time requires without retries; both include quiet
  /// leaves.
  double n_made_ = 0., n_needed_ = 0.;
};
} // namespace contrecoup::gas
