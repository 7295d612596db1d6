// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/hand_over/profile_extraction.h>
#include <contrecoup/gas/record/gas_measures.h>
#include <contrecoup/gas/run/run_plan.h>
#include <contrecoup/gas/scene/scene_places.h>
#include <contrecoup/gas/state/leaf_sampling.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  /// Volume of a box in its geometry, of the whole body of revolution [m^3].
  template <int dim>
  double volume_of(const CoarseMesh<dim> &mesh)
  {
    constexpr double pi = dealii::numbers::PI;
    const auto &low = mesh.lower_corner(), &high = mesh.upper_corner();
    const auto power = [&](const int exponent) {
      return std::pow(high[0], exponent) - std::pow(low[0], exponent);
    };
    double volume = mesh.geometry() == Geometry::spherical
                      ? 4. / 3. * pi * power(3)
                    : mesh.geometry() == Geometry::plane ? power(1)
                                                         : pi * power(2);
    for (unsigned int d = 1; d < dim; ++d)
      volume *= high[d] - low[d];
    return volume;
  }
} // namespace


template <int dim>
double RunPlan<dim>::excess_energy() const
{
  const GasScene<dim> &scene = core_.scene();
  const auto rest = conserved_state(scene.ambient(), scene.material, dim + 3);
  double energy =
    (core_.body().volume() - volume_of(scene.coarse_mesh)) * rest[dim + 1];
  for (const NamedValue &total :
       gas_totals(core_.mesh(), scene.points, core_.field(), scene.material))
    if (total.name == "energy")
      energy += total.value;
    else if (total.name == "products_mass")
      energy += core_.afterburn().energy_left() * total.value;
  return energy;
}


template <int dim>
void RunPlan<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  const auto planes = planes_of_symmetry(prm, core_.scene().coarse_mesh);
  plan_.n_symmetry_planes = std::count(planes.begin(), planes.end(), true);
}


template <int dim>
void RunPlan<dim>::expect_blast(const double energy,
                                const dealii::Point<dim> &centre,
                                const double non_ideal_fraction)
{
  plan_.energy = energy;
  plan_.centre = centre;
  plan_.non_ideal_fraction = non_ideal_fraction;
}


template <int dim>
void RunPlan<dim>::find_blast()
{
  auto &plan = plan_;
  const GasScene<dim> &scene = core_.scene();
  if (plan.energy >= 0.)
    return;
  plan.energy = 0.;
  if (!scene.coarse_mesh.is_axis_aligned() || !plan.is_spherical)
    return;
  const auto box =
    disturbed_box(core_.mesh(),
                  scene.points,
                  core_.field(),
                  conserved_state(scene.ambient(), scene.material, dim + 3));
  double fraction = 1.;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const double tolerance = 1e-9 * (plan.upper[d] - plan.lower[d]);
    const bool at_lower = box.first[d] < plan.lower[d] + tolerance;
    const bool at_upper = box.second[d] > plan.upper[d] - tolerance;
    using Kind = typename Boundary<dim>::Kind;
    // Without a disturbance, or if it fills or leaves the domain already, no
    // blast is to be expected.
    if (!(box.first[d] < box.second[d]) || (at_lower && at_upper) ||
        (at_lower && scene.boundary.kind(2 * d) != Kind::wall) ||
        (at_upper && scene.boundary.kind(2 * d + 1) != Kind::wall))
      return;
    plan.centre[d] = at_lower   ? plan.lower[d]
                     : at_upper ? plan.upper[d]
                                : 0.5 * (box.first[d] + box.second[d]);
    const bool is_radius =
      d == 0 && scene.coarse_mesh.geometry() != Geometry::plane;
    if (is_radius)
      plan.centre[d] = 0.;
    else if (at_lower || at_upper)
      fraction *= 0.5;
  }
  plan.energy = std::max(0., excess_energy() / fraction);
}


