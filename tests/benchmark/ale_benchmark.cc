// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// Throughput of steps on moving meshes, on cubes of 64^3 elements, next to a
// control loop: the forces of the same elements over arrays, one element after
// the other, as a plain code would find them. Started without arguments it runs
// itself under mpirun, on one rank and on two.

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/base/system/processor_time.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include "on_ranks.h"

#include <chrono>
#include <cstdio>

namespace
{
using namespace contrecoup;
using namespace contrecoup::ale;

constexpr unsigned int n = 64, width = node_width;

double wall_time()
{
  return std::chrono::duration<double>(
           std::chrono::steady_clock::now().time_since_epoch())
    .count();
}

Region water()
{
  Region region;
  region.law = Tait(1000., 2.2e9);
  region.viscosity.linear = 0.06;
  return region;
}

Region brain()
{
  Region region;
  region.law = solid_material(find_tissue_properties("paper", Tissue::brain));
  region.viscosity.linear = 0.06;
  return region;
}

/// A cube of one region in slow motion.
struct Cube
{
  Cube(const Region &region, const MPI_Comm communicator)
  {
    dealii::Triangulation<3> mesh;
    dealii::GridGenerator::subdivided_hyper_cube(mesh, n);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(0);
    space.reinit(mesh, communicator);
    lagrange.reinit(
      space, {region}, {}, [](double) { return dealii::Tensor<1, 3>(); });
    state.position = space.positions(width);
    state.velocity.resize(state.position.size());
    state.mass.resize(space.n_cells());
    state.mass.fill(1000. / n / n / n);
    state.energy.resize(space.n_cells());
    state.products.resize(space.n_cells());
    if (region.is_viscoelastic())
      state.relaxed.resize(6 * space.n_cells());
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      for (unsigned int d = 0; d < 3; ++d)
        state.velocity[width * node + d] =
          std::sin(7. * state.position[width * node + d] +
                   state.position[width * node + (d + 1) % 3]);
    lagrange.start(state);
  }

  HexSpace space;
  LagrangeStep lagrange;
  AleState state;
};

/// Element updates per second, the best of three times ten steps.
double measure(const Region &region,
               const MPI_Comm communicator,
               double (*const now)())
{
  Cube cube(region, communicator);
  const auto step = [&]() {
    cube.lagrange.advance(cube.state, 1., 0.3, 10, true);
  };
  step();
  double best = 0.;
  for (unsigned int repetition = 0; repetition < 3; ++repetition)
  {
    const double start = now();
    for (unsigned int i = 0; i < 10; ++i)
      step();
    best = std::max(best, 10. * n * n * n / (now() - start));
  }
  return best;
}

/// The same for forces alone, twice an update as in a step, one element after
/// the other.
double measure_control()
{
  const Cube cube(water(), MPI_COMM_SELF);
  const Tait law(1000., 2.2e9);
  const FluidViscosity viscosity = water().viscosity;
  std::vector<double> force(3 * cube.space.n_nodes());
  double best = 0.;
  for (unsigned int repetition = 0; repetition < 6; ++repetition)
  {
    const double start = processor_seconds();
    for (unsigned int stage = 0; stage < 2; ++stage)
      for (std::size_t c = 0; c < cube.space.n_cells(); ++c)
      {
        const HexSpace::Cell &nodes = cube.space.cell(c);
        HexVectors<double> x, v;
        for (unsigned int i = 0; i < 8; ++i)
          for (unsigned int d = 0; d < 3; ++d)
          {
            x[i][d] = cube.state.position[width * nodes[i] + d];
            v[i][d] = cube.state.velocity[width * nodes[i] + d];
          }
        FluidElement<double> element{};
        element.mass = cube.state.mass[c];
        const auto f = fluid_forces(law, viscosity, x, v, element);
        for (unsigned int i = 0; i < 8; ++i)
          for (unsigned int d = 0; d < 3; ++d)
            force[3 * nodes[i] + d] -= f[i][d];
      }
    best = std::max(best, double(n) * n * n / (processor_seconds() - start));
  }
  // The forces are used, so that they are found.
  return force[0] == 0.5 ? 0. : best;
}

void print(const char *name, const double value, const char *unit)
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::printf("%s,%.6g,%s\n", name, value, unit);
}

void measure_one_rank()
{
  const char *const unit = "element-updates/(s core)";
  const double fluid = measure(water(), MPI_COMM_SELF, processor_seconds);
  print("ale_lagrange", fluid, unit);
  print("ale_lagrange_brain",
        measure(brain(), MPI_COMM_SELF, processor_seconds),
        unit);
  print("ale_over_control", fluid / measure_control(), "speed ratio");
}

void measure_two_ranks()
{
  double alone = 0.;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    alone = measure(brain(), MPI_COMM_SELF, wall_time);
  MPI_Barrier(MPI_COMM_WORLD);
  const double both = measure(brain(), MPI_COMM_WORLD, wall_time);
  print("ale_two_ranks", both / alone, "speed ratio");
}
} // namespace


int main(int argc, char **argv)
{
  return contrecoup::measure_on_ranks(
    argc, argv, measure_one_rank, measure_two_ranks);
}
