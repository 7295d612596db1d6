// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// Throughput of the solid's time step on a cube of a million one-point
// elements, one row per case. Started without arguments it runs itself under
// mpirun, on one rank and on two.

#include <contrecoup/base/system/processor_time.h>
#include <contrecoup/solid/body/node_backup.h>
#include <contrecoup/solid/body/node_exchange.h>
#include <contrecoup/solid/motion/node_motion.h>
#include <contrecoup/solid/motion/solid_operator.h>

#include <deal.II/base/mpi.h>

#include "on_ranks.h"

#include <chrono>
#include <cstdio>

namespace
{
using namespace contrecoup;

/// Wall time, or processor time of this process [s].
double now(const bool wall)
{
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return wall ? std::chrono::duration<double>(time).count()
              : processor_seconds();
}

/// A cube of n^3 elements of one tissue.
HexMesh cube(const unsigned int n)
{
  LabelGrid grid;
  grid.spacing = 1. / n;
  grid.size = {{n + 2, n + 2, n + 2}};
  grid.labels.assign((n + 2) * (n + 2) * (n + 2), LabelGrid::outside);
  for (unsigned int k = 1; k <= n; ++k)
    for (unsigned int j = 1; j <= n; ++j)
      for (unsigned int i = 1; i <= n; ++i)
        grid.labels[grid.index(i, j, k)] = 0;
  return make_hex_mesh(grid, {{"cube", Tissue::brain}});
}

/// A cube whose corner was pushed, and its steps.
template <typename Real>
class Steps
{
public:
  Steps(const HexMesh &mesh,
        const SolidMaterial &material,
        const MPI_Comm communicator,
        const double pressure_smoothing = 0.)
    : mesh_(solid::distribute(mesh, communicator))
    , n_cells_(mesh.cells.size())
    , step_(0.3 / 100. / material.dilatational_speed())
  {
    solid::ElementOptions options;
    options.pressure_smoothing = pressure_smoothing;
    operator_.reinit(mesh_, {material}, options);
    operator_.reinit_nodes(nodes_);
    exchange_.reinit(mesh_, communicator);
    std::vector<double> masses = operator_.nodal_masses();
    exchange_.add(masses.data(), 1, 1);
    for (std::size_t i = 0; i < masses.size(); ++i)
    {
      nodes_.inverse_mass_of(i) = Real(1. / masses[i]);
      for (unsigned int d = 0; d < 3; ++d)
        nodes_.velocity_of(i)[d] =
          Real(std::sin(7. * mesh_.nodes[i][d] + mesh_.nodes[i][(d + 1) % 3]));
    }
    if (operator_.smooths())
    {
      const std::vector<double> weights = operator_.smoothing_weights();
      for (std::size_t i = 0; i < weights.size(); ++i)
        nodes_.inverse_weight_of(i) = Real(1. / weights[i]);
    }
    // Nothing is quiet: every element is computed.
    nodes_.mark_active_blocks();
  }

  void step()
  {
    solid::move_nodes(nodes_, mesh_.owned, step_, step_);
    operator_.add_forces(nodes_, {step_, step_, 0.5 * step_});
    exchange_.add(
      nodes_.force.data(), operator_.smooths() ? 4 : 3, nodes_.width);
  }

  /// Element updates per second, of wall time or of processor time: the
  /// latter does not depend on what else the machine does.
  double measure(const bool wall)
  {
    step();
    double best = 0.;
    for (unsigned int repetition = 0; repetition < 3; ++repetition)
    {
      const double start = now(wall);
      const unsigned int n_steps = 10;
      for (unsigned int i = 0; i < n_steps; ++i)
        step();
      best = std::max(best, n_steps * n_cells_ / (now(wall) - start));
    }
    return best;
  }

  /// Bytes that the time loop needs for an element with its nodes, with the
  /// state that a body keeps to step back to.
  double bytes() const
  {
    solid::NodeBackup<Real> nodes;
    nodes.save(nodes_);
    const solid::HexMemory<Lanes<Real>> elements = operator_.batches();
    return (operator_.batches().memory() + 16. * sizeof(Real) * nodes_.size() +
            mesh_.owned.size() + nodes.memory_consumption() +
            elements.dilatation.memory_consumption() +
            elements.viscous_pressure.memory_consumption() +
            elements.relaxed.memory_consumption() +
            elements.damping.memory_consumption()) /
           n_cells_;
  }

private:
  solid::SolidMesh mesh_;
  double n_cells_;
  double step_;
  solid::SolidOperator<Real> operator_;
  solid::NodeFields<Real> nodes_;
  solid::NodeExchange exchange_;
};

SolidMaterial material(const bool viscoelastic)
{
  SolidMaterial brain =
    solid_material(find_tissue_properties("paper", Tissue::brain));
  if (!viscoelastic)
    brain.relaxing_shear = 0.;
  return brain;
}

void print(const char *name, const double value, const char *unit)
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::printf("%s,%.6g,%s\n", name, value, unit);
}

/// Time of an element with averaged pressures over that of one without.
template <typename Real>
double smoothing_cost(const HexMesh &mesh)
{
  Steps<Real> plain(mesh, material(true), MPI_COMM_SELF),
    smooth(mesh, material(true), MPI_COMM_SELF, 0.95);
  // In turn, since the machine's speed changes with time.
  double plain_rate = 0., smooth_rate = 0.;
  for (unsigned int i = 0; i < 2; ++i)
  {
    plain_rate = std::max(plain_rate, plain.measure(false));
    smooth_rate = std::max(smooth_rate, smooth.measure(false));
  }
  return plain_rate / smooth_rate;
}

void measure_one_rank(const HexMesh &mesh)
{
  const char *const unit = "element-updates/(s core)";
  const auto rate = [&](auto number, const bool viscoelastic) {
    return Steps<decltype(number)>(mesh, material(viscoelastic), MPI_COMM_SELF)
      .measure(false);
  };
  print("hex8_elastic_double", rate(0., false), unit);
  print("hex8_elastic_float", rate(0.F, false), unit);
  print("hex8_viscoelastic_double", rate(0., true), unit);
  print("hex8_viscoelastic_float", rate(0.F, true), unit);
  print(
    "hex8_smoothing_cost_double", smoothing_cost<double>(mesh), "time ratio");
  print("hex8_smoothing_cost_float", smoothing_cost<float>(mesh), "time ratio");
  print("hex8_bytes_per_element",
        Steps<double>(mesh, material(true), MPI_COMM_SELF).bytes(),
        "byte");
}

/// How much faster two ranks are than one of them alone.
void measure_two_ranks(const HexMesh &mesh)
{
  double alone = 0.;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    alone = Steps<double>(mesh, material(false), MPI_COMM_SELF).measure(true);
  MPI_Barrier(MPI_COMM_WORLD);
  const double both =
    Steps<double>(mesh, material(false), MPI_COMM_WORLD).measure(true);
  print("solid_two_ranks", both / alone, "speed ratio");
}
} // namespace


int main(int argc, char **argv)
{
  return contrecoup::measure_on_ranks(
    argc,
    argv,
    [] { measure_one_rank(cube(100)); },
    [] { measure_two_ranks(cube(100)); });
}
