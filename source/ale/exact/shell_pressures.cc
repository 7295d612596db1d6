// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/shell_pressures.h>
#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::ale
{
void ShellPressures::declare_parameters(ParameterHandler &prm)
{
  declare_double(
    prm, "Fluid radius", "0.079", 1e-6, 1e6, "m", "Inner shell radius.");
  declare_double(prm,
                 "Fluid density",
                 "1000",
                 1e-6,
                 1e6,
                 "kg/m^3",
                 "Density of the liquid.");
  declare_double(
    prm, "Thickness", "0.007", 1e-9, 1e6, "m", "Thickness of the shell.");
  declare_double(
    prm, "Shell density", "1800", 1e-6, 1e6, "kg/m^3", "Shell density.");
  declare_double(prm,
                 "Young modulus",
                 "6.5e9",
                 1.,
                 1e15,
                 "Pa",
                 "Young's modulus of the shell.");
  declare_double(prm,
                 "Poisson ratio",
                 "0.22",
                 0.,
                 0.49,
                 "-",
                 "Poisson's ratio of the shell.");
  declare_double(
    prm, "Speed", "3", 1e-9, 1e6, "m/s", "Speed before the impact, along -z.");
}


std::unique_ptr<ShellPressures>
ShellPressures::create(const ParameterHandler &prm)
{
  FluidFilledShell shell;
  shell.fluid_radius = read_double(prm, "Fluid radius");
  shell.fluid_density = read_double(prm, "Fluid density");
  shell.thickness = read_double(prm, "Thickness");
  shell.shell_density = read_double(prm, "Shell density");
  shell.young_modulus = read_double(prm, "Young modulus");
  shell.poisson_ratio = read_double(prm, "Poisson ratio");
  shell.speed = read_double(prm, "Speed");
  return std::make_unique<ShellPressures>(shell);
}


void ShellPressures::follow(const HexSpace &space,
                            const LagrangeStep &lagrange,
                            const AleState &state,
                            const std::vector<std::uint32_t> &probes,
                            const double step,
                            Peaks &peaks)
{
  if (places_.empty() && !probes.empty())
  {
    const auto start = space.positions(node_width);
    for (const std::uint32_t cell : probes)
    {
      places_.emplace_back();
      if (cell == HexSpace::no_cell)
        continue;
      const auto moments = hex_moments(corners_of(space.cell(cell), start));
      for (unsigned int d = 0; d < 3; ++d)
        places_.back()[d] = moments.first[d] / moments.volume;
    }
  }
  peaks.resize(probes.size() + 1, {{0., 0.}});
  const double duration = shell_.contact_time();
  const double middle = state.time - 0.5 * step;
  if (middle > duration)
    return;
  const double weight =
    2. * step / duration * std::sin(dealii::numbers::PI * middle / duration);
  peaks.back()[0] += weight * lagrange.contact().force;
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    if (probes[i] == HexSpace::no_cell)
      continue;
    const double pressure = lagrange.values(state, probes[i]).pressure;
    peaks[i][pressure > 0. ? 0 : 1] += weight * std::abs(pressure);
  }
}


std::vector<NamedValue>
ShellPressures::errors(const Peaks &peaks,
                       const double mass,
                       const MPI_Comm communicator) const
{
  // Other ranks hold a probe's restored amplitude, but no position.
  const auto largest = [&](const double value) {
    return dealii::Utilities::MPI::max(value, communicator);
  };
  std::vector<double> amplitudes, distances, cosines;
  for (std::size_t i = 0; i + 1 < peaks.size(); ++i)
  {
    dealii::Point<3> place;
    for (unsigned int d = 0; d < 3; ++d)
      place[d] = dealii::Utilities::MPI::sum(
        i < places_.size() ? places_[i][d] : 0., communicator);
    amplitudes.push_back(largest(peaks[i][0]) - largest(peaks[i][1]));
    distances.push_back(place.norm());
    cosines.push_back(-place[2] / place.norm());
  }
  const double acceleration =
    largest(peaks.back()[0]) / mass / shell_.peak_acceleration();
  std::vector<NamedValue> result{{"acceleration", "-", acceleration - 1.}};
  for (std::size_t i = 0; i + 1 < amplitudes.size(); i += 2)
  {
    // Unknown if the run made no step since a restart.
    if (distances[i] == 0.)
      continue;
    double exact = 0., rigid = 0.;
    for (const std::size_t k : {i, i + 1})
    {
      const double sign = k == i ? 0.5 : -0.5;
      exact += sign * shell_.pressure(distances[k], cosines[k]);
      rigid += sign * shell_.fluid_density * shell_.peak_acceleration() *
               distances[k] * cosines[k];
    }
    const double found = 0.5 * (amplitudes[i] - amplitudes[i + 1]);
    const std::string number = std::to_string(i / 2 + 1);
    result.push_back({"pressure_" + number, "-", found / exact - 1.});
    result.push_back({"rigid_pressure_" + number, "-", found / rigid - 1.});
    if (acceleration > 0.)
      result.push_back({"hydrostatic_pressure_" + number,
                        "-",
                        found / (rigid * acceleration) - 1.});
  }
  return result;
}
} // namespace contrecoup::ale
