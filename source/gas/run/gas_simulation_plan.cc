// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/record/gas_measures.h>
#include <contrecoup/gas/run/gas_simulation.h>
#include <contrecoup/gas/state/leaf_sampling.h>

namespace contrecoup::gas
{
namespace
{
  /// Volume of a box in its geometry, all of the body [m^3].
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
double GasSimulation<dim>::excess_energy() const
{
  if (!coarse_mesh_.is_axis_aligned())
    return 0.;
  const auto rest = conserved_state(ambient(), material_, dim + 3);
  double energy = (closed_volume() - volume_of(coarse_mesh_)) * rest[dim + 1];
  for (const NamedValue &total : gas_totals(mesh_, points_, field_, material_))
    if (total.name == "energy")
      energy += total.value;
    else if (total.name == "products_mass")
      energy += afterburn_.energy_left() * total.value;
  return energy;
}


template <int dim>
void GasSimulation<dim>::expect_blast(const double energy,
                                      const dealii::Point<dim> &centre,
                                      const double non_ideal_part)
{
  modelling_plan_.energy = energy;
  modelling_plan_.centre = centre;
  modelling_plan_.non_ideal_part = non_ideal_part;
}


template <int dim>
void GasSimulation<dim>::foresee_blast()
{
  auto &plan = modelling_plan_;
  if (plan.energy >= 0.)
    return;
  plan.energy = 0.;
  if (!coarse_mesh_.is_axis_aligned() || !plan.is_spherical)
    return;
  const auto box = disturbed_box();
  double part = 1.;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const double tolerance = 1e-9 * (plan.upper[d] - plan.lower[d]);
    const bool at_lower = box.first[d] < plan.lower[d] + tolerance;
    const bool at_upper = box.second[d] > plan.upper[d] - tolerance;
    using Kind = typename Boundary<dim>::Kind;
    // Without a disturbance, or where it fills the domain or leaves it
    // already, there is no blast to come.
    if (!(box.first[d] < box.second[d]) || (at_lower && at_upper) ||
        (at_lower && boundary_.kind(2 * d) != Kind::wall) ||
        (at_upper && boundary_.kind(2 * d + 1) != Kind::wall))
      return;
    plan.centre[d] = at_lower   ? plan.lower[d]
                     : at_upper ? plan.upper[d]
                                : 0.5 * (box.first[d] + box.second[d]);
    const bool is_radius = d == 0 && coarse_mesh_.geometry() != Geometry::plane;
    if (is_radius)
      plan.centre[d] = 0.;
    else if (at_lower || at_upper)
      part *= 0.5;
  }
  plan.energy = std::max(0., excess_energy() / part);
}


template <int dim>
std::vector<Assumption> GasSimulation<dim>::plan()
{
  auto &plan = modelling_plan_;
  plan.is_spherical = dim == 3 ||
                      coarse_mesh_.geometry() == Geometry::axisymmetric ||
                      coarse_mesh_.geometry() == Geometry::spherical;
  plan.ambient = ambient();
  plan.lower = coarse_mesh_.lower_corner();
  plan.upper = coarse_mesh_.upper_corner();
  plan.open_sides.clear();
  for (unsigned int side = 0; side < 2 * dim; ++side)
    if (coarse_mesh_.is_axis_aligned() && !coarse_mesh_.is_periodic(side / 2) &&
        boundary_.kind(side) == Boundary<dim>::Kind::open)
      plan.open_sides.push_back(side);
  plan.probes = probes_.places();
  plan.end_time = end_time_;
  plan.skips_quiet_leaves = skip_quiet_leaves_;
  plan.smallest_cell = finest_edge();
  if (const double part = non_ideal_part(); !std::isnan(part))
    plan.non_ideal_part = part;
  foresee_blast();
  return plan.plan();
}


template <int dim>
double GasSimulation<dim>::non_ideal_part() const
{
  if (!material_.has_products())
    return std::numeric_limits<double>::quiet_NaN();
  // Less are traces, which have the pressure of the air around them.
  constexpr double least_products = 0.5;
  double largest = -1.;
  std::vector<double> u(layout_.n_components);
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
  {
    const auto values = field_.leaf(leaf);
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      for (unsigned int c = 0; c < u.size(); ++c)
        u[c] = values[c * layout_.n_points + q];
      const auto state = primitive_state<dim>(u.data(), material_);
      if (state.products < least_products)
        continue;
      // Pressures are linear in the energy; an ideal gas has none without.
      const double energy = material_.internal_energy_density(
        state.density, state.pressure, state.products);
      const double more =
        material_.pressure(state.density, 1.01 * energy, state.products);
      const double ideal = (more - state.pressure) / 0.01;
      largest = std::max(largest, std::abs(1. - ideal / state.pressure));
    }
  }
  largest = dealii::Utilities::MPI::max(largest, mesh_.communicator());
  return largest < 0. ? std::numeric_limits<double>::quiet_NaN() : largest;
}


template <int dim>
double GasSimulation<dim>::finest_edge() const
{
  double shortest = std::numeric_limits<double>::max();
  if (coarse_mesh_.is_axis_aligned())
    for (unsigned int d = 0; d < dim; ++d)
      shortest = std::min(shortest, smallest_cell()[d]);
  for (unsigned int leaf = 0;
       !coarse_mesh_.is_axis_aligned() && leaf < mesh_.n_owned();
       ++leaf)
    for (unsigned int d = 0; d < dim; ++d)
      shortest =
        std::min(shortest, leaf_box(mesh_, leaf).extents[d] / layout_.n);
  return dealii::Utilities::MPI::min(shortest, mesh_.communicator());
}


template <int dim>
std::vector<Assumption> GasSimulation<dim>::audit()
{
  typename ModellingPlan<dim>::Findings findings;
  findings.time = time_;
  open_sides_.share(mesh_.communicator());
  findings.side_arrivals = open_sides_.arrivals();
  for (const BlastMeasures &blast : probes_.blasts())
    findings.peaks.push_back(blast.peak);
  findings.smallest_cell = finest_edge();
  findings.non_ideal_part = non_ideal_part();
  const double n_possible = dealii::Utilities::MPI::sum(
    stepper_->quiet_leaves().n_possible(), mesh_.communicator());
  findings.skipped = n_possible > 0. ? 1. - n_computed_ / n_possible : 0.;
  return modelling_plan_.audit(findings);
}


#define CONTRECOUP_INSTANTIATE(dim)                            \
  template double GasSimulation<dim>::excess_energy() const;   \
  template void GasSimulation<dim>::expect_blast(              \
    double, const dealii::Point<dim> &, double);               \
  template void GasSimulation<dim>::foresee_blast();           \
  template double GasSimulation<dim>::non_ideal_part() const;  \
  template double GasSimulation<dim>::finest_edge() const;     \
  template std::vector<Assumption> GasSimulation<dim>::plan(); \
  template std::vector<Assumption> GasSimulation<dim>::audit()

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
