// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/sphere_peaks.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::ale
{
void add_peaks(io::StateReader &in, Peaks &peaks)
{
  Peaks saved;
  in.take_list(saved);
  if (peaks.size() < saved.size())
    peaks.resize(saved.size(), {{0., 0.}});
  for (std::size_t i = 0; i < saved.size(); ++i)
    for (unsigned int k = 0; k < 2; ++k)
      peaks[i][k] = std::max(peaks[i][k], saved[i][k]);
}


void SpherePeaks::declare_parameters(ParameterHandler &prm)
{
  declare_double(
    prm, "Radius", "0.09", 1e-6, 1e6, "m", "Radius of the sphere.");
  declare_double(
    prm, "Density", "1000", 1e-6, 1e6, "kg/m^3", "Density of the liquid.");
  declare_double(
    prm, "Sound speed", "1483", 1e-3, 1e6, "m/s", "Sound speed of liquid.");
  declare_double(prm,
                 "Deceleration",
                 "1000",
                 0.,
                 1e9,
                 "m/s^2",
                 "Peak of the half-sine deceleration of the sphere.");
  declare_double(
    prm, "Duration", "1e-3", 1e-9, 1e3, "s", "Duration of the deceleration.");
}


std::unique_ptr<SpherePeaks> SpherePeaks::create(const ParameterHandler &prm)
{
  RigidSphere sphere;
  sphere.radius = read_double(prm, "Radius");
  sphere.density = read_double(prm, "Density");
  sphere.sound_speed = read_double(prm, "Sound speed");
  sphere.deceleration = read_double(prm, "Deceleration");
  sphere.duration = read_double(prm, "Duration");
  return std::make_unique<SpherePeaks>(sphere);
}


void SpherePeaks::follow(const HexSpace &space,
                         const LagrangeStep &lagrange,
                         const AleState &state,
                         const std::vector<std::uint32_t> &probes,
                         Peaks &peaks) const
{
  peaks.resize(probes.size(), {{0., 0.}});
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    if (probes[i] == HexSpace::no_cell)
      continue;
    HexVectors<double> corners;
    for (unsigned int k = 0; k < 8; ++k)
      for (unsigned int d = 0; d < 3; ++d)
        corners[k][d] =
          state.position[node_width * space.cell(probes[i])[k] + d];
    const auto moments = hex_moments(corners);
    dealii::Point<3> centre;
    for (unsigned int d = 0; d < 3; ++d)
      centre[d] = moments.first[d] / moments.volume;
    take(
      centre, lagrange.values(state, probes[i]).pressure, state.time, peaks[i]);
  }
}


void SpherePeaks::take(const dealii::Point<3> &place,
                       const double pressure,
                       const double time,
                       std::array<double, 2> &peak) const
{
  const double distance = place.norm();
  peak[0] = std::max(peak[0], pressure);
  peak[1] =
    std::max(peak[1], solution_.pressure(distance, place[1] / distance, time));
}


std::vector<NamedValue> SpherePeaks::errors(const Peaks &peaks,
                                            const MPI_Comm communicator)
{
  // Relative to the largest peak: where pressure only falls, peaks vanish.
  double largest = 0., difference = 0.;
  for (const auto &peak : peaks)
  {
    largest = std::max(largest, peak[1]);
    difference = std::max(difference, std::abs(peak[0] - peak[1]));
  }
  return {{"peak",
           "-",
           dealii::Utilities::MPI::max(difference, communicator) /
             dealii::Utilities::MPI::max(largest, communicator)}};
}
} // namespace contrecoup::ale
