// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/interface_coupling.h>
#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Names of the values of CouplingScheme, in the same order.
  const std::vector<std::string> names{"monolithic",
                                       "loose",
                                       "fixed relaxation",
                                       "Aitken"};

} // namespace


void InterfaceCoupling::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Coupling");
  declare_selection(prm,
                    "Scheme",
                    "monolithic",
                    names,
                    "monolithic: fluids and solids are solved together. The "
                    "partitioned schemes show where partitioning fails: "
                    "loose iterates once a step, fixed relaxation and "
                    "Aitken to convergence.");
  declare_double(
    prm,
    "Relaxation",
    "0.5",
    1e-3,
    2.,
    "-",
    used_with("Coupling/Scheme = fixed relaxation, Aitken",
              "Relaxation factor of fixed relaxation, and the first one "
              "of Aitken; converges below 2 / (1 + added mass ratio)."));
  declare_double(
    prm,
    "Tolerance",
    "1e-8",
    1e-14,
    0.1,
    "-",
    used_with("Coupling/Scheme = fixed relaxation, Aitken",
              "Convergence criterion: change of acceleration over the "
              "acceleration of the solid without added mass."));
  declare_integer(
    prm,
    "Largest iterations",
    "50",
    1,
    10000,
    used_with("Coupling/Scheme = fixed relaxation, Aitken",
              "The run fails when a step needs more iterations."));
}


void InterfaceCoupling::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Coupling");
  const auto found = std::find(names.begin(), names.end(), prm.get("Scheme"));
  set(static_cast<CouplingScheme>(found - names.begin()),
      read_double(prm, "Relaxation"),
      read_double(prm, "Tolerance"),
      read_unsigned(prm, "Largest iterations"));
}


void InterfaceCoupling::set(const CouplingScheme scheme,
                            const double relaxation,
                            const double tolerance,
                            const unsigned int largest_iterations)
{
  scheme_ = scheme;
  relaxation_ = relaxation;
  tolerance_ = tolerance;
  most_iterations_ = largest_iterations;
}


const std::string &InterfaceCoupling::name() const
{
  return names[static_cast<unsigned int>(scheme_)];
}


void InterfaceCoupling::reinit(const HexSpace &space,
                               const std::vector<Region> &regions,
                               const SlipWalls &walls)
{
  space_ = &space;
  nodes_.clear();
  record_ = CouplingRecord();
  record_.factor = relaxation_;
  has_diverged_ = false;
  if (!active())
    return;
  find_nodes(regions);
  find_free_directions(walls);
  const std::uint64_t n_nodes = nodes_.size();
  if (dealii::Utilities::MPI::sum(n_nodes, space.communicator()) == 0)
    throw_no_interface();
}


void InterfaceCoupling::throw_no_interface() const
{
  throw InputError("Coupling/Scheme = " + name() +
                   " needs a fluid and a solid that share nodes; without, it "
                   "must be monolithic");
}


void InterfaceCoupling::require_interface(
  const dealii::Triangulation<3> &mesh,
  const std::vector<Region> &regions) const
{
  if (!active())
    return;
  std::vector<bool> has_solid(mesh.n_vertices()), has_fluid(has_solid);
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      (regions[cell->material_id()].solid() == nullptr
         ? has_fluid
         : has_solid)[cell->vertex_index(v)] = true;
  for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
    if (has_solid[v] && has_fluid[v])
      return;
  throw_no_interface();
}


void InterfaceCoupling::find_nodes(const std::vector<Region> &regions)
{
  // Per node: mass of solids, and number of fluid cells.
  FieldExchange exchange;
  exchange.reinit(space_->nodes(), 2);
  dealii::AlignedVector<double> sums(exchange.size());
  const auto undeformed = space_->positions(node_width);
  for (std::size_t c = 0; c < space_->n_locally_owned_cells(); ++c)
  {
    const SolidMaterial *const solid = regions[space_->region(c)].solid();
    const auto corners = corners_of(space_->cell(c), undeformed);
    const double mass =
      solid == nullptr ? 0. : solid->density * hex_moments(corners).volume;
    for (const std::uint32_t node : space_->cell(c))
    {
      sums[2 * node] += 0.125 * mass;
      sums[2 * node + 1] += solid == nullptr ? 1. : 0.;
    }
  }
  exchange.compress_add(sums);
  for (std::uint32_t n = 0; n < space_->n_locally_owned_nodes(); ++n)
    if (sums[2 * n] > 0. && sums[2 * n + 1] > 0.)
    {
      Node node{};
      node.node = n;
      node.solid_mass = sums[2 * n];
      nodes_.push_back(node);
    }
}


void InterfaceCoupling::find_free_directions(const SlipWalls &walls)
{
  // Walls apply a projection plus their own motion; subtract the motion.
  dealii::AlignedVector<double> moved(node_width * space_->n_nodes());
  walls.apply(moved, 0.);
  for (unsigned int d = 0; d < 3; ++d)
  {
    dealii::AlignedVector<double> unit(node_width * space_->n_nodes());
    for (std::size_t n = 0; n < space_->n_nodes(); ++n)
      unit[node_width * n + d] = 1.;
    walls.apply(unit, 0.);
    for (Node &node : nodes_)
    {
      const auto column =
        vector_at(unit, node.node) - vector_at(moved, node.node);
      for (unsigned int e = 0; e < 3; ++e)
        node.free[e][d] = column[e];
    }
  }
}


