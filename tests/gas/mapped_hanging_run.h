// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include "gas_run.h"
#include "mapped_run.h"

#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

namespace contrecoup::gas
{
/// The same with finer leaves in a part, some of them by two levels.
template <int dim>
std::vector<Lines> with_hanging_faces()
{
  if constexpr (dim == 2)
    return {mesh(2, "hyper_ball", "0,0:1:false", 1) + finer("0,-1", "1,1", 2),
            mesh(2, "hyper_shell", "0,0:1:2:7:false", 1) +
              finer("-2,-2", "0.1,2", 2)};
  else
    return {mesh(3, "hyper_ball", "0,0,0:1:false", 0) +
              finer("-0.3,-0.3,0", "1,1,1", 2),
            mesh(3, "hyper_shell", "0,0,0:1:2:6:false", 0) +
              finer("-1.6,-2,-2", "1.6,2,2", 1),
            distorted_cube(0) + finer("-0.2,-0.2,-0.9", "0.9,0.9,0.9", 1)};
}

/// Vertices of a hexahedron in Gmsh's order after one of its 24 rotations.
inline std::array<unsigned int, 8> turned(std::array<unsigned int, 8> vertices,
                                          const unsigned int turn)
{
  const std::array<unsigned int, 8> about_z = {{1, 2, 3, 0, 5, 6, 7, 4}};
  const std::array<unsigned int, 8> about_x = {{4, 5, 1, 0, 7, 6, 2, 3}};
  const auto apply = [&](const std::array<unsigned int, 8> &order) {
    const auto before = vertices;
    for (unsigned int v = 0; v < 8; ++v)
      vertices[v] = before[order[v]];
  };
  for (unsigned int i = 0; i < turn % 4; ++i)
    apply(about_z);
  // A direction for the axis that was z.
  for (unsigned int i = 0; i < turn / 4 % 4; ++i)
    apply(about_x);
  if (turn / 16 % 2 == 1)
  {
    apply(about_z);
    apply(about_x);
  }
  return vertices;
}

/// Gas of equal velocity and pressure whose density varies.
template <int dim>
StateFunction<dim> density_wave(const double time)
{
  return [time](const dealii::Point<dim> &p) {
    GasState<dim> state;
    state.density = 1.4;
    for (unsigned int d = 0; d < dim; ++d)
    {
      state.velocity[d] = 0.4 - 0.3 * d;
      state.density +=
        0.2 * std::sin(1.5 * (p[d] - state.velocity[d] * time) + double(d));
    }
    state.pressure = 1.;
    return state;
  };
}

/// Runs the same steps, of a wave that passes hanging faces.
template <int dim>
std::unique_ptr<GasRun<dim>> run_wave(const Lines &lines,
                                      const unsigned int n_steps,
                                      const MPI_Comm communicator)
{
  auto run = std::make_unique<GasRun<dim>>(lines, communicator);
  run->adaptation->refine_fine_box();
  run->set_state(density_wave<dim>(0.));
  run->steps(n_steps);
  return run;
}

/// The distorted cube with the vertices of its cells in another order: all are
/// turned, in all ways in turn.
inline Lines turned_cube(const unsigned int refinement,
                         const unsigned int first_turn)
{
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const std::string name = ::testing::TempDir() + "turned_cube_" +
                           std::to_string(first_turn) + "_" +
                           std::to_string(rank) + ".msh";
  std::ifstream in(CONTRECOUP_MESHES "/distorted_cube.msh");
  std::ofstream out(name);
  unsigned int cell = 0;
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    std::vector<unsigned int> entries(
      std::istream_iterator<unsigned int>(words), {});
    if (entries.size() == 13)
    {
      std::array<unsigned int, 8> vertices;
      std::copy_n(entries.end() - 8, 8, vertices.begin());
      vertices = turned(vertices, first_turn + 5 * cell++);
      std::copy_n(vertices.begin(), 8, entries.end() - 8);
      line.clear();
      for (const unsigned int entry : entries)
        line += std::to_string(entry) + ' ';
    }
    out << line << '\n';
  }
  Lines lines = distorted_cube(refinement);
  lines[2] = "Domain/Mesh file=" + name;
  return lines;
}

/// How cells are numbered changes nothing, within roundoff.
inline void expect_the_same_when_turned(const Lines &scheme)
{
  const Lines lines = finer("-0.25,-0.15,-0.9", "0.95,0.95,0.9", 1) + scheme;
  const auto as_given =
    run_wave<3>(distorted_cube(0) + lines, 5, MPI_COMM_WORLD)->totals();
  for (const unsigned int first_turn : {1U, 7U, 10U, 20U})
  {
    const auto turned =
      run_wave<3>(turned_cube(0, first_turn) + lines, 5, MPI_COMM_WORLD)
        ->totals();
    for (const auto &[name, value] : as_given)
      EXPECT_NEAR(turned.at(name), value, 1e-12) << name << ' ' << first_turn;
  }
}

/// Largest difference between the values of a leaf on one rank and on all.
template <int dim>
double difference_between_ranks(const Lines &lines, const unsigned int n_steps)
{
  const auto alone = run_wave<dim>(lines, n_steps, MPI_COMM_SELF)->leaves();
  const auto together = run_wave<dim>(lines, n_steps, MPI_COMM_WORLD)->leaves();
  EXPECT_GT(together.size(), 0U);
  double result = 0.;
  for (const auto &[name, values] : together)
    for (unsigned int i = 0; i < values.size(); ++i)
      result = std::max(result, std::abs(values[i] - alone.at(name)[i]));
  return result;
}
} // namespace contrecoup::gas
