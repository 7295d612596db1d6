// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/coarse_scene.h>
#include <contrecoup/coupling/application/domain_size.h>
#include <contrecoup/coupling/first_stage/staged_simulation.h>
#include <contrecoup/geometry/body/body_description.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace contrecoup::coupling
{
namespace
{
  using gas::GasSimulation;

  /// Lower and upper corner.
  template <int dim>
  using Box = std::pair<dealii::Point<dim>, dealii::Point<dim>>;

  /// Plan of the scene without its body, in one stage on a coarse mesh.
  template <int dim>
  gas::ModellingPlan<dim> coarse_plan(const ParameterHandler &scene,
                                      const MPI_Comm communicator)
  {
    // Coarsening after which most charges still have a few subcells; the
    // energy does not depend on it.
    const unsigned int levels = 3;
    ParameterHandler prm;
    TimeParameters::declare_parameters(prm);
    StagedSimulation<3>::declare_parameters(prm);
    apply_assignments(assignments_of(scene), prm);
    coarsen_scene(prm, levels);
    apply_assignments({parse_override("Method/Precision=double"),
                       parse_override("Rigid body/Kind=none"),
                       parse_override("Loads/Record=false")},
                      prm);
    GasSimulation<dim> simulation(communicator);
    simulation.parse_parameters(prm);
    simulation.setup();
    simulation.plan();
    return simulation.modelling_plan();
  }

  /// Bounding box of the rigid body within the domain and beyond its open
  /// sides; nothing without a body, and for walls, which extend farther beyond
  /// open sides than the domain is long.
  template <int dim>
  std::optional<Box<dim>> box_of_body(ParameterHandler &scene,
                                      const gas::ModellingPlan<dim> &plan)
  {
    {
      const Section section(scene, "Rigid body");
      if (scene.get("Kind") != "body")
        return {};
    }
    BodyDescription description;
    {
      const Section section(scene, "Body");
      description.parse_parameters(scene);
    }
    const auto box = description.create()->surface()->bounding_box();
    Box<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const auto is_open = [&](const unsigned int side) {
        return std::count(
                 plan.open_sides.begin(), plan.open_sides.end(), side) > 0;
      };
      const double low = plan.lower[d], high = plan.upper[d];
      result.first[d] =
        is_open(2 * d) ? box.lower_bound(d) : std::max(low, box.lower_bound(d));
      result.second[d] = is_open(2 * d + 1)
                           ? box.upper_bound(d)
                           : std::min(high, box.upper_bound(d));
      if (result.first[d] > result.second[d] ||
          result.first[d] < low - (high - low) ||
          result.second[d] > high + (high - low))
        return {};
    }
    return result;
  }

  /// Positions that no reflection from an open side may reach: the gauges, and
  /// the point of the body's box that a wave from @p side would meet first.
  template <int dim>
  std::vector<dealii::Point<dim>>
  places_behind(const gas::ModellingPlan<dim> &plan,
                const std::optional<Box<dim>> &body,
                const unsigned int side)
  {
    std::vector<dealii::Point<dim>> places = plan.gauges;
    if (body)
    {
      dealii::Point<dim> nearest;
      for (unsigned int d = 0; d < dim; ++d)
        nearest[d] =
          std::min(std::max(plan.centre[d], body->first[d]), body->second[d]);
      nearest[side / 2] =
        (side % 2 == 0 ? body->first : body->second)[side / 2];
      places.push_back(nearest);
    }
    return places;
  }

  /// Distance by which @p side must move outwards so that the path of the
  /// reflection to each gauge and to the body is at least @p path [m].
  template <int dim>
  double growth(const gas::ModellingPlan<dim> &plan,
                const std::optional<Box<dim>> &body,
                const unsigned int side,
                const double path)
  {
    const unsigned int d = side / 2;
    const double sign = side % 2 == 0 ? -1. : 1.;
    const double place = side % 2 == 0 ? plan.lower[d] : plan.upper[d];
    double result = 0.;
    for (const auto &target : places_behind(plan, body, side))
    {
      auto across = target - plan.centre;
      across[d] = 0.;
      const double along =
        std::sqrt(std::max(0., path * path - across.norm_square()));
      // The mirror image of the target is at 2 side - target.
      const double needed = 0.5 * (sign * (target[d] + plan.centre[d]) + along);
      result =
        std::max({result, needed - sign * place, sign * (target[d] - place)});
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
  const auto body = box_of_body(scene, plan);
  if (plan.gauges.empty() && !body)
    throw InputError("Domain/Size = by time needs Probes or a body of "
                     "finite size, which reflections may not reach before the "
                     "end time");
  const double front = plan.expected_reach(plan.end_time);
  if (std::isnan(front))
    throw InputError("Domain/Size = by time needs a charge or another "
                     "spherical blast in gas at rest");

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
          std::ceil(growth(plan, body, side, front) / leaf * (1. - 1e-12));
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
           join(high, ", ") + " m, coarse leaves " + join(leaves, ", ") +
           ", for a front that goes " + brief(front, 3) + " m until " +
           brief(plan.end_time, 3) + " s");
}


template void fit_domain<1>(ParameterHandler &, MPI_Comm);
template void fit_domain<2>(ParameterHandler &, MPI_Comm);
template void fit_domain<3>(ParameterHandler &, MPI_Comm);
} // namespace contrecoup::coupling
