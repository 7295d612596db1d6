// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/region_measures.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Extreme values of a region, and sums over its cells.
  struct Extrema
  {
    double most_negative_pressure = -std::numeric_limits<double>::max();
    double pressure = -std::numeric_limits<double>::max();
    double shear_strain = 0.;
    double speed_squared = 0.;
  };
  struct Sums
  {
    double mass = 0.;
    double void_volume = 0.;
    double kinetic_energy = 0.;
    std::array<double, 3> momentum{};
  };

  void add_cell(const HexSpace &space,
                const CellValues &values,
                const AleState &state,
                const std::size_t cell,
                Extrema &extrema,
                Sums &sums)
  {
    extrema.most_negative_pressure =
      std::max(extrema.most_negative_pressure, -values.pressure);
    extrema.pressure = std::max(extrema.pressure, values.pressure);
    extrema.shear_strain = std::max(extrema.shear_strain, values.shear_strain);
    sums.mass += values.mass;
    sums.void_volume += values.void_fraction * values.volume;
    for (const std::uint32_t node : space.cell(cell))
    {
      const double *v = &state.velocity[node_width * node];
      const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
      extrema.speed_squared = std::max(extrema.speed_squared, square);
      sums.kinetic_energy += 0.0625 * values.mass * square;
      for (unsigned int d = 0; d < 3; ++d)
        sums.momentum[d] += 0.125 * values.mass * v[d];
    }
  }
} // namespace


std::vector<NamedValue> region_measures(const HexSpace &space,
                                        const LagrangeStep &lagrange,
                                        const AleState &state,
                                        const std::vector<Region> &regions)
{
  std::vector<Extrema> extrema(regions.size());
  std::vector<Sums> sums(regions.size());
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
    add_cell(space,
             lagrange.values(state, c),
             state,
             c,
             extrema[space.region(c)],
             sums[space.region(c)]);
  const auto communicator = space.communicator();
  std::vector<NamedValue> result;
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    std::vector<double> largest{extrema[i].most_negative_pressure,
                                extrema[i].pressure,
                                extrema[i].shear_strain,
                                extrema[i].speed_squared};
    dealii::Utilities::MPI::max(largest, communicator, largest);
    std::vector<double> sum{sums[i].mass,
                            sums[i].momentum[0],
                            sums[i].momentum[1],
                            sums[i].momentum[2],
                            sums[i].void_volume,
                            sums[i].kinetic_energy};
    dealii::Utilities::MPI::sum(sum, communicator, sum);
    const std::string name = "_" + regions[i].name;
    result.push_back({"least_pressure" + name, "Pa", -largest[0]});
    result.push_back({"largest_pressure" + name, "Pa", largest[1]});
    result.push_back({"kinetic_energy" + name, "J", sum[5]});
    if (regions[i].solid() == nullptr)
    {
      result.push_back({"largest_speed" + name, "m/s", std::sqrt(largest[3])});
      if (std::holds_alternative<Tait>(regions[i].law))
        result.push_back({"void_volume" + name, "m^3", sum[4]});
      continue;
    }
    result.push_back({"largest_shear_strain" + name, "-", largest[2]});
    for (unsigned int d = 0; d < 3; ++d)
      result.push_back({std::string("velocity_") + "xyz"[d] + name,
                        "m/s",
                        sum[d + 1] / sum[0]});
  }
  return result;
}
} // namespace contrecoup::ale
