// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/gas/conditions/profile_field.h>
#include <contrecoup/gas/conditions/profile_file.h>
#include <contrecoup/gas/hand_over/profile_extraction.h>
#include <contrecoup/gas/record/gas_measures.h>
#include <contrecoup/gas/run/cost_estimate.h>
#include <contrecoup/gas/run/gas_checkpoint.h>
#include <contrecoup/gas/run/gas_simulation.h>
#include <contrecoup/gas/run/run_profile.h>
#include <contrecoup/gas/scene/scene_selections.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/gas/state/point_sampler.h>
#include <contrecoup/io/file/checked_file.h>

#include <sstream>

namespace contrecoup::gas
{
namespace
{
  bool is_first_rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }
} // namespace


template <int dim>
GasSimulation<dim>::GasSimulation(const MPI_Comm communicator)
  : core_(scene_, communicator)
  , plan_(core_)
{}


template <int dim>
void GasSimulation<dim>::declare_parameters(ParameterHandler &prm)
{
  GasScene<dim>::declare_parameters(prm);
  GasCore<dim>::declare_parameters(prm);
  Recorders<dim>::declare_parameters(prm);
  GasOutput<dim>::declare_parameters(prm);
  const Section section(prm, "Output");
  declare_string(prm,
                 "Profile file",
                 "",
                 "Name of a file in the output folder for the profile at the "
                 "end time, the start of runs in more dimensions: HDF5, or a "
                 "table if it ends in .csv; empty: none. Available in "
                 "spherical, cylindrical and axisymmetric geometry.");
}


template <int dim>
void GasSimulation<dim>::parse_parameters(ParameterHandler &prm)
{
  scene_.parse_parameters(prm);
  core_.parse_parameters(prm);
  plan_.parse_parameters(prm);
  check_selections(prm, scene_.coarse_mesh, scene_.body);
  recorders_.for_each(
    [&](auto &recorder) { recorder.parse_parameters(prm, scene_); });
  warn_of_unknown_records();
  output_.parse_parameters(prm, scene_.coarse_mesh);
  const Section section(prm, "Output");
  profile_file_ = prm.get("Profile file");
  if (!profile_file_.empty() &&
      (dim == 3 || scene_.coarse_mesh.geometry() == Geometry::plane ||
       !scene_.body.empty()))
    throw InputError("Output/Profile file: only domains with spherical, "
                     "cylindrical or axisymmetric geometry and no rigid body "
                     "have a profile");
}


template <int dim>
void GasSimulation<dim>::warn_of_unknown_records() const
{
  const auto *profile = scene_.initial_state.profile();
  if (profile == nullptr || has_records(profile->profile()))
    return;
  const auto known = records_of(*profile);
  std::size_t n_unknown = 0;
  const auto count = [&](const std::vector<dealii::Point<dim>> &places) {
    for (const auto &place : places)
      n_unknown += known(place) ? 1 : 0;
  };
  count(recorders_.template get<ProbeSet<dim>>().places());
  count(recorders_.template get<ProbeRasters<dim>>().places());
  if (n_unknown > 0 || recorders_.template get<BlastMaps<dim>>().wanted())
    log_line("WARNING: Initial state/Profile/File has no maps: peak, impulse, "
             "arrival and duration within its blast, at " +
             std::to_string(n_unknown) +
             " of the probes, stay unknown (not a number); its own run records "
             "them with Output/Maps = true");
}


template <int dim>
CostEstimate GasSimulation<dim>::estimate()
{
  return estimate_cost(
    scene_,
    core_.adaptation_parameters(),
    recorders_.template get<BlastMaps<dim>>().wanted(),
    dealii::Utilities::MPI::n_mpi_processes(core_.mesh().communicator()));
}


template <int dim>
void GasSimulation<dim>::set_output_folder(const std::string &folder)
{
  recorders_.for_each(
    [&](auto &recorder) { recorder.set_output_folder(folder); });
}


template <int dim>
void GasSimulation<dim>::setup()
{
  const auto report = core_.set_up();
  if (!scene_.charges.empty())
    show_line(scene_.charges.description());
  for (const std::string &line : report)
    log_line(line);
  const auto gas = core_.snapshot();
  recorders_.for_each([&](auto &recorder) {
    recorder.mesh_changed(gas);
    recorder.begin(gas);
  });
  if (const auto *profile = scene_.initial_state.profile())
    recorders_.for_each(
      [&](auto &recorder) { recorder.inherit(records_of(*profile), gas); });
}


template <int dim>
void GasSimulation<dim>::start_from(std::shared_ptr<const Profile> profile,
                                    const dealii::Point<dim> &centre)
{
  scene_.initial_state.set_profile(std::move(profile), centre);
  setup();
}


template <int dim>
StepReport GasSimulation<dim>::advance(const double largest_step)
{
  const StepReport report = core_.advance(largest_step);
  const auto gas = core_.snapshot();
  recorders_.for_each(&Recorder<dim>::add_step, gas);
  return report;
}


template <int dim>
bool GasSimulation<dim>::adapt()
{
  if (!core_.adapt(recorders_.template get<BlastMaps<dim>>()))
    return false;
  const auto gas = core_.snapshot();
  recorders_.for_each(&Recorder<dim>::mesh_changed, gas);
  return true;
}


