// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// Throughput of the material point method, on elastic blocks of 32^3 cells with
// eight particles each, next to a control loop: the same step over arrays of
// particles and nodes, one particle after the other, as a plain code would do
// it. Started without arguments it runs itself under mpirun, on one rank and on
// two.

#include <contrecoup/base/system/processor_time.h>
#include <contrecoup/mpm/particle_step.h>
#include <contrecoup/numerics/element/spline_weights.h>

#include <deal.II/base/mpi.h>

#include "on_ranks.h"

#include <chrono>
#include <cstdio>

namespace
{
using namespace contrecoup;
using namespace contrecoup::mpm;

constexpr int n = 32, margin = 4, per_edge = 2;
constexpr double n_particles = double(n) * n * n * 8;
constexpr double density = 1000., young = 1e7, poisson = 0.3;

double wall_time()
{
  return std::chrono::duration<double>(
           std::chrono::steady_clock::now().time_since_epoch())
    .count();
}

ParticleMaterial elastic()
{
  SolidMaterial solid;
  solid.density = density;
  solid.bulk_modulus = young / (3. * (1. - 2. * poisson));
  solid.instantaneous_shear = young / (2. * (1. + poisson));
  ParticleMaterial material;
  material.name = "solid";
  material.law = solid;
  return material;
}

ParticleMaterial water()
{
  ParticleMaterial material;
  material.name = "water";
  material.law = Tait(density, 2.2e9);
  material.is_smoothed = true;
  return material;
}

/// Place of a particle of the block along one direction, in cells.
double place(const int i)
{
  return margin + (i + 0.5) / per_edge;
}

/// Slow motion that lets particles pass from tile to tile.
double velocity(const std::array<double, 3> &x, const unsigned int d)
{
  return 1. + std::sin(0.2 * x[d] + 0.1 * x[(d + 1) % 3]);
}

/// A block in the middle of a grid of cells of 1 m.
struct Block
{
  Block(const TransferScheme &scheme,
        const ParticleMaterial &material,
        const MPI_Comm communicator)
    : step(scheme, {material})
    , particles(1)
  {
    GridBox box;
    box.n_cells.fill(n + 2 * margin);
    grid.reinit(box, communicator, [](const dealii::Point<3> &corner) {
      for (unsigned int d = 0; d < 3; ++d)
        if (corner[d] < margin || corner[d] >= margin + n)
          return 0u;
      return 1000u;
    });
    for (const auto tile : grid.own_tiles())
      fill(tile, material.density());
    particles.sort(grid);
    step.start(grid, particles);
    size = 0.3 * step.signal_time(grid, particles);
  }

  void fill(const TileGrid::TileId tile, const double mass_density)
  {
    const double volume = 1. / (per_edge * per_edge * per_edge);
    const auto origin = grid.origin(tile);
    constexpr int edge = TileGrid::tile_edge;
    for (const int cell : origin)
      if (cell < margin || cell >= margin + n)
        return;
    ParticleBlock &block = particles.block(tile, 0);
    for (int k = 0; k < per_edge * edge; ++k)
      for (int j = 0; j < per_edge * edge; ++j)
        for (int i = 0; i < per_edge * edge; ++i)
        {
          std::array<double, 3> x;
          const int at[] = {i, j, k};
          for (unsigned int d = 0; d < 3; ++d)
            x[d] = place(per_edge * (origin[d] - margin) + at[d]);
          const std::size_t p = block.append();
          for (unsigned int d = 0; d < 3; ++d)
          {
            block[column::position + d][p] = x[d];
            block[column::velocity + d][p] = velocity(x, d);
          }
          block[column::volume][p] = volume;
          block[column::mass][p] = volume * mass_density;
        }
  }

  void advance()
  {
    step.advance(
      grid, particles, size, 0, [](unsigned int, ParticleBlock &) {});
  }

  TileGrid grid;
  ParticleStep step;
  Particles particles;
  double size;
};

/// Particle-steps per second, the best of three times five steps.
double measure(const unsigned int degree,
               const ParticleMaterial &material,
               const MPI_Comm communicator,
               double (*const now)())
{
  TransferScheme scheme;
  scheme.degree = degree;
  Block block(scheme, material, communicator);
  block.advance();
  double best = 0.;
  for (unsigned int repetition = 0; repetition < 3; ++repetition)
  {
    const double start = now();
    for (unsigned int i = 0; i < 5; ++i)
      block.advance();
    best = std::max(best, 5. * n_particles / (now() - start));
  }
  return best;
}

/// The same step (MUSL, FLIP, small strains) in plain loops.
class Control
{
public:
  Control()
    : nodes_(n_nodes)
  {
    for (int k = 0; k < per_edge * n; ++k)
      for (int j = 0; j < per_edge * n; ++j)
        for (int i = 0; i < per_edge * n; ++i)
        {
          Particle p{};
          p.x = {{place(i), place(j), place(k)}};
          for (unsigned int d = 0; d < 3; ++d)
            p.v[d] = velocity(p.x, d);
          particles_.push_back(p);
        }
  }