template <int dim>
std::vector<Assumption> RunPlan<dim>::plan(const Recorders<dim> &recorders)
{
  const GasScene<dim> &scene = core_.scene();
  const CoarseMesh<dim> &mesh = scene.coarse_mesh;
  plan_.is_spherical = dim == 3 || mesh.geometry() == Geometry::axisymmetric ||
                       mesh.geometry() == Geometry::spherical;
  plan_.ambient = scene.ambient();
  plan_.surrounds_explosives = scene.material.has_products();
  plan_.lower = mesh.lower_corner();
  plan_.upper = mesh.upper_corner();
  plan_.open_sides.clear();
  plan_.walls.clear();
  for (unsigned int side = 0; side < 2 * dim; ++side)
    if (mesh.is_axis_aligned() && !mesh.is_periodic(side / 2))
    {
      const auto kind = scene.boundary.kind(side);
      const bool is_axis = side == 0 && mesh.geometry() != Geometry::plane;
      if (kind == Boundary<dim>::Kind::open)
        plan_.open_sides.push_back(side);
      else if (kind == Boundary<dim>::Kind::wall && !is_axis)
        plan_.walls.push_back(side);
    }
  plan_.probes = recorders.template get<ProbeSet<dim>>().places();
  plan_.gauges = plan_.probes;
  const auto &rasters = recorders.template get<ProbeRasters<dim>>().places();
  plan_.gauges.insert(plan_.gauges.end(), rasters.begin(), rasters.end());
  plan_.end_time = scene.end_time;
  plan_.skips_quiet_leaves = core_.skips_quiet_leaves();
  plan_.adapts = core_.adaptation_parameters().active;
  plan_.smallest_subcell = finest_edge();
  if (std::isnan(plan_.non_ideal_fraction))
    plan_.non_ideal_fraction = non_ideal_fraction();
  find_blast();
  return plan_.plan();
}


template <int dim>
double RunPlan<dim>::non_ideal_fraction() const
{
  const GasMaterial &material = core_.scene().material;
  const LeafLayout &layout = core_.scene().layout;
  // A scene has an octree, but no state, until its first stage hands over.
  if (!material.has_products() ||
      core_.field().layout().n_components != layout.n_components)
    return std::numeric_limits<double>::quiet_NaN();
  // Smaller mass fractions are traces, at the pressure of the surrounding air.
  constexpr double least_products = 0.5;
  double largest = -1.;
  std::vector<double> u(layout.n_components);
  for (unsigned int leaf = 0; leaf < core_.mesh().n_owned(); ++leaf)
  {
    const auto values = core_.field().leaf(leaf);
    for (unsigned int q = 0; q < layout.n_points; ++q)
    {
      for (unsigned int c = 0; c < u.size(); ++c)
        u[c] = values[c * layout.n_points + q];
      const auto state = primitive_state<dim>(u.data(), material);
      if (state.products < least_products)
        continue;
      // Pressures are linear in the energy; that of an ideal gas vanishes at
      // zero energy.
      const double energy = material.internal_energy_density(
        state.density, state.pressure, state.products);
      const double more =
        material.pressure(state.density, 1.01 * energy, state.products);
      const double ideal = (more - state.pressure) / 0.01;
      largest = std::max(largest, std::abs(1. - ideal / state.pressure));
    }
  }
  largest = dealii::Utilities::MPI::max(largest, core_.mesh().communicator());
  return largest < 0. ? std::numeric_limits<double>::quiet_NaN() : largest;
}


template <int dim>
double RunPlan<dim>::finest_edge() const
{
  const GasScene<dim> &scene = core_.scene();
  const bool is_box = scene.coarse_mesh.is_axis_aligned();
  double shortest = std::numeric_limits<double>::max();
  if (is_box)
    for (unsigned int d = 0; d < dim; ++d)
      shortest = std::min(shortest, core_.smallest_subcell()[d]);
  for (unsigned int leaf = 0; !is_box && leaf < core_.mesh().n_owned(); ++leaf)
    for (unsigned int d = 0; d < dim; ++d)
      shortest = std::min(
        shortest, leaf_box(core_.mesh(), leaf).extents[d] / scene.layout.n);
  return dealii::Utilities::MPI::min(shortest, core_.mesh().communicator());
}


template <int dim>
std::vector<Assumption> RunPlan<dim>::audit(Recorders<dim> &recorders) const
{
  auto &open_sides = recorders.template get<OpenSides<dim>>();
  open_sides.reduce_over_ranks();
  typename ModellingPlan<dim>::Measurements measured;
  measured.time = core_.time();
  measured.side_arrivals = open_sides.arrivals();
  const auto &probes = recorders.template get<ProbeSet<dim>>();
  const auto waves = probes.first_waves();
  for (std::size_t i = 0; i < waves.size(); ++i)
    if (!plan_.is_reflected_at(probes.places()[i]))
      measured.peaks.push_back(waves[i].peak);
  measured.smallest_subcell = finest_edge();
  measured.non_ideal_fraction = non_ideal_fraction();
  measured.skipped = core_.skipped_updates();
  return plan_.audit(measured);
}


template class RunPlan<1>;
template class RunPlan<2>;
template class RunPlan<3>;
} // namespace contrecoup::gas
