// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/coupling/first_stage/staged_simulation.h>
#include <contrecoup/gas/scene/scene_bursts.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/io/file/checked_file.h>

#include <sstream>

namespace contrecoup::coupling
{
namespace
{
  template <typename Number>
  void write_number(std::ostream &stream, const Number number)
  {
    stream.write(reinterpret_cast<const char *>(&number), sizeof(number));
  }

  template <typename Number>
  void read_number(std::istream &stream, Number &number)
  {
    stream.read(reinterpret_cast<char *>(&number), sizeof(number));
  }

  /// Checkpoint file of the stages; nested first stages share the folder.
  template <int dim>
  std::string stages_file(const std::string &folder)
  {
    return folder + "/stages_" + std::to_string(dim) + "d.bin";
  }

  /// Distance from @p centre at which the front of the scene's reference
  /// arrives at @p time, if it knows that; else @p estimate [m].
  template <int dim>
  double expected_front(const gas::ReferenceSolution<dim> &reference,
                        const dealii::Point<dim> &centre,
                        const double time,
                        const double estimate)
  {
    if (!reference.has_arrivals())
      return estimate;
    const auto arrival = [&](const double distance) {
      dealii::Point<dim> place = centre;
      place[dim - 1] += distance;
      return reference.arrival(place).arrival;
    };
    double low = 0.5 * estimate, high = 2. * estimate;
    while (high - low > 1e-6 * estimate)
    {
      const double middle = 0.5 * (low + high);
      (arrival(middle) < time ? low : high) = middle;
    }
    return std::abs(arrival(high) - time) < 1e-3 * time ? high : estimate;
  }
} // namespace


template <int dim>
StagedSimulation<dim>::StagedSimulation(const MPI_Comm communicator)
  : communicator_(communicator)
  , scene_(communicator)
{}


template <int dim>
void StagedSimulation<dim>::declare_parameters(ParameterHandler &prm)
{
  gas::GasSimulation<dim>::declare_parameters(prm);
  FirstStageParameters::declare_parameters(prm);
}


template <int dim>
void StagedSimulation<dim>::parse_parameters(ParameterHandler &prm)
{
  const auto declare = [](ParameterHandler &other) {
    TimeParameters::declare_parameters(other);
    declare_parameters(other);
  };
  parameters_.parse_parameters(prm);
  plan_ = make_first_stage_layout<dim>(prm, parameters_);
  ParameterHandler second;
  declare(second);
  derive_second_stage(prm, second);
  // The scene's gas has no charges of its own any more.
  GasMaterial material;
  material.parse_parameters(prm);
  CoarseMesh<dim> mesh;
  mesh.parse_parameters(prm);
  if (gas::has_several_explosions(gas::read_bursts(prm, material, mesh)))
  {
    const Section section(second, "Reference");
    second.set("Kind", "none");
  }
  scene_.parse_parameters(second);
  const std::string late = parameters_.late_hand_over(scene_.scene().end_time);
  if (!late.empty())
    throw InputError(late);
  auto places = scene_.probe_set().places();
  const auto &rasters = scene_.probe_rasters().places();
  places.insert(places.end(), rasters.begin(), rasters.end());
  first_ = make_first_stage<dim>(
    prm, declare, parameters_, plan_, places, communicator_);
  bool is_trial = false;
  {
    const Section section(prm, "Rigid body");
    is_trial = !prm.get_bool("Required");
  }
  if (is_trial)
    return;
  check_hand_over_order();
  for (const std::string &line : gas::remarks_on_bursts(prm, material, mesh))
    log_line(line);
}


template <int dim>
void StagedSimulation<dim>::check_hand_over_order() const
{
  const double cell = parameters_.cell_size,
               spherical_cell = parameters_.spherical_cell_size;
  if (spherical_cell == 0. || parameters_.criterion != "auto")
    return;
  // Distances of the front at the hand-over of the spherical and of the
  // axisymmetric stage.
  const double first =
    plan_.along_axis -
    std::min(2. * cell + 4. * spherical_cell, 0.5 * plan_.along_axis);
  const double second = plan_.nearest_side - margin();
  if (first >= second)
    throw InputError(
      "First stage: the spherical stage ends when its front is at " +
      brief(first) +
      " m, near the ground, and the axisymmetric one would end "
      "at " +
      brief(second) +
      " m, near the body or a side of the domain; use Kind = spherical, since "
      "no axisymmetric stage remains");
}


template <int dim>
Simulation &StagedSimulation<dim>::active() const
{
  return first_ ? first_->simulation() : scene_;
}


template <int dim>
CostEstimate StagedSimulation<dim>::estimate()
{
  CostEstimate result = scene_.estimate();
  if (first_)
  {
    const CostEstimate first = first_->simulation().estimate();
    result.steps += first.steps;
    result.seconds += first.seconds;
    result.memory += first.memory;
  }
  return result;
}


template <int dim>
void StagedSimulation<dim>::setup()
{
  first_->simulation().setup();
  read_probes(0.);
  if (is_due())
    hand_over();
}


template <int dim>
void StagedSimulation<dim>::read_probes(const double step)
{
  auto &probes = scene_.probe_set();
  auto &rasters = scene_.probe_rasters();
  const double now = time();
  std::vector<gas::GasState<dim>> states(probes.places().size(),
                                         scene_.scene().ambient());
  first_->for_each_place(
    [&](const std::size_t i, const gas::GasState<dim> &state) {
      if (i < states.size())
        states[i] = state;
      else
        rasters.take(i - states.size(), state, now, step);
    });
  probes.take(states, now);
}


template <int dim>
double StagedSimulation<dim>::margin() const
{
  // The front of the second stage is two subcells wide.
  double margin = 0.;
  const auto cell = scene_.core().smallest_subcell();
  for (unsigned int d = 0; d < dim; ++d)
    margin = std::max(margin, 2. * cell[d]);
  // A trial run for cost estimates has larger subcells and must continue.
  return std::min(margin + 4. * parameters_.cell_size,
                  0.5 * plan_.nearest_side);
}


template <int dim>
bool StagedSimulation<dim>::is_due()
{
  if (first_->is_burning())
  {
    if (first_->front() >= plan_.nearest_side &&
        parameters_.criterion == "auto")
      throw InputError("First stage: the front reaches a side of the domain "
                       "before all of the charge has burned; use First "
                       "stage/Kind = none, or axisymmetric");
    return false;
  }
  if (!first_->is_ready())
  {
    if (first_->front() >= plan_.nearest_side - margin())
      throw InputError("First stage: the front is as near to the body or a "
                       "side of the domain as to the ground; use Kind = "
                       "spherical, since no axisymmetric stage remains");
    return false;
  }
  if (parameters_.criterion == "time")
    return time() >= parameters_.time * (1. - 1e-13);
  return first_->front() >= hand_over_distance();
}


template <int dim>
double StagedSimulation<dim>::hand_over_distance() const
{
  return parameters_.criterion == "radius" ? parameters_.radius
                                           : plan_.nearest_side - margin();
}


template <int dim>
void StagedSimulation<dim>::hand_over()
{
  const TimerScope timer("hand-over");
  hand_over_time_ = time();
  hand_over_radius_ = first_->front();
  log_line("first stage ends at " + brief(hand_over_time_, 6) +
           " s with its front at " + brief(hand_over_radius_, 6) +
           " m from the charge");
  auto profile = std::make_shared<const gas::Profile>(first_->profile());
  first_.reset();
  scene_.start_from(std::move(profile), plan_.centre);
  const auto size = scene_.size();
  log_line("second stage: " + std::to_string(size.first) + " cells, " +
           std::to_string(size.second) + " unknowns");
}


template <int dim>
double StagedSimulation<dim>::time() const
{
  return active().time();
}


template <int dim>
StepReport StagedSimulation<dim>::advance(const double largest_step)
{
  if (!first_)
    return scene_.advance(largest_step);
  double step = largest_step;
  if (parameters_.criterion == "time")
    step = std::min(step,
                    parameters_.time > time() ? parameters_.time - time()
                                              : largest_step);
  const StepReport report = first_->simulation().advance(step);
  read_probes(report.step_size);
  return report;
}


template <int dim>
bool StagedSimulation<dim>::adapt()
{
  const bool changed = active().adapt();
  if (!first_)
    return changed;
  front_path_.add(time(), first_->front());
  if (!is_due())
    return changed;
  hand_over();
  return true;
}


template <int dim>
WorkForecast StagedSimulation<dim>::expected_work(const double end_time)
{
  return active().expected_work(end_time);
}


template <int dim>
std::optional<double> StagedSimulation<dim>::expected_hand_over()
{
  if (!first_)
    return std::nullopt;
  if (const auto earlier = first_->simulation().expected_hand_over())
    return earlier;
  if (parameters_.criterion == "time")
    return parameters_.time;
  return front_path_.arrival(hand_over_distance());
}


template <int dim>
std::vector<NamedValue> StagedSimulation<dim>::history()
{
  if (!first_)
    return scene_.history();
  const auto &mesh = scene_.scene().coarse_mesh;
  const auto state = gas::conserved_state(
    scene_.scene().ambient(), scene_.scene().material, dim + 3);
  double volume = 1.;
  for (unsigned int d = 0; d < dim; ++d)
    volume *= mesh.upper_corner()[d] - mesh.lower_corner()[d];
  if (mesh.geometry() == Geometry::axisymmetric)
    volume *=
      dealii::numbers::PI * (mesh.upper_corner()[0] + mesh.lower_corner()[0]);
  if (!body_volume_)
    body_volume_ = scene_.body_volume();
  volume -= *body_volume_;
  return first_->history(
    {{volume * state[0], volume * state[dim + 1], volume * state[dim + 2]}});
}


template <int dim>
std::vector<FieldFile>
StagedSimulation<dim>::write_fields(const std::string &folder,
                                    const unsigned int index)
{
  return active().write_fields(folder, index);
}


template <int dim>
std::vector<NamedValue> StagedSimulation<dim>::errors()
{
  return first_ ? std::vector<NamedValue>() : scene_.errors();
}


template <int dim>
std::vector<NamedValue> StagedSimulation<dim>::results()
{
  if (first_)
    return scene_.probe_set().measures(scene_.scene().reference);
  return scene_.results();
}


template <int dim>
std::vector<NamedValue> StagedSimulation<dim>::checks()
{
  if (first_)
    return {};
  auto values = scene_.checks();
  values.push_back({"hand_over_time", "s", hand_over_time_});
  values.push_back({"hand_over_radius", "m", hand_over_radius_});
  return values;
}


template <int dim>
Assumption StagedSimulation<dim>::hand_over_item(const double radius) const
{
  return {"first_stage",
          parameters_.kind + " at first",
          "distance of the front at the hand-over",
          "m",
          radius,
          plan_.nearest_side,
          false,
          "First stage/Hand over at"};
}


template <int dim>
std::vector<Assumption> StagedSimulation<dim>::plan()
{
  double radius = hand_over_distance();
  auto centre = plan_.centre;
  if (first_)
  {
    const auto blast = first_->blast();
    if (parameters_.kind == "axisymmetric")
      centre[dim - 1] = blast.height;
    scene_.expect_blast(blast.energy, centre, blast.non_ideal_fraction);
  }
  const auto rest = scene_.plan();
  if (!first_)
    radius = hand_over_radius_;
  else if (parameters_.criterion == "time")
    radius =
      expected_front(scene_.scene().reference,
                     centre,
                     parameters_.time,
                     scene_.modelling_plan().expected_front(parameters_.time));
  std::vector<Assumption> items = {hand_over_item(radius)};
  for (const Assumption &item : rest)
    if (item.name != items.front().name)
      items.push_back(item);
  return items;
}


template <int dim>
std::vector<Assumption> StagedSimulation<dim>::audit()
{
  if (first_)
    return {};
  std::vector<Assumption> items = {hand_over_item(hand_over_radius_)};
  for (const Assumption &item : scene_.audit())
    items.push_back(item);
  return items;
}


template <int dim>
std::vector<std::string> StagedSimulation<dim>::gaps()
{
  if (!first_)
    return scene_.gaps();
  std::vector<std::string> lines = scene_.probe_set().gaps(time());
  for (const std::string &line : scene_.probe_rasters().gaps(time()))
    lines.push_back(line);
  lines.emplace_back(
    "the run ends in its first stage: fields, tables and files of the second "
    "one (reference, profiles, gauges, injuries, maps, loads) are missing");
  return lines;
}


template <int dim>
std::pair<std::uint64_t, std::uint64_t> StagedSimulation<dim>::size() const
{
  return active().size();
}


template <int dim>
void StagedSimulation<dim>::save(const std::string &folder)
{
  active().save(folder);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    io::write_file(stages_file<dim>(folder), [&](std::ostream &out) {
      write_number<std::uint64_t>(out, first_ ? 1 : 2);
      write_number(out, hand_over_time_);
      write_number(out, hand_over_radius_);
      scene_.probe_set().save(out, folder);
      scene_.probe_rasters().save(out, folder);
    });
}


template <int dim>
void StagedSimulation<dim>::restore(const std::string &folder)
{
  std::istringstream stream(io::read_file(stages_file<dim>(folder)));
  std::uint64_t stage = 0;
  read_number(stream, stage);
  read_number(stream, hand_over_time_);
  read_number(stream, hand_over_radius_);
  scene_.probe_set().load(stream, folder);
  scene_.probe_rasters().load(stream, folder);
  if (!stream || stage < 1 || stage > 2)
    throw InputError("Checkpoint file " + stages_file<dim>(folder) +
                     " belongs to another scene");
  if (stage == 2)
    first_.reset();
  active().restore(folder);
}


template class StagedSimulation<2>;
template class StagedSimulation<3>;
} // namespace contrecoup::coupling
