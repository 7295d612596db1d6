// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/reference.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/numerics/hex8_moments.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::ale
{
namespace
{
  constexpr unsigned int width = AleState::width;

  RiemannState read_state(ParameterHandler &prm, const std::string &name)
  {
    const auto values = read_list(prm, name);
    return {values[0], values[1], values[2]};
  }

  void declare_shock_tube(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Interface",
                   "0.5",
                   -1e6,
                   1e6,
                   "m",
                   "x where the gases of the shock tube meet at the start.");
    for (const char *const name : {"Left", "Right"})
      declare_list(
        prm,
        name,
        "1, 0, 1",
        3,
        3,
        -1e12,
        1e12,
        "-",
        "Density [kg/m^3], velocity [m/s] and pressure [Pa] of a gas "
        "of the shock tube.");
    declare_double(prm,
                   "Gamma",
                   "1.4",
                   1.0001,
                   100.,
                   "-",
                   "Ratio of specific heats of the gases.");
  }

  void declare_rigid_sphere(ParameterHandler &prm)
  {
    declare_double(
      prm, "Radius", "0.09", 1e-6, 1e6, "m", "Of the rigid sphere.");
    declare_double(prm,
                   "Density",
                   "1000",
                   1e-6,
                   1e6,
                   "kg/m^3",
                   "Of the liquid in the rigid sphere.");
    declare_double(prm,
                   "Sound speed",
                   "1483",
                   1e-3,
                   1e6,
                   "m/s",
                   "In the liquid in the rigid sphere.");
    declare_double(prm,
                   "Deceleration",
                   "1000",
                   0.,
                   1e9,
                   "m/s^2",
                   "Largest of the rigid sphere, half a sine.");
    declare_double(prm,
                   "Duration",
                   "1e-3",
                   1e-9,
                   1e3,
                   "s",
                   "Of the deceleration of the rigid sphere.");
  }

  HexVectors<double> corners_of(const HexSpace &space,
                                const AleState &state,
                                const std::size_t cell)
  {
    HexVectors<double> corners;
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        corners[i][d] = state.position[width * space.cell(cell)[i] + d];
    return corners;
  }
} // namespace


void Reference::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Reference");
  declare_selection(prm,
                    "Kind",
                    "none",
                    {"none", "shock tube", "rigid sphere"},
                    "Exact solution that the run is compared with: of two "
                    "gases along x, or of a liquid in a sphere that is "
                    "decelerated along y, at the probes.");
  declare_shock_tube(prm);
  declare_rigid_sphere(prm);
}


void Reference::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Reference");
  kind_ = prm.get("Kind");
  interface_ = read_double(prm, "Interface");
  left_ = read_state(prm, "Left");
  right_ = read_state(prm, "Right");
  gamma_ = read_double(prm, "Gamma");
  sphere_.radius = read_double(prm, "Radius");
  sphere_.density = read_double(prm, "Density");
  sphere_.sound_speed = read_double(prm, "Sound speed");
  sphere_.deceleration = read_double(prm, "Deceleration");
  sphere_.duration = read_double(prm, "Duration");
  if (kind_ == "rigid sphere")
    solution_ = std::make_unique<RigidSphereSolution>(sphere_);
}


void Reference::follow(const HexSpace &space,
                       const LagrangeStep &lagrange,
                       const AleState &state,
                       const std::vector<std::uint32_t> &probes)
{
  if (!solution_)
    return;
  peaks_.resize(probes.size(), {{0., 0.}});
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    if (probes[i] == HexSpace::no_cell)
      continue;
    const auto moments = hex_moments(corners_of(space, state, probes[i]));
    dealii::Point<3> centre;
    for (unsigned int d = 0; d < 3; ++d)
      centre[d] = moments.first[d] / moments.volume;
    const double distance = centre.norm();
    peaks_[i][0] =
      std::max(peaks_[i][0], lagrange.values(state, probes[i]).pressure);
    peaks_[i][1] =
      std::max(peaks_[i][1],
               solution_->pressure(distance, centre[1] / distance, state.time));
  }
}


std::vector<NamedValue>
Reference::shock_tube_errors(const HexSpace &space,
                             const LagrangeStep &lagrange,
                             const AleState &state) const
{
  const ExactRiemann exact(left_, right_, GasMaterial(IdealGas(gamma_)));
  // Density, pressure, volume.
  std::vector<double> sums(3, 0.);
  constexpr unsigned int n_points = 20;
  for (std::size_t c = 0; c < space.n_own_cells(); ++c)
  {
    const auto element = lagrange.values(state, c);
    const auto x = corners_of(space, state, c);
    double density = 0., pressure = 0.;
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double part = (i + 0.5) / n_points;
      const double place = (1. - part) * x[0][0] + part * x[1][0];
      const auto value = exact.value((place - interface_) / state.time);
      density += value.density / n_points;
      pressure += value.pressure / n_points;
    }
    sums[0] += std::abs(element.mass - density * element.volume);
    sums[1] += std::abs(element.pressure - pressure) * element.volume;
    sums[2] += element.volume;
  }
  dealii::Utilities::MPI::sum(sums, space.communicator(), sums);
  return {{"density_L1", "kg/m^3", sums[0] / sums[2]},
          {"pressure_L1", "Pa", sums[1] / sums[2]}};
}


std::vector<NamedValue> Reference::errors(const HexSpace &space,
                                          const LagrangeStep &lagrange,
                                          const AleState &state) const
{
  if (kind_ == "shock tube" && state.time > 0.)
    return shock_tube_errors(space, lagrange, state);
  if (kind_ != "rigid sphere" || peaks_.empty())
    return {};
  // Where the pressure only falls, its peak is small.
  double largest = 0., difference = 0.;
  for (const auto &peak : peaks_)
  {
    largest = std::max(largest, peak[1]);
    difference = std::max(difference, std::abs(peak[0] - peak[1]));
  }
  const auto communicator = space.communicator();
  return {{"peak",
           "-",
           dealii::Utilities::MPI::max(difference, communicator) /
             dealii::Utilities::MPI::max(largest, communicator)}};
}
} // namespace contrecoup::ale
