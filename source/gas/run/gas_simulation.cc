// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/gather.h>
#include <contrecoup/base/log.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/timers.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/record/gas_measures.h>
#include <contrecoup/gas/run/gas_checkpoint.h>
#include <contrecoup/gas/run/gas_simulation.h>
#include <contrecoup/gas/run/scene_places.h>
#include <contrecoup/io/checked_file.h>

#include <sstream>

namespace contrecoup::gas
{
template <int dim>
GasSimulation<dim>::GasSimulation(const MPI_Comm communicator)
  : mesh_(communicator)
{}


template <int dim>
void GasSimulation<dim>::declare_parameters(ParameterHandler &prm)
{
  CoarseMesh<dim>::declare_parameters(prm);
  GasMaterial::declare_parameters(prm);
  Scheme::declare_parameters(prm);
  QuietLeaves<dim>::declare_parameters(prm);
  InitialState<dim>::declare_parameters(prm);
  ChargeSet<dim>::declare_parameters(prm);
  ReferenceSolution<dim>::declare_parameters(prm);
  Boundary<dim>::declare_parameters(prm);
  AdaptationParameters::declare_parameters(prm);
  RigidBody::declare_parameters(prm);
  WallLoads<dim>::declare_parameters(prm);
  ProbeSet<dim>::declare_parameters(prm);
  GaugeRasters<dim>::declare_parameters(prm);
  GasOutput<dim>::declare_parameters(prm);
  const Section section(prm, "Output");
  declare_string(prm,
                 "Profile file",
                 "",
                 "Name of a file in the output folder for the profile at the "
                 "end time, as a start for runs in more dimensions: HDF5, or "
                 "a table if it ends in .csv; empty for none. Domains with "
                 "spherical, cylindrical or axisymmetric geometry have one.");
}


template <int dim>
void GasSimulation<dim>::parse_parameters(ParameterHandler &prm)
{
  coarse_mesh_.parse_parameters(prm);
  material_.parse_parameters(prm);
  scheme_.parse_parameters(
    prm, dim, coarse_mesh_.geometry() == Geometry::plane);
  skip_quiet_leaves_ = QuietLeaves<dim>::parse_parameters(prm);
  scheme_.check_mesh(coarse_mesh_.is_axis_aligned());
  initial_state_.parse_parameters(prm, material_);
  charges_.parse_parameters(prm, material_, coarse_mesh_);
  charges_.check(scheme_, initial_state_);
  parse_afterburn(prm);
  reference_.parse_parameters(prm, material_);
  boundary_.parse_parameters(
    prm, material_, coarse_mesh_, initial_state_, reference_);
  adaptation_parameters_.parse_parameters(prm,
                                          dim,
                                          coarse_mesh_.initial_refinement(),
                                          scheme_.n_points,
                                          scheme_.kind ==
                                            Scheme::Kind::finite_volume,
                                          coarse_mesh_.is_axis_aligned());
  adaptation_parameters_.find_buffer_steps(
    scheme_.cfl * scheme_.stability_limit(), dim, scheme_.n_points);
  adaptation_pace_ = AdaptationPace(adaptation_parameters_);
  probes_.parse_parameters(prm, coarse_mesh_);
  parse_body(prm);
  check_places(prm, material_, coarse_mesh_, body_);
  if (!body_.empty() && body_.is_required())
    for (const std::string &line : remarks_on_cuts(prm, coarse_mesh_, body_))
      log_line(line);
  probes_.set_ambient(initial_state_);
  gauges_.parse_parameters(prm, coarse_mesh_);
  gauges_.set_ambient(initial_state_);
  output_.parse_parameters(prm, coarse_mesh_);
  if (!charges_.empty())
    output_.show_burned();
  parse_profile_file(prm);
  const Section section(prm, "Time");
  end_time_ = read_double(prm, "End time");

  layout_ = LeafLayout(dim,
                       scheme_.n_points,
                       dim + 2 + (material_.is_ideal() ? 0 : 1),
                       scheme_.precision);
  points_ = LeafPoints<dim>(scheme_, coarse_mesh_.geometry());
}


template <int dim>
void GasSimulation<dim>::parse_afterburn(ParameterHandler &prm)
{
  const Section section(prm, "Charges");
  afterburn_.parse_parameters(prm);
  if (afterburn_.active() && material_.is_ideal())
    throw InputError("Charges/Afterburn needs Material/Equation of state = "
                     "jwl in air, which knows products");
}


template <int dim>
void GasSimulation<dim>::create_octree()
{
  mesh_.create(coarse_mesh_, scheme_.precision);
  operator_ = make_gas_operator(mesh_,
                                layout_,
                                scheme_,
                                material_,
                                boundary_,
                                body_.empty() ? nullptr : &cut_leaves_);
  stepper_ = std::make_unique<TimeStepper<dim>>(
    mesh_, scheme_, *operator_, skip_quiet_leaves_);
  adaptation_ = std::make_unique<Adaptation<dim>>(
    adaptation_parameters_, mesh_, points_, material_);
  if (!body_.empty())
    adaptation_->set_body(body_, coarse_mesh_.initial_refinement());
  const auto &tria = mesh_.triangulation();
  const typename LeafMesh<dim>::CellIterator last(
    &tria, 0, tria.n_cells(0) - 1);
  maps_.set_ambient(
    initial_state_.ambient_pressure(last->vertex((1U << dim) - 1)));
}


template <int dim>
void GasSimulation<dim>::setup()
{
  create_octree();
  time_ = initial_state_.time();
  adaptation_pace_.restart(time_);
  if (initial_state_.profile() != nullptr)
    go_on_burning();
  refine_octree();
  if (adaptation_parameters_.active)
    fit_mesh_to_initial_state();
  if (!charges_.empty())
    log_line(charges_.description());
  for (const std::string &line : set_initial_state())
    log_line(line);
  if (output_.wants_maps())
    maps_.reinit(layout_.n_points, mesh_.n_owned());
  if (initial_state_.profile() != nullptr)
    go_on_mapping();
  probes_.read(field_, material_, time_);
}


template <int dim>
std::vector<std::string> GasSimulation<dim>::set_initial_state(const bool rough)
{
  const TimerScope timer("initial state");
  field_.reinit(layout_, mesh_.n_stored_batches());
  cut_leaves();
  if (const auto *profile = initial_state_.profile())
  {
    const auto mapping =
      map_profile(*profile, mesh_, points_, material_, field_, rough);
    fill_closed_cells();
    field_.fill_padding(mesh_.n_owned());
    mesh_changed();
    return mapping_report(mapping);
  }
  const auto value = [this](const dealii::Point<dim> &p) {
    return initial_state_.value(p);
  };
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
  {
    const LeafBox<dim> box = leaf_box(mesh_, leaf);
    const dealii::Point<dim> centre =
      box.origin + dealii::Tensor<1, dim>(box.extents * 0.5);
    const double distance = initial_state_.distance_to_feature(centre);
    const bool near_feature =
      distance > 0. && distance <= 0.5 * box.extents.norm();
    field_.set_leaf(leaf,
                    sample_leaf<dim>(value,
                                     box,
                                     points_,
                                     material_,
                                     layout_.n_components,
                                     near_feature,
                                     dim == 3 ? 4 : 8));
  }
  const auto report = charges_.fill(mesh_, points_, field_);
  fill_closed_cells();
  field_.fill_padding(mesh_.n_owned());
  mesh_changed();
  return report;
}


template <int dim>
void GasSimulation<dim>::mesh_changed()
{
  if (!charges_.empty() && !has_burned_)
    detonation_.reinit(mesh_, points_, charges_);
  update_burn();
  cut_leaves();
  stepper_->reinit(field_);
  update_front_shares();
  probes_.reinit(mesh_, points_);
  gauges_.reinit(mesh_, points_);
  open_sides_.reinit(mesh_, boundary_);
}


template <int dim>
void GasSimulation<dim>::update_burn()
{
  has_burned_ = charges_.empty() || has_burned_ || time_ > detonation_.end();
  field_.set_burn(has_burned_ ? nullptr : &detonation_.burn(), time_);
}


template <int dim>
StepReport GasSimulation<dim>::advance(const double largest_step)
{
  const auto rates = stepper_->largest_rates();
  const double stable = stepper_->stable_step(rates);
  const double n_before = stepper_->quiet_leaves().n_possible();
  const auto result =
    stepper_->advance(field_, time_, std::min(stable, largest_step));
  if (result.failed)
    give_up(result);
  time_ += result.step;
  count_work(stepper_->quiet_leaves().n_possible() - n_before,
             result.step / stable);
  n_careful_steps_ += result.careful ? 1. : 0.;
  ++n_steps_;
  adaptation_pace_.add_step(rates.fronts / rates.all);
  update_burn();
  if (afterburn_.release(time_, result.step, mesh_, points_, material_, field_))
    stepper_->analyse(field_);
  probes_.read(field_, material_, time_);
  gauges_.add(field_, material_, time_, result.step);
  if (n_steps_ % OpenSides<dim>::interval == 0)
    open_sides_.watch(field_, material_, ambient().pressure, time_);
  if (loads_.active())
    loads_.add(field_,
               material_,
               scheme_.flux,
               time_,
               result.step,
               stepper_->quiet_leaves(),
               result.wall_force);
  if (!maps_.empty())
  {
    const TimerScope timer("maps");
    maps_.update(
      mesh_, field_, material_, time_, result.step, &stepper_->quiet_leaves());
  }

  const double n_computed = dealii::Utilities::MPI::sum(
    stepper_->quiet_leaves().n_computed(), mesh_.communicator());
  StepReport report;
  report.step_size = result.step;
  report.retries = result.retries;
  report.updates =
    (n_computed - n_computed_) * layout_.n_points * layout_.n_components;
  n_computed_ = n_computed;
  return report;
}


template <int dim>
void GasSimulation<dim>::give_up(
  const typename TimeStepper<dim>::Result &result)
{
  // The first rank with a bad leaf speaks for all.
  const std::string mine =
    result.unphysical_leaf ? describe_leaf(*result.unphysical_leaf) : "";
  std::string text;
  for (const auto &candidate : gather_texts(mesh_.communicator(), mine))
    if (text.empty())
      text = candidate;
  std::ostringstream message;
  message << "The gas turned unphysical at time " << time_
          << " s although the step was halved " << result.retries
          << " times to " << result.step << " s" << text;
  throw NumericsError(message.str());
}


template <int dim>
std::string GasSimulation<dim>::describe_leaf(const unsigned int leaf)
{
  const LeafBox<dim> box = leaf_box(mesh_, leaf);
  const auto values = field_.leaf(leaf);
  std::ostringstream message;
  message << "; in the leaf from " << box.origin << " m with edges "
          << box.extents << " m, whose first point held before the step";
  for (unsigned int c = 0; c < layout_.n_components; ++c)
    message << (c == 0 ? " " : ", ") << values[c * layout_.n_points];
  message << " (density, momentum, energy per volume)";
  return message.str();
}


template <int dim>
std::vector<NamedValue> GasSimulation<dim>::history()
{
  std::vector<NamedValue> values =
    gas_totals(mesh_, points_, field_, material_);
  if (!afterburn_.active())
    return values;
  // What was in the gas from the beginning, without what was released later.
  double initial = 0.;
  for (NamedValue &value : values)
    if (value.name == "energy")
    {
      value.conserved = false;
      initial = value.value - afterburn_.released();
    }
  values.push_back({"energy_before_afterburn", "J", initial, true});
  values.push_back({"afterburn_energy", "J", afterburn_.released()});
  values.push_back({"afterburn_fraction", "-", afterburn_.fraction()});
  return values;
}


template <int dim>
std::vector<NamedValue> GasSimulation<dim>::probes()
{
  return probes_.values(material_.has_products());
}


template <int dim>
std::string GasSimulation<dim>::write_fields(const std::string &folder,
                                             unsigned int index)
{
  gauges_.share();
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    gauges_.write(folder, time_);
  return output_.write(
    {folder, index, time_, mesh_, points_, field_, material_, maps_});
}


template <int dim>
std::vector<NamedValue> GasSimulation<dim>::errors()
{
  for (const std::string &line : probes_.comparison(reference_))
    log_line(line);
  for (const std::string &line : loads_.table())
    log_line(line);
  std::vector<NamedValue> values = probes_.errors(reference_);
  if (reference_.is_measured())
    for (const auto &value :
         gas_errors(mesh_, points_, field_, material_, reference_, time_))
      values.push_back(value);
  return values;
}


template <int dim>
std::vector<NamedValue> GasSimulation<dim>::assumptions()
{
  // Leaves whose sensor fired: shocked ones, or troubled Galerkin ones.
  double troubled = 0.;
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    troubled += field_.sensor_of(leaf) > 0. ? 1. : 0.;
  troubled = dealii::Utilities::MPI::sum(troubled, mesh_.communicator());
  std::vector<NamedValue> values = probes_.measures(reference_);
  for (const NamedValue &value : loads_.audit())
    values.push_back(value);
  values.push_back({"troubled_leaves", "-", troubled / mesh_.n_global()});
  values.push_back({"careful_steps", "-", n_careful_steps_});
  const double n_possible = dealii::Utilities::MPI::sum(
    stepper_->quiet_leaves().n_possible(), mesh_.communicator());
  values.push_back({"skipped_updates",
                    "-",
                    n_possible > 0. ? 1. - n_computed_ / n_possible : 0.});
  return values;
}


template <int dim>
std::pair<std::uint64_t, std::uint64_t> GasSimulation<dim>::size() const
{
  const auto leaves = static_cast<std::uint64_t>(mesh_.n_global());
  return {leaves, leaves * layout_.n_points * layout_.n_components};
}


template <int dim>
void GasSimulation<dim>::save(const std::string &folder)
{
  // After what the ranks do together: one that cannot write lets none wait.
  gauges_.share();
  open_sides_.share(mesh_.communicator());
  loads_.flush();
  save_leaves(mesh_, field_, folder, &maps_);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  loads_.save_file(folder);
  io::write_file(folder + "/gas.bin", [&](std::ostream &out) {
    out.write(reinterpret_cast<const char *>(&time_), sizeof(time_));
    out.write(reinterpret_cast<const char *>(&n_steps_), sizeof(n_steps_));
    out.write(reinterpret_cast<const char *>(&has_burned_),
              sizeof(has_burned_));
    adaptation_pace_.save(out);
    afterburn_.save(out);
    probes_.save(out);
    gauges_.save(out);
    open_sides_.save(out);
    modelling_plan_.save(out);
    loads_.save(out);
  });
}


template <int dim>
void GasSimulation<dim>::restore(const std::string &folder)
{
  create_octree();
  restore_leaves(
    mesh_, field_, layout_, folder, output_.wants_maps() ? &maps_ : nullptr);
  std::istringstream stream(io::read_file(folder + "/gas.bin"));
  stream.read(reinterpret_cast<char *>(&time_), sizeof(time_));
  stream.read(reinterpret_cast<char *>(&n_steps_), sizeof(n_steps_));
  stream.read(reinterpret_cast<char *>(&has_burned_), sizeof(has_burned_));
  adaptation_pace_.load(stream);
  afterburn_.load(stream);
  probes_.load(stream);
  gauges_.load(stream);
  open_sides_.load(stream);
  modelling_plan_.load(stream);
  loads_.load(stream);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    loads_.restore_file(folder);
  mesh_changed();
  if (!stream)
    throw InputError("Checkpoint file " + folder +
                     "/gas.bin belongs to another scene");
}


template class GasSimulation<1>;
template class GasSimulation<2>;
template class GasSimulation<3>;
} // namespace contrecoup::gas
