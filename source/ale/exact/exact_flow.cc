// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::ale
{
namespace
{
  /// Volume-weighted sums over the points of a cell.
  struct CellSums
  {
    double volume = 0., density = 0., pressure = 0., velocity_error = 0.;
  };

  CellSums sum_up(const ExactFlow &flow,
                  const HexVectors<double> &corners,
                  const HexVectors<double> &velocities,
                  const double time)
  {
    const auto x = to_modes(corners), v = to_modes(velocities);
    const auto n = flow.samples;
    const auto place = [](const unsigned int i, const unsigned int n_points) {
      return (2. * i + 1.) / n_points - 1.;
    };
    CellSums sums;
    for (unsigned int k = 0; k < n[2]; ++k)
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int i = 0; i < n[0]; ++i)
        {
          const Vector3<double> p{
            {place(i, n[0]), place(j, n[1]), place(k, n[2])}};
          const double weight = jacobian(x, p);
          const auto position = hex_position(x, p);
          const auto velocity = hex_position(v, p);
          const FlowState exact =
            flow.value({position[0], position[1], position[2]}, time);
          dealii::Tensor<1, 3> difference = exact.velocity;
          for (unsigned int d = 0; d < 3; ++d)
            difference[d] -= velocity[d];
          sums.volume += weight;
          sums.density += weight * exact.density;
          sums.pressure += weight * exact.pressure;
          sums.velocity_error += weight * difference.norm();
        }
    return sums;
  }
} // namespace


FlowState radial_state(const RadialState &state,
                       const dealii::Tensor<1, 3> &way)
{
  const double radius = way.norm();
  FlowState result;
  result.density = state.density;
  result.pressure = state.pressure;
  if (radius > 0.)
    result.velocity = state.velocity / radius * way;
  return result;
}


std::vector<NamedValue> flow_errors(const ExactFlow &flow,
                                    const HexSpace &space,
                                    const LagrangeStep &lagrange,
                                    const AleState &state,
                                    const double radius)
{
  // Errors of density, velocity and pressure; volume.
  std::vector<double> sums(4, 0.);
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
  {
    const auto x = corners_of(space.cell(c), state.position);
    const auto centre = hex_position(to_modes(x), {});
    if (dot(centre, centre) > radius * radius)
      continue;
    const auto element = lagrange.values(state, c);
    const CellSums exact =
      sum_up(flow, x, corners_of(space.cell(c), state.velocity), state.time);
    const double fraction = element.volume / exact.volume;
    sums[0] += std::abs(element.mass - fraction * exact.density);
    sums[1] += fraction * exact.velocity_error;
    sums[2] +=
      std::abs(element.pressure * element.volume - fraction * exact.pressure);
    sums[3] += element.volume;
  }
  dealii::Utilities::MPI::sum(sums, space.communicator(), sums);
  return {{"density_L1", "kg/m^3", sums[0] / sums[3]},
          {"velocity_L1", "m/s", sums[1] / sums[3]},
          {"pressure_L1", "Pa", sums[2] / sums[3]}};
}
} // namespace contrecoup::ale