bool InterfaceCoupling::balance(const dealii::AlignedVector<double> &velocity,
                                const bool is_first_half,
                                dealii::AlignedVector<double> &force)
{
  has_diverged_ = false;
  if (!active())
    return true;
  if (is_first_half)
  {
    factor_ = record_.factor;
    iterations_ = 0;
  }
  for (Node &node : nodes_)
  {
    const double mass = 1. / velocity[node_width * node.node + 3];
    node.ratio = mass / node.solid_mass - 1.;
    record_.largest_ratio = std::max(record_.largest_ratio, node.ratio);
    node.uncoupled_acceleration =
      node.free * vector_at(force, node.node) / node.solid_mass;
    if (is_first_half)
      node.now = node.before;
  }
  has_diverged_ = !iterate();
  for (Node &node : nodes_)
  {
    node.imbalance = node.solid_mass * ((1. + node.ratio) * node.now -
                                        node.uncoupled_acceleration);
    for (unsigned int d = 0; d < 3; ++d)
      force[node_width * node.node + d] += node.imbalance[d];
  }
  return !has_diverged_;
}


bool InterfaceCoupling::iterate()
{
  if (scheme_ == CouplingScheme::loose)
  {
    iterations_ = 1;
    for (Node &node : nodes_)
      node.now = node.uncoupled_acceleration - node.ratio * node.before;
    return true;
  }
  double first = 0.;
  for (unsigned int k = 1; k <= most_iterations_; ++k)
  {
    std::vector<double> sums(4, 0.);
    for (Node &node : nodes_)
    {
      const Vector residual =
        node.uncoupled_acceleration - (1. + node.ratio) * node.now;
      const Vector change = residual - node.residual;
      sums[0] += residual * residual;
      sums[1] += node.uncoupled_acceleration * node.uncoupled_acceleration;
      sums[2] += node.residual * change;
      sums[3] += change * change;
      node.residual = residual;
    }
    dealii::Utilities::MPI::sum(sums, space_->communicator(), sums);
    // Let the step detect forces that are not finite.
    if (!std::isfinite(sums[1]))
      return true;
    if (k == 1)
      first = sums[0];
    else if (scheme_ == CouplingScheme::aitken && sums[3] > 0.)
      factor_ *= -sums[2] / sums[3];
    const double factor =
      scheme_ == CouplingScheme::aitken ? factor_ : relaxation_;
    for (Node &node : nodes_)
      node.now += factor * node.residual;
    iterations_ = std::max<std::uint64_t>(iterations_, k);
    last_change_ = std::sqrt(sums[0] / first);
    if (sums[0] <= tolerance_ * tolerance_ * std::max(sums[1], first))
      return true;
  }
  return false;
}


std::string InterfaceCoupling::failure_text() const
{
  if (!active())
    return "";
  const CouplingRecord now = record();
  const std::string ratio = brief(now.largest_ratio, 3);
  if (!has_diverged_)
    return "; fluids and solids are solved in turn, " + name() +
           ", with a ratio of added mass of up to " + ratio +
           ", and have made up " + brief(now.work) + " J";
  return "fluids and solids do not agree after " +
         std::to_string(most_iterations_) + " iterations (" + name() +
         ", the residual is " + brief(last_change_, 3) +
         " times the first) with a ratio of added mass of up to " + ratio +
         (scheme_ == CouplingScheme::fixed_relaxation
            ? ", where Coupling/Relaxation must be below " +
                brief(2. / (1. + now.largest_ratio), 3)
            : "");
}


void InterfaceCoupling::finish_step(const dealii::AlignedVector<double> &mean,
                                    const double step)
{
  if (!active())
    return;
  ++record_.n_steps;
  record_.n_iterations += iterations_;
  record_.last_iterations = iterations_;
  record_.largest_iterations =
    std::max(record_.largest_iterations, iterations_);
  record_.factor = factor_;
  for (Node &node : nodes_)
  {
    record_.work += step * (vector_at(mean, node.node) * node.imbalance);
    node.before = node.now;
  }
}


CouplingRecord InterfaceCoupling::record() const
{
  CouplingRecord result = record_;
  if (!active())
    return result;
  result.work =
    dealii::Utilities::MPI::sum(record_.work, space_->communicator());
  result.largest_ratio =
    dealii::Utilities::MPI::max(record_.largest_ratio, space_->communicator());
  return result;
}


std::vector<NamedValue> InterfaceCoupling::history() const
{
  if (!active())
    return {};
  const CouplingRecord now = record();
  return {{"interface_work", "J", now.work},
          {"coupling_iterations", "-", double(now.last_iterations)},
          {"added_mass_ratio", "-", now.largest_ratio}};
}


std::vector<NamedValue> InterfaceCoupling::summary(const double energy) const
{
  if (!active())
    return {};
  const CouplingRecord now = record();
  return {{"interface_work", "-", now.work / energy},
          {"added_mass_ratio", "-", now.largest_ratio},
          {"largest_coupling_iterations", "-", double(now.largest_iterations)},
          {"mean_coupling_iterations",
           "-",
           double(now.n_iterations) / std::max(1., double(now.n_steps))}};
}


void InterfaceCoupling::require_stable(const double time,
                                       const double energy) const
{
  constexpr double largest_part = 0.9;
  const CouplingRecord now = record();
  if (now.work > largest_part * energy)
    throw NumericsError(
      "time " + exact(time) + " s: of the total energy, " + brief(energy) +
      " J, " + brief(now.work) + " J are spurious work of the " + name() +
      " coupling of fluids and solids, with added mass ratios up to " +
      brief(now.largest_ratio, 3) +
      "; for ratios above about 1 choose another Coupling/Scheme");
}
} // namespace contrecoup::ale
