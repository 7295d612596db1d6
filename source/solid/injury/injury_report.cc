// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/body/stress_invariants.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/injury/injury_report.h>
#include <contrecoup/solid/motion/mean_motion.h>

#include <cmath>
#include <limits>

namespace contrecoup::solid
{
namespace
{
  using dealii::Tensor;

  /// Bone whose centre is that near to the box around the brain counts as skull
  /// [m]: fluid and bone around a brain are thinner.
  constexpr double skull_reach = 0.015;


  /// Mean over the corners of an element.
  template <typename Value>
  Tensor<1, 3> mean_of(const SolidMesh &mesh,
                       const std::uint32_t element,
                       const Value &value)
  {
    Tensor<1, 3> mean;
    for (const std::uint32_t node : mesh.elements[element])
      for (unsigned int d = 0; d < 3; ++d)
        mean[d] += value(node, d) / 8.;
    return mean;
  }

} // namespace


template <typename Real>
void InjuryReport<Real>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Injury");
  declare_bool(
    prm,
    "Active",
    "false",
    selecting("Whether strains and pressures of the brain, motion of the "
              "head and pressure on the chest are recorded for injury.csv."));
  const UsedWith used("Injury/Active = true");
  declare_selection(prm,
                    "Pressure",
                    "averaged",
                    peak_pressure_names(),
                    "Pressure in the brain: of each element, or averaged "
                    "over its corners and the elements around them. "
                    "Averaging removes checkerboard pressures, and a tenth "
                    "of waves as short as ten elements.");
  declare_integer(prm,
                  "Every steps",
                  "10",
                  1,
                  1000000,
                  "Steps between evaluations; peaks in between are missed.");
  ChestInjury::declare_parameters(prm);
  OwnThresholds::declare_parameters(prm);
}


template <typename Real>
void InjuryReport<Real>::parse_parameters(ParameterHandler &prm,
                                          const MeshDescription &mesh)
{
  own_.parse_parameters(prm, "Injury");
  const Section section(prm, "Injury");
  active_ = prm.get_bool("Active");
  averaged_ = prm.get("Pressure") == peak_pressure_names()[0];
  interval_ = read_unsigned(prm, "Every steps");
  chest_.parse_parameters(prm, mesh.phantom_mass());
  if (!active_)
    own_.require({}, "Injury/Active = false");
  std::vector<std::string> taken = injury_measures_of({"head"});
  for (const std::string &name : chest_.measure_names())
    taken.push_back(name);
  own_.require(taken, chest_.reports_load() ? "" : "Injury/Chest load = false");
}


template <typename Real>
void InjuryReport<Real>::reinit(const SolidBody<Real> &body)
{
  if (!active_)
    return;
  const SolidMesh &mesh = body.mesh();
  brain_ = static_cast<unsigned int>(
    std::find(mesh.tissues.begin(), mesh.tissues.end(), Tissue::brain) -
    mesh.tissues.begin());
  average_.reinit(mesh, body.exchange(), brain_);
  sample_of_element_.assign(mesh.elements.size(), no_index);
  record_.samples.clear();
  for (const std::uint32_t cell : average_.elements())
  {
    sample_of_element_[cell] =
      static_cast<std::uint32_t>(record_.samples.size());
    BrainSample sample;
    sample.cell = mesh.global_element[cell];
    sample.volume = average_.volumes()[record_.samples.size()];
    record_.samples.push_back(sample);
  }
  find_skull(body);
  check(mesh, body.communicator());
  record_.last_time = body.time();
}


template <typename Real>
std::vector<Assumption>
InjuryReport<Real>::assumptions(const SolidBody<Real> &body) const
{
  std::vector<Assumption> items = own_.assumptions();
  // The mass of a part of a person says nothing about the person.
  const bool is_person =
    has(Tissue::lung, body.mesh()) && has(Tissue::brain, body.mesh());
  if (active_ && chest_.reports_load() && is_person && chest_.guesses_mass())
    items.push_back(
      {"body_mass",
       "lungs are those of a person of " + brief(chest_.body_mass(), 3) + " kg",
       "relative difference of the body's mass",
       "-",
       std::abs(body.mass() / chest_.body_mass() - 1.),
       0.1,
       false,
       "Injury/Body mass"});
  return items;
}