  void advance(const double step)
  {
    std::fill(nodes_.begin(), nodes_.end(), Node{});
    for (const Particle &p : particles_)
      for_nodes(p, [&](Node &node, const double w, const double *slope) {
        add_momentum(p, w, node);
        for (unsigned int d = 0; d < 3; ++d)
          for (unsigned int e = 0; e < 3; ++e)
            node.f[d] -= volume * p.stress[d][e] * slope[e];
      });
    for (Node &node : nodes_)
      for (unsigned int d = 0; d < 3; ++d)
      {
        node.a[d] = node.m > 0. ? node.f[d] / node.m : 0.;
        node.v[d] = node.m > 0. ? node.q[d] / node.m + step * node.a[d] : 0.;
      }
    for (Particle &p : particles_)
      for_nodes(p, [&](const Node &node, const double w, const double *) {
        for (unsigned int d = 0; d < 3; ++d)
        {
          p.change[d] += w * step * node.a[d];
          p.way[d] += w * step * node.v[d];
        }
      });
    for (Node &node : nodes_)
      node.m = node.q[0] = node.q[1] = node.q[2] = 0.;
    for (Particle &p : particles_)
    {
      for (unsigned int d = 0; d < 3; ++d)
        p.v[d] += p.change[d];
      for_nodes(p, [&](Node &node, const double w, const double *) {
        add_momentum(p, w, node);
      });
    }
    for (Particle &p : particles_)
      strain(p, step);
  }

  /// So that the results are used.
  double position() const
  {
    return particles_[0].x[0];
  }

private:
  static constexpr int edge = n + 2 * margin + 1;
  static constexpr std::size_t n_nodes = std::size_t(edge) * edge * edge;
  static constexpr double volume = 0.125;

  struct Particle
  {
    std::array<double, 3> x, v, change, way;
    double stress[3][3];
  };
  struct Node
  {
    double m, q[3], f[3], a[3], v[3];
  };

  static void add_momentum(const Particle &p, const double w, Node &node)
  {
    node.m += w * volume * density;
    for (unsigned int d = 0; d < 3; ++d)
      node.q[d] += w * volume * density * p.v[d];
  }

  template <typename Work>
  void for_nodes(const Particle &p, const Work &work)
  {
    const std::array<SplineWeights, 3> s{{spline_weights<3>(p.x[0]),
                                          spline_weights<3>(p.x[1]),
                                          spline_weights<3>(p.x[2])}};
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
        {
          const double x = s[0].value[i], y = s[1].value[j], z = s[2].value[k];
          const double slope[] = {s[0].slope[i] * y * z,
                                  x * s[1].slope[j] * z,
                                  x * y * s[2].slope[k]};
          work(nodes_[s[0].first + i +
                      edge * (s[1].first + j + edge * (s[2].first + k))],
               x * y * z,
               slope);
        }
  }

  void strain(Particle &p, const double step)
  {
    double rate[3][3] = {};
    for_nodes(p, [&](const Node &node, double, const double *slope) {
      for (unsigned int d = 0; d < 3 && node.m > 0.; ++d)
        for (unsigned int e = 0; e < 3; ++e)
          rate[d][e] += node.q[d] / node.m * slope[e];
    });
    constexpr double shear = young / (2. * (1. + poisson)),
                     lame =
                       young * poisson / ((1. + poisson) * (1. - 2. * poisson));
    const double trace = rate[0][0] + rate[1][1] + rate[2][2];
    for (unsigned int d = 0; d < 3; ++d)
    {
      for (unsigned int e = 0; e < 3; ++e)
        p.stress[d][e] += step * shear * (rate[d][e] + rate[e][d]);
      p.stress[d][d] += step * lame * trace;
      p.x[d] += p.way[d];
      p.change[d] = p.way[d] = 0.;
    }
  }

  std::vector<Particle> particles_;
  std::vector<Node> nodes_;
};

double measure_control()
{
  Control control;
  control.advance(1e-4);
  double best = 0.;
  for (unsigned int repetition = 0; repetition < 3; ++repetition)
  {
    const double start = processor_seconds();
    control.advance(1e-4);
    best = std::max(best, n_particles / (processor_seconds() - start));
  }
  return control.position() == 0.5 ? 0. : best;
}

void print(const char *name, const double value, const char *unit)
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::printf("%s,%.6g,%s\n", name, value, unit);
}

void measure_one_rank()
{
  const char *const unit = "particle-steps/(s core)";
  const auto alone = [](const unsigned int degree,
                        const ParticleMaterial &material) {
    return measure(degree, material, MPI_COMM_SELF, processor_seconds);
  };
  const double cubic = alone(3, elastic());
  print("mpm_linear", alone(1, elastic()), unit);
  print("mpm_quadratic", alone(2, elastic()), unit);
  print("mpm_cubic", cubic, unit);
  print("mpm_cubic_water", alone(3, water()), unit);
  print("mpm_over_control", cubic / measure_control(), "speed ratio");
}

void measure_two_ranks()
{
  double alone = 0.;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    alone = measure(3, elastic(), MPI_COMM_SELF, wall_time);
  MPI_Barrier(MPI_COMM_WORLD);
  const double both = measure(3, elastic(), MPI_COMM_WORLD, wall_time);
  print("mpm_two_ranks", both / alone, "speed ratio");
}
} // namespace


int main(int argc, char **argv)
{
  return contrecoup::measure_on_ranks(
    argc, argv, measure_one_rank, measure_two_ranks);
}
