// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/io/file/binary_records.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/solid/body/stress_invariants.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/injury/injury_report.h>
#include <contrecoup/solid/motion/mean_motion.h>

#include <filesystem>
#include <sstream>

namespace contrecoup::solid
{
namespace
{
  using dealii::Tensor;

  constexpr std::uint32_t none = -1;

  std::string file_of(const std::string &folder, const unsigned int rank)
  {
    return folder + "/injury." + std::to_string(rank) + ".bin";
  }
} // namespace


template <typename Real>
void InjuryReport<Real>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Injury");
  declare_bool(prm,
               "Active",
               "false",
               "Whether strains and pressures of the brain, motion of the "
               "head and pressure on the chest are recorded for injury.csv.");
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
}


template <typename Real>
void InjuryReport<Real>::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Injury");
  active_ = prm.get_bool("Active");
  averaged_ = prm.get("Pressure") == peak_pressure_names()[0];
  interval_ = read_unsigned(prm, "Every steps");
  chest_.parse_parameters(prm);
}


template <typename Real>
void InjuryReport<Real>::reinit(const SolidBody<Real> &body)
{
  const SolidMesh &mesh = body.mesh();
  brain_ = static_cast<unsigned int>(
    std::find(mesh.tissues.begin(), mesh.tissues.end(), Tissue::brain) -
    mesh.tissues.begin());
  average_.reinit(mesh, body.exchange(), brain_);
  sample_of_element_.assign(mesh.elements.size(), none);
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
  chest_wall_.reinit(
    mesh, chest_.place(), chest_.radius(), body.communicator());
  record_.last_time = body.time();
}


template <typename Real>
void InjuryReport<Real>::record(const SolidBody<Real> &body)
{
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
      record_.samples[i].peak_strain =
        raised_to_principal(record_.samples[i].peak_strain, element.strain);
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
void InjuryReport<Real>::follow_head(const SolidBody<Real> &body)
{
  // Each element of the brain is a point mass at its centre.
  MeanMotion motion;
  const SolidMesh &mesh = body.mesh();
  for (std::size_t i = 0; i < record_.samples.size(); ++i)
  {
    Tensor<1, 3> place, velocity;
    for (const std::uint32_t node : mesh.elements[average_.elements()[i]])
      for (unsigned int d = 0; d < 3; ++d)
      {
        place[d] += (mesh.nodes[node][d] +
                     double(body.nodes().displacement_of(node)[d])) /
                    8.;
        velocity[d] += double(body.nodes().velocity_of(node)[d]) / 8.;
      }
    motion.add(record_.samples[i].volume, place, velocity);
  }
  if (!motion.find(body.communicator()))
    return;
  update_largest_angular_velocity(record_.largest_angular_velocity,
                                  motion.angular_velocity());
  const Tensor<1, 3> &velocity = motion.velocity();
  record_.times.push_back(body.time());
  record_.speeds.push_back({{velocity[0], velocity[1], velocity[2]}});
}


template <typename Real>
std::vector<InjuryMeasure>
InjuryReport<Real>::measures(const SolidBody<Real> &body) const
{
  std::vector<InjuryMeasure> list;
  add_brain(body, list);
  add_head(list);
  const auto &tissues = body.mesh().tissues;
  if (std::find(tissues.begin(), tissues.end(), Tissue::lung) != tissues.end())
    for (const InjuryMeasure &measure : chest_.measures())
      list.push_back(measure);
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
void InjuryReport<Real>::add_head(std::vector<InjuryMeasure> &list) const
{
  if (record_.times.size() < 2)
    return;
  list.push_back(head_motion_measure(
    record_.times, record_.speeds, "the mean motion of the brain"));
  list.push_back(head_rotation_measure(record_.largest_angular_velocity,
                                       "the mean turning of the brain"));
}


template <typename Real>
void InjuryReport<Real>::save(const SolidBody<Real> &body,
                              const std::string &folder) const
{
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(body.communicator());
  io::write_file(file_of(folder, rank), [&](std::ostream &out) {
    record_.save(out);
    io::put_list(out, chest_.times());
    io::put_list(out, chest_.pressures());
    io::put_list(out, chest_.wall_velocities());
  });
}


template <typename Real>
void InjuryReport<Real>::restore(const SolidBody<Real> &body,
                                 const std::string &folder)
{
  reinit(body);
  for (unsigned int rank = 0; std::filesystem::exists(file_of(folder, rank));
       ++rank)
  {
    const std::string file = file_of(folder, rank);
    std::istringstream in(io::read_file(file));
    record_.restore(in, file, rank, body.communicator());
    std::array<std::vector<double>, 3> chest;
    for (std::vector<double> &values : chest)
      io::take_list(in, file, values);
    chest_.restore(
      std::move(chest[0]), std::move(chest[1]), std::move(chest[2]));
  }
}


template class InjuryReport<double>;
template class InjuryReport<float>;
} // namespace contrecoup::solid
