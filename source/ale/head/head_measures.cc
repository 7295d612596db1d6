// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/head_measures.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/motion/mean_motion.h>

#include <filesystem>
#include <sstream>

namespace contrecoup::ale
{
namespace
{
  constexpr unsigned int width = AleState::width;

  std::string file_of(const std::string &folder, const unsigned int rank)
  {
    return folder + "/injury." + std::to_string(rank) + ".bin";
  }
} // namespace


void HeadMeasures::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Injury");
  declare_string(prm,
                 "Brain",
                 "brain",
                 "Region whose strains and pressures are recorded for "
                 "injury.csv, if a region has this name.");
  declare_string(prm,
                 "Skull",
                 "skull",
                 "Region whose mean motion is recorded for injury.csv; if "
                 "no region has this name, that of the brain is recorded.");
  declare_selection(prm,
                    "Pressure",
                    "averaged",
                    solid::peak_pressure_names(),
                    "Pressure in the brain: of each cell, or averaged over "
                    "its corners and the brain cells around them. Averaging "
                    "removes checkerboard pressures, and a tenth of waves "
                    "as short as ten cells.");
  declare_integer(prm,
                  "Every steps",
                  "10",
                  1,
                  1000000,
                  "Steps between evaluations; peaks in between are missed.");
}


void HeadMeasures::parse_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Injury");
    brain_name_ = prm.get("Brain");
    skull_name_ = prm.get("Skull");
    averaged_ = prm.get("Pressure") == solid::peak_pressure_names()[0];
    interval_ = read_unsigned(prm, "Every steps");
  }
  const Section section(prm, "Mesh");
  if (prm.get("Kind") == "layered head" || prm.get("Kind") == "file")
    is_mirrored_ = read_symmetry_planes(prm);
}


unsigned int HeadMeasures::find(const std::vector<Region> &regions,
                                const std::string &entry,
                                const std::string &name)
{
  for (unsigned int i = 0; i < regions.size(); ++i)
    if (regions[i].name == name)
    {
      if (regions[i].solid() == nullptr)
        throw InputError("Injury/" + entry + ": region \"" + name +
                         "\" is a fluid");
      return i;
    }
  return none;
}


void HeadMeasures::reinit(const HexSpace &space,
                          const LagrangeStep &lagrange,
                          const AleState &state,
                          const std::vector<Region> &regions)
{
  brain_ = find(regions, "Brain", brain_name_);
  skull_ = find(regions, "Skull", skull_name_);
  cells_.clear();
  record_.samples.clear();
  std::vector<solid::NodalAverage::Corners> corners;
  std::vector<double> volumes;
  for (std::uint32_t c = 0; c < space.n_locally_owned_cells(); ++c)
    if (space.region(c) == brain_)
    {
      cells_.push_back(c);
      solid::BrainSample sample;
      sample.cell = space.cell_number(c);
      sample.volume = lagrange.values(state, c).volume;
      record_.samples.push_back(sample);
      corners.push_back(space.cell(c));
      volumes.push_back(sample.volume);
    }
  solid::NodalAverage::AddRanks add_ranks;
  if (dealii::Utilities::MPI::n_mpi_processes(space.communicator()) > 1)
  {
    FieldExchange exchange;
    exchange.reinit(space.nodes(), 1);
    add_ranks = [exchange](dealii::AlignedVector<double> &values) {
      exchange.compress_add(values);
      exchange.update_ghost_values(values);
    };
  }
  average_.reinit(std::move(corners),
                  std::move(volumes),
                  space.n_nodes(),
                  std::move(add_ranks));
}


void HeadMeasures::follow(const HexSpace &space,
                          const LagrangeStep &lagrange,
                          const AleState &state)
{
  if (!active() || record_.n_steps++ % interval_ != 0)
    return;
  follow_brain(lagrange, state, state.time - record_.last_time);
  record_.last_time = state.time;
  follow_motion(space, state);
}


void HeadMeasures::follow_brain(const LagrangeStep &lagrange,
                                const AleState &state,
                                const double span)
{
  std::vector<double> pressures;
  for (std::size_t i = 0; i < record_.samples.size(); ++i)
  {
    const CellValues values = lagrange.values(state, cells_[i]);
    record_.samples[i].peak_strain =
      std::max(record_.samples[i].peak_strain, values.principal_strain);
    pressures.push_back(values.pressure);
  }
  solid::record_pressures(span,
                          pressures,
                          average_.average(pressures),
                          averaged_,
                          record_.samples,
                          record_.sums);
}


void HeadMeasures::follow_motion(const HexSpace &space, const AleState &state)
{
  // Each cell is a point mass at its centre.
  solid::MeanMotion moving, head;
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
  {
    const unsigned int region = space.region(c);
    if (region != moving_region() && region != brain_)
      continue;
    dealii::Tensor<1, 3> place, velocity;
    for (const std::uint32_t node : space.cell(c))
      for (unsigned int d = 0; d < 3; ++d)
      {
        place[d] += 0.125 * state.position[width * node + d];
        velocity[d] += 0.125 * state.velocity[width * node + d];
      }
    head.add(state.mass[c], place, velocity);
    if (region == moving_region())
      moving.add(state.mass[c], place, velocity);
  }
  head.find(space.communicator(), is_mirrored_);
  moving.find(space.communicator(), is_mirrored_);
  record_.motion.add(
    state.time, moving.velocity_at(head.centre()), moving.angular_velocity());
}


std::vector<solid::InjuryMeasure>
HeadMeasures::measures(const MPI_Comm communicator) const
{
  auto list =
    solid::brain_measures(record_.samples, record_.sums, communicator);
  if (!averaged_)
    for (solid::InjuryMeasure &measure : list)
      if (measure.value.unit == "Pa")
        measure.limits += "; of single cells";
  const std::string moving = skull_ == none ? "the mean motion of the brain"
                             : brain_ == none
                               ? "the mean motion of the skull"
                               : "the skull, at the centre of brain and skull";
  for (const solid::InjuryMeasure &measure : solid::head_motion_measures(
         record_.motion, moving + ", until the end of the run"))
    list.push_back(measure);
  return list;
}


void HeadMeasures::save(const std::string &folder,
                        const MPI_Comm communicator) const
{
  if (!active())
    return;
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(communicator);
  io::write_file(file_of(folder, rank),
                 [&](std::ostream &out) { record_.save(out); });
}


void HeadMeasures::restore(const std::string &folder,
                           const MPI_Comm communicator)
{
  if (!active())
    return;
  unsigned int rank = 0;
  do
  {
    const std::string file = file_of(folder, rank);
    std::istringstream in(io::read_file(file));
    record_.restore(in, file, rank, communicator);
  } while (std::filesystem::exists(file_of(folder, ++rank)));
}
} // namespace contrecoup::ale
