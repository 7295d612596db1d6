// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/gas/adaptation/adaptation_pace.h>
#include <contrecoup/gas/body/cut_leaves.h>
#include <contrecoup/gas/conditions/boundary.h>
#include <contrecoup/gas/conditions/initial_state.h>
#include <contrecoup/gas/conditions/profile.h>
#include <contrecoup/gas/conditions/reference_solution.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/explosive/afterburn.h>
#include <contrecoup/gas/explosive/charge_set.h>
#include <contrecoup/gas/explosive/detonation.h>
#include <contrecoup/gas/hand_over/profile_mapping.h>
#include <contrecoup/gas/kernel/gas_operator.h>
#include <contrecoup/gas/kernel/time_stepper.h>
#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/octree/scheme.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/record/gauge_rasters.h>
#include <contrecoup/gas/record/open_sides.h>
#include <contrecoup/gas/record/probe_set.h>
#include <contrecoup/gas/record/wall_loads.h>
#include <contrecoup/gas/run/gas_output.h>
#include <contrecoup/gas/run/modelling_plan.h>
#include <contrecoup/gas/state/gas_field.h>

#include <deal.II/base/parameter_handler.h>

namespace contrecoup::gas
{
/// A compressible gas in a domain: everything that application blast does.
template <int dim>
class GasSimulation : public Simulation
{
public:
  explicit GasSimulation(const MPI_Comm communicator);

  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  CostEstimate estimate() override;
  void set_output_folder(const std::string &folder) override
  {
    loads_.set_folder(folder);
  }
  void setup() override;
  void restore(const std::string &folder) override;
  void save(const std::string &folder) override;
  double time() const override
  {
    return time_;
  }
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
  WorkForecast expected_work(const double end_time) override;
  unsigned int dimension() const override
  {
    return dim;
  }
  /// Writes the profile if "Output/Profile file" asks for it.
  void finish(const std::string &folder) override;
  std::pair<std::uint64_t, std::uint64_t> size() const override;

  /// Builds mesh and state as setup() does, from @p profile around
  /// @p centre at the profile's time.
  /// @throws InputError when they do not go together.
  void start_from(std::shared_ptr<const Profile> profile,
                  const dealii::Point<dim> &centre);

  /// The state as a profile, see extract_profile().
  ProfileData profile() const;

  /// Whether there is explosive that the detonation has not passed.
  bool is_burning() const
  {
    return !has_burned_;
  }

  /// See disturbed_box().
  std::pair<dealii::Point<dim>, dealii::Point<dim>> disturbed_box() const;

  /// The state before anything happened.
  GasState<dim> ambient() const;

  /// Volume that the body takes up in the domain, as the cells have it
  /// [m^dim]. Builds and forgets the octree. Collective.
  double body_volume();

  const CoarseMesh<dim> &coarse_mesh() const
  {
    return coarse_mesh_;
  }
  const GasMaterial &material() const
  {
    return material_;
  }
  /// Energy of the domain, chemical energy and afterburn to come included,
  /// above that of gas that nothing happened to [J]. Collective.
  double excess_energy() const;

  /// Tells the plan of a blast of @p energy in full space [J] that this
  /// state does not show, or no longer.
  /// @param non_ideal_part see ModellingPlan
  void expect_blast(const double energy,
                    const dealii::Point<dim> &centre,
                    const double non_ideal_part);

  const ModellingPlan<dim> &modelling_plan() const
  {
    return modelling_plan_;
  }

  /// Edge lengths of the smallest subcells that adaptation may make [m].
  dealii::Tensor<1, dim> smallest_cell() const;

