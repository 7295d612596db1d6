// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/collective.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/gas/conditions/profile_field.h>
#include <contrecoup/gas/record/gas_measures.h>
#include <contrecoup/gas/run/cost_estimate.h>
#include <contrecoup/gas/run/gas_checkpoint.h>
#include <contrecoup/gas/run/gas_core.h>
#include <contrecoup/gas/run/initial_fill.h>
#include <contrecoup/geometry/mesh/cell_shapes.h>

#include <sstream>

namespace contrecoup::gas
{
namespace
{
  template <typename Number>
  void write_number(std::ostream &stream, const Number &number)
  {
    stream.write(reinterpret_cast<const char *>(&number), sizeof(number));
  }

  template <typename Number>
  void read_number(std::istream &stream, Number &number)
  {
    stream.read(reinterpret_cast<char *>(&number), sizeof(number));
  }


  /// Speed that no gas reaches which a detonation drives [m/s]; products that
  /// expand into a vacuum have some 1e4.
  constexpr double impossible_speed = 1e7;

  /// @throws NumericsError when the step falls as in void cells between the
  /// products of a charge and thin air, whose energy stays when their mass has
  /// left: with linear reconstruction this happens where few cells resolve the
  /// charge.
  /// @param speed largest sum of the speeds of flow and sound [m/s]
  void require_possible_speed(const double speed,
                              const double cell,
                              const double time)
  {
    if (speed > impossible_speed)
      throw NumericsError(
        "At time " + brief(time) + " s signals travel at " + brief(speed) +
        " m/s: between the products of a charge and the thin air around it "
        "cells have lost nearly all their mass, and steps would not end; use "
        "cells smaller than " +
        brief(cell) +
        " m, at least eight along the radius of the charge, Method/"
        "Reconstruction = constant, or denser air");
  }
} // namespace


template <int dim>
GasCore<dim>::GasCore(const GasScene<dim> &scene, const MPI_Comm communicator)
  : scene_(scene)
  , mesh_(communicator)
  , body_(scene, mesh_)
{}


template <int dim>
void GasCore<dim>::declare_parameters(ParameterHandler &prm)
{
  QuietLeaves<dim>::declare_parameters(prm);
  AdaptationParameters::declare_parameters(prm);
}


template <int dim>
void GasCore<dim>::parse_parameters(ParameterHandler &prm)
{
  const Scheme &scheme = scene_.scheme;
  skip_quiet_leaves_ = QuietLeaves<dim>::parse_parameters(prm);
  adaptation_parameters_.parse_parameters(
    prm,
    dim,
    scene_.coarse_mesh.initial_refinement(),
    scheme.n_points,
    scheme.kind == Scheme::Kind::finite_volume,
    scene_.coarse_mesh.is_axis_aligned());
  scene_.check_subcells();
  adaptation_parameters_.find_buffer_steps(
    scheme.cfl * scheme.stability_limit(), dim, scheme.n_points);
  const Section section(prm, "Charges");
  afterburn_.parse_parameters(prm);
  if (afterburn_.active() && scene_.material.is_ideal())
    throw InputError("Charges/Afterburn needs Material/Equation of state = "
                     "jwl in air, which has products");
  if (const auto start = afterburn_.start(); start >= scene_.end_time)
    log_line("WARNING: Charges/Afterburn/Start time = " + brief(*start) +
             " s is not before Time/End time = " + brief(scene_.end_time) +
             " s: nothing burns on");
}


template <int dim>
void GasCore<dim>::create_octree()
{
  mesh_.create(
    scene_.coarse_mesh, scene_.scheme.precision, scene_.scheme.cell_degree);
  quiet_leaves_ = std::make_unique<QuietLeaves<dim>>(mesh_, skip_quiet_leaves_);
  stepper_ =
    make_time_stepper<dim>({mesh_,
                            scene_.layout,
                            scene_.scheme,
                            scene_.boundary,
                            body_.empty() ? nullptr : &body_.cut_leaves()},
                           scene_.material,
                           *quiet_leaves_);
  adaptation_ = std::make_unique<Adaptation<dim>>(
    adaptation_parameters_, mesh_, scene_.points, scene_.material);
  if (!body_.empty())
    adaptation_->set_body(scene_.body, scene_.coarse_mesh.initial_refinement());
}


template <int dim>
void GasCore<dim>::refine_octree()
{
  mesh_.triangulation().refine_global(scene_.coarse_mesh.initial_refinement());
  mesh_.distribute();
  adaptation_->refine_fine_box();
  if (!scene_.coarse_mesh.is_axis_aligned())
    Collective(mesh_.communicator()).run([&]() {
      const std::string entry = "Domain/Initial refinement";
      check_cell_shapes(mesh_.triangulation(), entry);
      if (mesh_.curved_shapes() != nullptr)
        mesh_.curved_shapes()->check(entry);
    });
  adaptation_->refine_at_body();
}


template <int dim>
void GasCore<dim>::build_octree()
{
  create_octree();
  refine_octree();
  body_.mesh_changed();
}


template <int dim>
std::vector<std::string> GasCore<dim>::set_up()
{
  create_octree();
  time_ = scene_.initial_state.time();
  if (scene_.initial_state.profile() != nullptr)
    inherit_afterburn();
  refine_octree();
  if (adaptation_parameters_.active)
    fit_mesh_to_initial_state();
  adaptation_->restart(time_);
  return set_initial_state();
}


template <int dim>
void GasCore<dim>::inherit_afterburn()
{
  const ProfileField<dim> &profile = *scene_.initial_state.profile();
  const auto fraction = profile.fraction_within(
    scene_.coarse_mesh.lower_corner(), scene_.coarse_mesh.upper_corner());
  const auto &data = profile.profile().data();
  afterburn_.set_released(data.afterburn_fraction,
                          fraction.value_or(1.) * data.afterburn_released);
}


template <int dim>
void GasCore<dim>::fit_mesh_to_initial_state()
{
  while (adaptation_->refine_where([this](const unsigned int leaf) {
    return varies_in_leaf(scene_, mesh_, leaf);
  }))
    ;
  // The sensor then detects smooth variations, which distances do not tell.
  for (unsigned int level = 0; level < adaptation_parameters_.max_level;
       ++level)
  {
    set_initial_state(true);
    stepper_->update_ghosts(field_);
    if (!adaptation_->adapt(field_))
      break;
  }
}


template <int dim>
std::vector<std::string> GasCore<dim>::set_initial_state(const bool rough)
{
  const TimerScope timer("initial state");
  field_.reinit(scene_.layout, mesh_.n_stored_batches());
  cut_leaves();
  const auto report = fill_initial_state(scene_, mesh_, field_, rough);
  body_.fill_closed_cells(field_);
  field_.fill_padding(mesh_.n_owned());
  state_changed();
  return report;
}


template <int dim>
void GasCore<dim>::mesh_changed()
{
  cut_leaves();
  state_changed();
}


template <int dim>
void GasCore<dim>::cut_leaves()
{
  body_.mesh_changed();
  if (!body_.empty())
    field_.set_open_fractions(&body_.cut_leaves().fractions());
}


template <int dim>
void GasCore<dim>::state_changed()
{
  if (!scene_.charges.empty() && !has_burned_)
    detonation_.reinit(mesh_, scene_.points, scene_.charges);
  update_burn();
  stepper_->reinit(field_);
  adaptation_->update_size_ratios();
}


template <int dim>
void GasCore<dim>::update_burn()
{
  has_burned_ =
    scene_.charges.empty() || has_burned_ || time_ > detonation_.end();
  field_.set_burn(has_burned_ ? nullptr : &detonation_.burn(), time_);
}


template <int dim>
StepReport GasCore<dim>::advance(const double largest_step)
{
  const auto rates = stepper_->largest_rates(adaptation_->size_ratios());
  const double stable = stepper_->stable_step(rates.all);
  if (!scene_.charges.empty())
  {
    const double cell = smallest_subcell()[0];
    require_possible_speed(rates.all * cell / dim, cell, time_);
  }
  const double computed_before = quiet_leaves_->n_computed(),
               possible_before = quiet_leaves_->n_possible();
  const auto result =
    stepper_->advance(field_, time_, std::min(stable, largest_step));
  if (result.failed)
    fail(result);
  time_ += result.step;
  ++n_steps_;
  last_step_ = result.step;
  wall_force_ = result.wall_force;
  n_bounded_steps_ += result.bound_velocity_slopes ? 1. : 0.;
  std::vector<double> made{quiet_leaves_->n_computed() - computed_before,
                           quiet_leaves_->n_possible() - possible_before};
  count_work(made[1], result.step / stable);
  adaptation_->add_step(rates.front_rate / rates.all);
  update_burn();
  if (afterburn_.release(
        time_, result.step, mesh_, scene_.points, scene_.material, field_))
    stepper_->analyse(field_);

  dealii::Utilities::MPI::sum(made, mesh_.communicator(), made);
  StepReport report;
  report.step_size = result.step;
  report.retries = result.retries;
  report.updates =
    made[0] * scene_.layout.n_points * scene_.layout.n_components;
  n_computed_ += made[0];
  n_possible_ += made[1];
  return report;
}


template <int dim>
void GasCore<dim>::count_work(const double n_computed, const double fraction)
{
  constexpr double decay = 0.99;
  const double n_stages = scene_.scheme.time_stepping.stages.size();
  n_made_ = decay * n_made_ + n_computed;
  n_needed_ = decay * n_needed_ + fraction * n_stages * mesh_.n_owned();
}


template <int dim>
void GasCore<dim>::fail(const typename TimeStepper<dim>::Result &result)
{
  // The message is that of the first rank with an unphysical leaf.
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
std::string GasCore<dim>::describe_leaf(const unsigned int leaf)
{
  const LeafBox<dim> box = leaf_box(mesh_, leaf);
  const auto values = field_.leaf(leaf);
  std::ostringstream message;
  message << "; in the leaf from " << box.origin << " m with edges "
          << box.extents << " m, whose first point held before the step";
  for (unsigned int c = 0; c < scene_.layout.n_components; ++c)
    message << (c == 0 ? " " : ", ") << values[c * scene_.layout.n_points];
  message << " (density, momentum, energy per volume)";
  return message.str();
}


template <int dim>
bool GasCore<dim>::adapt(BlastMaps<dim> &maps)
{
  if (!adaptation_->is_due())
    return false;
  adaptation_->restart(time_);
  stepper_->update_ghosts(field_);
  const bool changed =
    adaptation_->adapt(field_, maps, time_, quiet_leaves_.get());
  if (changed)
    mesh_changed();
  else
    adaptation_->update_size_ratios();
  return changed;
}


template <int dim>
void GasCore<dim>::save(std::ostream &stream) const
{
  write_number(stream, time_);
  write_number(stream, n_steps_);
  write_number(stream, has_burned_);
  write_number(stream, n_bounded_steps_);
  write_number(stream, n_computed_);
  write_number(stream, n_possible_);
  adaptation_->save(stream);
  afterburn_.save(stream);
}


template <int dim>
void GasCore<dim>::load(std::istream &stream)
{
  read_number(stream, time_);
  read_number(stream, n_steps_);
  read_number(stream, has_burned_);
  read_number(stream, n_bounded_steps_);
  read_number(stream, n_computed_);
  read_number(stream, n_possible_);
  adaptation_->load(stream);
  afterburn_.load(stream);
}


template <int dim>
void GasCore<dim>::restore_leaves(const std::string &folder,
                                  BlastMaps<dim> *maps)
{
  create_octree();
  gas::restore_leaves(mesh_, field_, scene_.layout, folder, maps);
}


template <int dim>
GasSnapshot<dim> GasCore<dim>::snapshot() const
{
  return {scene_,
          mesh_,
          field_,
          body_.cut_leaves(),
          *quiet_leaves_,
          time_,
          last_step_,
          n_steps_,
          wall_force_};
}


template <int dim>
std::vector<NamedValue> GasCore<dim>::totals() const
{
  std::vector<NamedValue> values =
    gas_totals(mesh_, scene_.points, field_, scene_.material);
  if (!afterburn_.active())
    return values;
  // The initial content of the gas, without energy released later.
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
double GasCore<dim>::skipped_updates() const
{
  return n_possible_ > 0. ? 1. - n_computed_ / n_possible_ : 0.;
}


template <int dim>
std::vector<NamedValue> GasCore<dim>::checks() const
{
  // Leaves with a positive sensor: with a shock or, in the Galerkin scheme,
  // troubled.
  double troubled = 0.;
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    troubled += field_.sensor_of(leaf) > 0. ? 1. : 0.;
  troubled = dealii::Utilities::MPI::sum(troubled, mesh_.communicator());
  return {{"troubled_leaves", "-", troubled / mesh_.n_global()},
          {"careful_steps", "-", n_bounded_steps_},
          {"skipped_updates", "-", skipped_updates()}};
}


template <int dim>
dealii::Tensor<1, dim> GasCore<dim>::smallest_subcell() const
{
  const CoarseMesh<dim> &mesh = scene_.coarse_mesh;
  dealii::Tensor<1, dim> result = mesh.upper_corner() - mesh.lower_corner();
  const unsigned int level = adaptation_parameters_.active
                               ? adaptation_parameters_.max_level
                               : mesh.initial_refinement();
  for (unsigned int d = 0; d < dim; ++d)
    result[d] /= mesh.coarse_cells(d) * std::pow(2., level) * scene_.layout.n;
  return result;
}


template <int dim>
WorkForecast
GasCore<dim>::expected_work(const double end_time,
                            const dealii::Point<dim> &centre,
                            const std::function<double(double)> &front) const
{
  const WorkForecaster<dim> forecaster(
    mesh_,
    *stepper_,
    *quiet_leaves_,
    *adaptation_,
    centre,
    front,
    signal_speed(scene_.ambient(), scene_.material));
  const double made =
    dealii::Utilities::MPI::sum(n_made_, mesh_.communicator());
  const double needed =
    dealii::Utilities::MPI::sum(n_needed_, mesh_.communicator());
  // Unknown updates of one leaf in all Runge-Kutta stages of a stable step.
  const double updates = (needed > 0. ? made / needed : 1.) *
                         scene_.layout.n_points * scene_.layout.n_components *
                         scene_.scheme.time_stepping.stages.size() /
                         (scene_.scheme.cfl * scene_.scheme.stability_limit());
  WorkForecast result = forecaster.forecast(time_, end_time);
  for (auto &[until, work] : result)
    work *= updates;
  return result;
}


template class GasCore<1>;
template class GasCore<2>;
template class GasCore<3>;
} // namespace contrecoup::gas