template <typename Real>
void InjuryReport<Real>::check(const SolidMesh &mesh,
                               const MPI_Comm communicator)
{
  if (!active_)
    return;
  chest_wall_.reinit(mesh, chest_.place(), chest_.radius(), communicator);
  if (has(Tissue::lung, mesh))
    refuse_far_chest();
}


template <typename Real>
bool InjuryReport<Real>::has(const Tissue tissue, const SolidMesh &mesh)
{
  return std::find(mesh.tissues.begin(), mesh.tissues.end(), tissue) !=
         mesh.tissues.end();
}


template <typename Real>
void InjuryReport<Real>::refuse_far_chest() const
{
  const double allowed =
    std::max(chest_.radius(), 2. * chest_wall_.facet_edge());
  if (chest_wall_.distance() <= allowed)
    return;
  const dealii::Point<3> &place = chest_.place();
  throw InputError("Injury/Chest = " + coordinates(place) + " is " +
                   brief(chest_wall_.distance(), 3) +
                   " m from the skin, more than Injury/Chest radius and two "
                   "elements, " +
                   brief(allowed, 3) +
                   " m; set it to a point on the chest of this body");
}


template <typename Real>
void InjuryReport<Real>::record(const SolidBody<Real> &body)
{
  if (!active_)
    return;
  const TimerScope timer("injury");
  if (++record_.n_steps % interval_ != 0)
    return;
  follow_brain(body, body.time() - record_.last_time);
  record_.last_time = body.time();
  follow_head(body);
  chest_.record(body.time(),
                body.loads().pressure_near(chest_.place(), body.communicator()),
                chest_wall_.inward_velocity(body.nodes()));
}


template <typename Real>
void InjuryReport<Real>::follow_brain(const SolidBody<Real> &body,
                                      const double span)
{
  std::vector<double> pressures(record_.samples.size());
  body.elements().visit(
    body.nodes(),
    body.times(),
    [&](const std::uint32_t cell, const ElementValues &element) {
      const std::uint32_t i = sample_of_element_[cell];
      pressures[i] = pressure_of(element.stress);
      record_.samples[i].record_strain(
        raised_to_principal(record_.samples[i].peak_strain, element.strain));
    },
    brain_);
  record_pressures(span,
                   pressures,
                   average_.average(pressures),
                   averaged_,
                   record_.samples,
                   record_.sums);
}


template <typename Real>
void InjuryReport<Real>::find_skull(const SolidBody<Real> &body)
{
  namespace mpi = dealii::Utilities::MPI;
  const SolidMesh &mesh = body.mesh();
  const auto centre = [&](const std::uint32_t element) {
    return mean_of(
      mesh, element, [&](const std::uint32_t node, const unsigned int d) {
        return mesh.nodes[node][d];
      });
  };
  Tensor<1, 3> low, high;
  for (unsigned int d = 0; d < 3; ++d)
  {
    low[d] = std::numeric_limits<double>::max();
    high[d] = -low[d];
  }
  for (const std::uint32_t element : average_.elements())
    for (unsigned int d = 0; d < 3; ++d)
    {
      low[d] = std::min(low[d], centre(element)[d]);
      high[d] = std::max(high[d], centre(element)[d]);
    }
  for (unsigned int d = 0; d < 3; ++d)
  {
    low[d] = mpi::min(low[d], body.communicator()) - skull_reach;
    high[d] = mpi::max(high[d], body.communicator()) + skull_reach;
  }
  skull_.clear();
  for (std::uint32_t i = 0; i < mesh.elements.size(); ++i)
  {
    if (mesh.tissues[mesh.tissue[i]] != Tissue::skeleton)
      continue;
    const Tensor<1, 3> place = centre(i);
    bool is_near = true;
    for (unsigned int d = 0; d < 3; ++d)
      is_near = is_near && place[d] >= low[d] && place[d] <= high[d];
    if (is_near)
      skull_.emplace_back(i, cell_volume(mesh, i));
  }
  has_skull_ = mpi::sum(skull_.size(), body.communicator()) > 0;
}