  ProbeSet<dim> &probe_set()
  {
    return probes_;
  }
  /// What the blast did at the probes so far, see ProbeSet.
  std::vector<NamedValue> probe_measures() const
  {
    return probes_.measures(reference_);
  }

private:
  void parse_afterburn(ParameterHandler &prm);
  /// @throws InputError when the body does not go with the rest.
  void parse_body(ParameterHandler &prm);
  /// Leaves that the initial refinement and the body make.
  double n_leaves_with_body() const;
  /// Of these, those in a box that was halved so often beyond the initial
  /// refinement.
  double n_leaves_in(const LeafBox<dim> &box, const int halvings) const;
  void create_octree();
  /// Halves leaves wherever the parameters, not the state, say so.
  void refine_octree();
  /// Finds how the body cuts the leaves.
  void cut_leaves();
  /// Gives gas at rest to cells without gas.
  /// @throws InputError when the body leaves no gas, lies outside of the
  /// domain, or in a charge.
  void fill_closed_cells();
  /// Volume of the domain without gas [m^dim]. Collective.
  double closed_volume() const;
  /// Returns lines for the log about what it made.
  /// @param rough whether profiles are mapped well enough for sensors alone
  std::vector<std::string> set_initial_state(const bool rough = false);
  void fit_mesh_to_initial_state();
  bool wants_initial_refinement(const unsigned int leaf) const;
  void mesh_changed();
  /// Tells the stepper where leaves are smaller than fronts may have.
  void update_front_shares();
  void update_burn();
  /// Notes that a step computed @p n_made leaves for @p part of a stable step.
  void count_work(const double n_made, const double part);
  void parse_profile_file(dealii::ParameterHandler &prm);
  std::vector<std::string> mapping_report(const ProfileMapping &mapping) const;
  /// Takes over the afterburn of the profile.
  void go_on_burning();
  /// Takes over the profile's maps of what the blast did so far.
  void go_on_mapping();
  /// Finds the blast for the plan in the initial state, if there is one.
  void foresee_blast();
  /// See ModellingPlan; NaN without products, or with less than half of them
  /// everywhere.
  double non_ideal_part() const;
  /// Shortest edge of a subcell [m].
  double finest_edge() const;
  [[noreturn]] void give_up(const typename TimeStepper<dim>::Result &result);
  std::string describe_leaf(const unsigned int leaf);

  GasMaterial material_;
  CoarseMesh<dim> coarse_mesh_;
  Scheme scheme_;
  InitialState<dim> initial_state_;
  ChargeSet<dim> charges_;
  Afterburn afterburn_;
  ReferenceSolution<dim> reference_;
  Boundary<dim> boundary_;
  RigidBody body_;
  WallLoads<dim> loads_;
  AdaptationParameters adaptation_parameters_;
  ProbeSet<dim> probes_;
  GaugeRasters<dim> gauges_;
  GasOutput<dim> output_;
  double end_time_ = 0.;
  std::string profile_file_;
  std::string material_words_;
  bool skip_quiet_leaves_ = true;

  LeafMesh<dim> mesh_;
  LeafLayout layout_;
  LeafPoints<dim> points_;
  CutLeaves<dim> cut_leaves_; ///< unused without a body
  GasField field_;
  BlastMaps<dim> maps_; ///< empty unless wanted
  std::unique_ptr<GasOperator<dim>> operator_;
  std::unique_ptr<TimeStepper<dim>> stepper_;
  std::unique_ptr<Adaptation<dim>> adaptation_;
  AdaptationPace adaptation_pace_;
  Detonation<dim> detonation_;
  /// Whether all explosive has burned. Once it has, changes of the cells'
  /// sizes must not take that back.
  bool has_burned_ = false;

  ModellingPlan<dim> modelling_plan_;
  OpenSides<dim> open_sides_;

  double time_ = 0.;
  std::uint64_t n_steps_ = 0;
  double n_careful_steps_ = 0.; ///< in this run, see Stage::careful
  /// Leaves computed by all stages of this run on all ranks.
  double n_computed_ = 0.;
  /// Leaves of this rank that the last hundred steps or so computed, and those
  /// that as much simulated time takes without retries; quiet ones count.
  double n_made_ = 0., n_needed_ = 0.;
};
} // namespace contrecoup::gas