template <int dim>
std::vector<FieldFile>
GasSimulation<dim>::write_fields(const std::string &folder, unsigned int index)
{
  const auto gas = core_.snapshot();
  auto &loads = recorders_.template get<WallLoads<dim>>();
  // Collective, hence before the first rank writes files, which may fail.
  loads.gather_skin();
  recorders_.for_each(&Recorder<dim>::write, gas, folder);
  auto files = output_.write(
    gas, recorders_.template get<BlastMaps<dim>>(), {folder, index});
  const std::string skin = loads.write_skin(folder, index, gas.time);
  if (!skin.empty())
    files.push_back({"skin", skin});
  return files;
}


template <int dim>
std::vector<NamedValue> GasSimulation<dim>::errors()
{
  const auto gas = core_.snapshot();
  for (const auto &line : recorders_.collect(&Recorder<dim>::report, gas))
    show_line(line);
  auto values = recorders_.collect(&Recorder<dim>::errors, gas);
  if (scene_.reference.is_measured())
    for (const auto &value : gas_errors(gas.mesh,
                                        scene_.points,
                                        gas.field,
                                        scene_.material,
                                        scene_.reference,
                                        gas.time))
      values.push_back(value);
  return values;
}


template <int dim>
std::vector<NamedValue> GasSimulation<dim>::results()
{
  return recorders_.collect(&Recorder<dim>::results, core_.snapshot());
}


template <int dim>
std::vector<NamedValue> GasSimulation<dim>::checks()
{
  auto values = recorders_.collect(&Recorder<dim>::checks, core_.snapshot());
  for (const NamedValue &value : core_.checks())
    values.push_back(value);
  return values;
}


template <int dim>
WorkForecast GasSimulation<dim>::expected_work(const double end_time)
{
  return core_.expected_work(
    end_time, plan_.found().centre, [this](const double time) {
      return plan_.found().expected_front(time);
    });
}


template <int dim>
std::pair<std::uint64_t, std::uint64_t> GasSimulation<dim>::size() const
{
  const std::uint64_t cells =
    std::uint64_t(core_.mesh().n_global()) * scene_.layout.n_points;
  return {cells, cells * scene_.layout.n_components};
}


template <int dim>
void GasSimulation<dim>::save(const std::string &folder)
{
  // Collective calls come first, so that a rank that cannot write blocks no
  // other.
  recorders_.for_each(&Recorder<dim>::reduce_over_ranks);
  save_leaves(core_.mesh(),
              core_.field(),
              folder,
              &recorders_.template get<BlastMaps<dim>>());
  if (!is_first_rank())
    return;
  io::write_file(folder + "/gas.bin", [&](std::ostream &out) {
    core_.save(out);
    plan_.save(out);
    recorders_.for_each([&](auto &recorder) { recorder.save(out, folder); });
  });
}


template <int dim>
void GasSimulation<dim>::restore(const std::string &folder)
{
  auto &maps = recorders_.template get<BlastMaps<dim>>();
  core_.restore_leaves(folder, maps.wanted() ? &maps : nullptr);
  std::istringstream stream(io::read_file(folder + "/gas.bin"));
  core_.load(stream);
  plan_.load(stream);
  recorders_.for_each([&](auto &recorder) { recorder.load(stream, folder); });
  core_.mesh_changed();
  const auto gas = core_.snapshot();
  recorders_.for_each(&Recorder<dim>::mesh_changed, gas);
  if (!stream)
    throw InputError("Checkpoint file " + folder +
                     "/gas.bin belongs to another scene");
}


template <int dim>
std::vector<GasState<dim>> GasSimulation<dim>::states_at(
  const std::vector<dealii::Point<dim>> &places) const
{
  PointSampler<dim> sampler;
  sampler.reinit(places, core_.mesh(), scene_.points);
  return sampler.sample(core_.field(), scene_.material);
}


template <int dim>
ProfileData GasSimulation<dim>::profile() const
{
  return make_profile(core_, recorders_.template get<BlastMaps<dim>>());
}


template <int dim>
std::pair<dealii::Point<dim>, dealii::Point<dim>>
GasSimulation<dim>::disturbed_box() const
{
  return gas::disturbed_box(
    core_.mesh(),
    scene_.points,
    core_.field(),
    conserved_state(scene_.ambient(), scene_.material, dim + 3));
}


template <int dim>
double GasSimulation<dim>::body_volume()
{
  if (!scene_.body.empty())
    core_.build_octree();
  return core_.body().volume();
}


template <int dim>
std::vector<std::string> GasSimulation<dim>::gaps()
{
  std::vector<std::string> lines;
  recorders_.for_each([&](auto &recorder) {
    recorder.reduce_over_ranks();
    for (const std::string &line : recorder.gaps(time()))
      lines.push_back(line);
  });
  return lines;
}


template <int dim>
void GasSimulation<dim>::finish(const std::string &folder)
{
  recorders_.for_each(&Recorder<dim>::finish);
  if (profile_file_.empty())
    return;
  const ProfileData data = profile();
  if (is_first_rank())
    write_profile(folder + "/" + profile_file_, data);
  log_line("profile written: " + profile_file_);
}


template class GasSimulation<1>;
template class GasSimulation<2>;
template class GasSimulation<3>;
} // namespace contrecoup::gas
