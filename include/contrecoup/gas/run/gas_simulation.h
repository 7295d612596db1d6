// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/profile.h>
#include <contrecoup/gas/run/gas_output.h>
#include <contrecoup/gas/run/run_plan.h>

namespace contrecoup::gas
{
/// Solver of application `blast` for the run loop: the scene, the state of the
/// gas that advances in it (GasCore), the recorders, and the plan of modelling
/// assumptions.
template <int dim>
class GasSimulation : public Simulation
{
public:
  explicit GasSimulation(const MPI_Comm communicator);

  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  CostEstimate estimate() override;
  void set_output_folder(const std::string &folder) override;
  void setup() override;
  void restore(const std::string &folder) override;
  void save(const std::string &folder) override;
  double time() const override
  {
    return core_.time();
  }
  StepReport advance(double largest_step) override;
  bool adapt() override;
  std::vector<NamedValue> history() override
  {
    return core_.totals();
  }
  std::vector<NamedValue> probes() override
  {
    return probe_set().values(scene_.material.has_products());
  }
  std::vector<FieldFile> write_fields(const std::string &folder,
                                      unsigned int index) override;
  /// Also logs report() of the recorders.
  std::vector<NamedValue> errors() override;
  std::vector<NamedValue> results() override;
  std::vector<NamedValue> checks() override;
  std::vector<Assumption> plan() override
  {
    return plan_.plan(recorders_);
  }
  std::vector<Assumption> audit() override
  {
    return plan_.audit(recorders_);
  }
  WorkForecast expected_work(const double end_time) override;
  unsigned int dimension() const override
  {
    return dim;
  }
  std::vector<std::string> gaps() override;
  /// Completes the records, and writes the profile if "Output/Profile file" is
  /// set.
  void finish(const std::string &folder) override;
  std::pair<std::uint64_t, std::uint64_t> size() const override;

  const GasScene<dim> &scene() const
  {
    return scene_;
  }
  const GasCore<dim> &core() const
  {
    return core_;
  }
  const ModellingPlan<dim> &modelling_plan() const
  {
    return plan_.found();
  }
  ProbeRasters<dim> &probe_rasters()
  {
    return recorders_.template get<ProbeRasters<dim>>();
  }
  ProbeSet<dim> &probe_set()
  {
    return recorders_.template get<ProbeSet<dim>>();
  }
  /// Pressures on the rigid body and at its gauges.
  const WallLoads<dim> &loads() const
  {
    return recorders_.template get<WallLoads<dim>>();
  }

  /// Adds a recorder of the program's own, which is called after all others.
  /// Call before parse_parameters(). Checkpoints hold its record: a run resumed
  /// from one needs the same recorders.
  void add_recorder(std::shared_ptr<Recorder<dim>> recorder)
  {
    recorders_.add(std::move(recorder));
  }

  /// Primitive states at @p places [m], on every rank. Collective.
  /// @throws InputError for a place outside of the mesh.
  std::vector<GasState<dim>>
  states_at(const std::vector<dealii::Point<dim>> &places) const;

  /// As setup(), but starts from @p profile around @p centre [m] at the
  /// profile's time.
  /// @throws InputError when the profile does not fit the domain.
  void start_from(std::shared_ptr<const Profile> profile,
                  const dealii::Point<dim> &centre);

  /// Current state as a profile, see make_profile().
  ProfileData profile() const;

  /// See disturbed_box().
  std::pair<dealii::Point<dim>, dealii::Point<dim>> disturbed_box() const;

  /// Volume of the body within the domain on the mesh [m^dim]. Builds the
  /// octree temporarily. Collective.
  double body_volume();

  /// See RunPlan.
  void expect_blast(const double energy,
                    const dealii::Point<dim> &centre,
                    const double non_ideal_fraction)
  {
    plan_.expect_blast(energy, centre, non_ideal_fraction);
  }

private:
  void warn_of_unknown_records() const;

  GasScene<dim> scene_;
  GasCore<dim> core_;
  Recorders<dim> recorders_;
  RunPlan<dim> plan_;
  GasOutput<dim> output_;
  std::string profile_file_; ///< empty: none
};
} // namespace contrecoup::gas
