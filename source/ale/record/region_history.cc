// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/record/region_history.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Sums over the cells of a region.
  struct Sums
  {
    double mass = 0.;
    double kinetic_energy = 0.;
    std::array<double, 3> momentum{};
  };

  void add_cell(const HexSpace &space,
                const AleState &state,
                const std::size_t cell,
                Sums &sums)
  {
    sums.mass += state.mass[cell];
    for (const std::uint32_t node : space.cell(cell))
    {
      const double *v = &state.velocity[node_width * node];
      const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
      sums.kinetic_energy += 0.0625 * state.mass[cell] * square;
      for (unsigned int d = 0; d < 3; ++d)
        sums.momentum[d] += 0.125 * state.mass[cell] * v[d];
    }
  }
} // namespace


std::vector<RegionExtremes> region_extremes(const HexSpace &space,
                                            const LagrangeStep &lagrange,
                                            const AleState &state,
                                            const std::vector<Region> &regions,
                                            const bool with_solids)
{
  std::vector<RegionExtremes> extremes(regions.size());
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
  {
    const bool is_solid = regions[space.region(c)].solid() != nullptr;
    if (is_solid && !with_solids)
      continue;
    const CellValues values = lagrange.values(state, c);
    double square = 0.;
    for (const std::uint32_t node : space.cell(c))
    {
      const double *v = &state.velocity[node_width * node];
      square = std::max(square, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    RegionExtremes &found = extremes[space.region(c)];
    const double volume =
      found.void_volume + values.void_fraction * values.volume;
    found.include({values.pressure,
                   values.pressure,
                   values.shear_strain,
                   is_solid ? 0. : std::sqrt(square),
                   volume});
  }
  return extremes;
}


void RegionHistory::record_rezoned(const AleSnapshot &now)
{
  std::vector<RegionExtremes> extremes = now.lagrange.extremes();
  if (!now.forces_are_current)
  {
    // Neither smoothing nor heat changes the pressures of solids.
    const auto found =
      region_extremes(now.space, now.lagrange, now.state, now.regions, false);
    for (std::size_t i = 0; i < found.size(); ++i)
      if (now.regions[i].solid() == nullptr)
        extremes[i] = found[i];
  }
  extremes_.add(std::move(extremes));
}


std::vector<NamedValue> RegionHistory::history(const AleSnapshot &now)
{
  const HexSpace &space = now.space;
  const std::vector<Region> &regions = now.regions;
  if (extremes_.is_empty())
    extremes_.add(region_extremes(space, now.lagrange, now.state, regions));
  const std::vector<RegionExtremes> extremes = extremes_.take();
  std::vector<Sums> sums(regions.size());
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
    add_cell(space, now.state, c, sums[space.region(c)]);
  std::vector<NamedValue> result;
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    std::vector<double> sum{sums[i].mass,
                            sums[i].momentum[0],
                            sums[i].momentum[1],
                            sums[i].momentum[2],
                            sums[i].kinetic_energy};
    dealii::Utilities::MPI::sum(sum, space.communicator(), sum);
    const std::string name = "_" + regions[i].name;
    result.push_back(
      {"least_pressure" + name, "Pa", extremes[i].least_pressure});
    result.push_back(
      {"largest_pressure" + name, "Pa", extremes[i].largest_pressure});
    result.push_back({"kinetic_energy" + name, "J", sum[4]});
    if (regions[i].solid() == nullptr)
    {
      result.push_back({"largest_speed" + name, "m/s", extremes[i].speed});
      if (std::holds_alternative<Tait>(regions[i].law))
        result.push_back(
          {"void_volume" + name, "m^3", extremes[i].void_volume});
      continue;
    }
    result.push_back(
      {"largest_shear_strain" + name, "-", extremes[i].shear_strain});
    for (unsigned int d = 0; d < 3; ++d)
      result.push_back({std::string("velocity_") + "xyz"[d] + name,
                        "m/s",
                        sum[d + 1] / sum[0]});
  }
  return result;
}
} // namespace contrecoup::ale
