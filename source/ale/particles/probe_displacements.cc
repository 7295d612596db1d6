// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_probes.h>
#include <contrecoup/ale/particles/probe_displacements.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  namespace column = mpm::column;

  const std::vector<std::string> directions{"x", "y", "z"};
} // namespace


void ProbeDisplacements::declare_parameters(ParameterHandler &prm)
{
  declare_selection(
    prm, "Direction", "y", directions, "Direction of the displacements.");
  declare_list(prm,
               "Known",
               "0",
               1,
               1000,
               -1e6,
               1e6,
               "m",
               "Known final displacement of the material point at each of "
               "Probes/Points.");
}


std::unique_ptr<ProbeDisplacements>
ProbeDisplacements::create(const ParameterHandler &prm)
{
  auto result = std::make_unique<ProbeDisplacements>();
  result->direction_ = static_cast<unsigned int>(
    std::find(directions.begin(), directions.end(), prm.get("Direction")) -
    directions.begin());
  result->known_ = read_list(prm, "Known");
  return result;
}


void ProbeDisplacements::reinit(const std::vector<dealii::Point<3>> &points)
{
  if (points.size() != known_.size())
    throw InputError("Reference/Probe displacements/Known has " +
                     std::to_string(known_.size()) +
                     " numbers, and Probes/Points has " +
                     std::to_string(points.size()) + " places");
  points_ = points;
}


std::vector<NamedValue>
ProbeDisplacements::values(const mpm::Particles &particles,
                           const MPI_Comm communicator) const
{
  std::vector<double> found(points_.size(), 0.);
  for_each_probe(
    particles,
    [&](unsigned int, const auto &block, const auto p, const auto probe) {
      double way = block[column::position + direction_][p] -
                   block[column::initial_position + direction_][p];
      for (unsigned int d = 0; d < 3; ++d)
        way += block[column::gradient + 3 * direction_ + d][p] *
               (points_[probe][d] - block[column::initial_position + d][p]);
      found[probe] = way;
    });
  dealii::Utilities::MPI::sum(found, communicator, found);
  std::vector<NamedValue> result;
  for (std::size_t i = 0; i < found.size(); ++i)
    result.push_back({"displacement_" + std::to_string(i + 1), "m", found[i]});
  return result;
}


std::vector<NamedValue>
ProbeDisplacements::errors(const mpm::Particles &particles,
                           const MPI_Comm communicator) const
{
  auto result = values(particles, communicator);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i].value = std::abs(result[i].value - known_[i]);
  return result;
}
} // namespace contrecoup::ale