template <typename Real>
void InjuryReport<Real>::follow_head(const SolidBody<Real> &body)
{
  // Each element is a point mass at its centre.
  MeanMotion moving, head;
  const SolidMesh &mesh = body.mesh();
  const auto add =
    [&](const std::uint32_t element, const double volume, const bool moves) {
      const Tensor<1, 3> place = mean_of(
        mesh, element, [&](const std::uint32_t node, const unsigned int d) {
          return mesh.nodes[node][d] +
                 double(body.nodes().displacement_of(node)[d]);
        });
      const Tensor<1, 3> velocity = mean_of(
        mesh, element, [&](const std::uint32_t node, const unsigned int d) {
          return double(body.nodes().velocity_of(node)[d]);
        });
      head.add(volume, place, velocity);
      if (moves)
        moving.add(volume, place, velocity);
    };
  for (std::size_t i = 0; i < record_.samples.size(); ++i)
    add(average_.elements()[i], record_.samples[i].volume, !has_skull_);
  for (const auto &[element, volume] : skull_)
    add(element, volume, true);
  // Both are collective.
  const bool has_head = head.find(body.communicator()),
             has_motion = moving.find(body.communicator());
  if (!has_head || !has_motion)
    return;
  record_.motion.add(
    body.time(), moving.velocity_at(head.centre()), moving.angular_velocity());
}


template <typename Real>
std::vector<InjuryMeasure>
InjuryReport<Real>::measures(const SolidBody<Real> &body) const
{
  std::vector<InjuryMeasure> list;
  add_brain(body, list);
  add_head(body, list);
  const bool is_loaded = body.loads().n_loaded_facets(body.communicator()) > 0;
  if (is_loaded)
    mark_lower_limits(body.time(), list);
  if (has(Tissue::lung, body.mesh()))
    for (const InjuryMeasure &measure : chest_.measures())
      list.push_back(measure);
  apply(own_, list);
  if (!is_loaded)
    limit_to_impact(list);
  return list;
}


template <typename Real>
void InjuryReport<Real>::add_brain(const SolidBody<Real> &body,
                                   std::vector<InjuryMeasure> &list) const
{
  for (const InjuryMeasure &measure :
       brain_measures(record_.samples, record_.sums, body.communicator()))
    list.push_back(measure);
}


template <typename Real>
void InjuryReport<Real>::add_head(const SolidBody<Real> &body,
                                  std::vector<InjuryMeasure> &list) const
{
  const std::string moving = has_skull_
                               ? "the skull, at the centre of brain and skull"
                               : "the mean motion of the brain";
  for (const InjuryMeasure &measure : head_motion_measures(
         record_.motion,
         moving + (body.supports().selecting_entries().empty()
                     ? ""
                     : ", in a body that Supports hold")))
    list.push_back(measure);
}


template <typename Real>
void InjuryReport<Real>::save(const SolidBody<Real> &body,
                              const std::string &folder) const
{
  if (!active_)
    return;
  io::save_part(
    folder, "injury", body.communicator(), [&](io::StateWriter &out) {
      record_.save(out);
      out.put_list(chest_.times());
      out.put_list(chest_.pressures());
      out.put_list(chest_.wall_velocities());
    });
}


template <typename Real>
void InjuryReport<Real>::restore(const SolidBody<Real> &body,
                                 const std::string &folder)
{
  if (!active_)
    return;
  io::restore_parts(folder, "injury", [&](io::StateReader &in) {
    record_.restore(in, body.communicator());
    std::array<std::vector<double>, 3> chest;
    for (std::vector<double> &values : chest)
      in.take_list(values);
    chest_.restore(
      std::move(chest[0]), std::move(chest[1]), std::move(chest[2]));
  });
}


template class InjuryReport<double>;
template class InjuryReport<float>;
} // namespace contrecoup::solid
