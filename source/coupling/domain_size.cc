// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/log.h>
#include <contrecoup/base/parameter_tree.h>
#include <contrecoup/base/text.h>
#include <contrecoup/base/time_parameters.h>
#include <contrecoup/coupling/coarse_scene.h>
#include <contrecoup/coupling/domain_size.h>
#include <contrecoup/coupling/staged_simulation.h>

#include <cmath>

namespace contrecoup::coupling
{
namespace
{
  using gas::GasSimulation;

  /// The plan of the scene in one stage, on a coarse mesh.
  template <int dim>
  gas::ModellingPlan<dim> coarse_plan(const ParameterHandler &scene,
                                      const MPI_Comm communicator)
  {
    // Halvings that still leave the charge a few cells in most scenes; its
    // energy does not depend on them.
    const unsigned int levels = 3;
    ParameterHandler prm;
    TimeParameters::declare_parameters(prm);
    StagedSimulation<3>::declare_parameters(prm);
    apply_assignments(assignments_of(scene), prm);
    coarsen_scene(prm, levels);
    GasSimulation<dim> simulation(communicator);
    simulation.parse_parameters(prm);
    simulation.setup();
    simulation.plan();
    return simulation.modelling_plan();
  }

  /// Distance by which @p side must move outwards for all probes [m].
  template <int dim>
  double growth(const gas::ModellingPlan<dim> &plan,
                const unsigned int side,
                const double path)
  {
    const unsigned int d = side / 2;
    const double sign = side % 2 == 0 ? -1. : 1.;
    const double place = side % 2 == 0 ? plan.lower[d] : plan.upper[d];
    double result = 0.;
    for (const auto &probe : plan.probes)
    {
      auto across = probe - plan.centre;
      across[d] = 0.;
      const double along =
        std::sqrt(std::max(0., path * path - across.norm_square()));
      // The mirror image of the probe is at 2 side - probe.
      const double needed = 0.5 * (sign * (probe[d] + plan.centre[d]) + along);
      result = std::max(result, needed - sign * place);
    }
    return result;
  }
} // namespace


template <int dim>
void fit_domain(ParameterHandler &scene, const MPI_Comm communicator)
{
  CoarseMesh<dim> mesh;
  mesh.parse_parameters(scene);
  {
    const Section section(scene, "Domain");
    scene.set("Size", "given");
  }
  if (!mesh.is_axis_aligned())
    throw InputError("Domain/Size = by time needs Domain/Mesh = box");
  Log::instance().set_active(false);
  const gas::ModellingPlan<dim> plan = coarse_plan<dim>(scene, communicator);
  Log::instance().set_active(
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
  if (plan.probes.empty())
    throw InputError("Domain/Size = by time needs Probes/Points, where "
                     "nothing may come back before the end time");
  const double front = plan.expected_front(plan.end_time);
  if (std::isnan(front))
    throw InputError("Domain/Size = by time needs a charge, or another "
                     "spherical blast that begins in gas at rest");

  auto lower = mesh.lower_corner(), upper = mesh.upper_corner();
  std::vector<std::string> leaves, low, high;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const double leaf = (upper[d] - lower[d]) / mesh.coarse_cells(d);
    double count = mesh.coarse_cells(d);
    for (const unsigned int side : plan.open_sides)
      if (side / 2 == d)
      {
        const double added =
          std::ceil(growth(plan, side, front) / leaf * (1. - 1e-12));
        (side % 2 == 0 ? lower : upper)[d] +=
          (side % 2 == 0 ? -added : added) * leaf;
        count += added;
      }
    leaves.push_back(brief(count, 12));
    low.push_back(exact(lower[d]));
    high.push_back(exact(upper[d]));
  }
  const Section section(scene, "Domain");
  scene.set("Lower corner", join(low, ", "));
  scene.set("Upper corner", join(high, ", "));
  scene.set("Coarse leaves", join(leaves, ", "));
  log_line("domain sized by time: from " + join(low, ", ") + " to " +
           join(high, ", ") + " m, coarse leaves " + join(leaves, ", "));
}


template void fit_domain<1>(ParameterHandler &, MPI_Comm);
template void fit_domain<2>(ParameterHandler &, MPI_Comm);
template void fit_domain<3>(ParameterHandler &, MPI_Comm);
} // namespace contrecoup::coupling
