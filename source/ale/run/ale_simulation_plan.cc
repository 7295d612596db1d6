// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/scene_check.h>
#include <contrecoup/ale/run/ale_simulation.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
ImpactPlan AleSimulation::impact_plan() const
{
  ImpactPlan plan = impact_.plan(recorders_.get<HeadMeasures>());
  plan.cell_size = impact_.mesh.cell_size();
  if (const FileMesh *const file = impact_.mesh.file())
  {
    plan.n_pieces = file->n_pieces();
    plan.scaled_jacobian = file->smallest_scaled_jacobian();
  }
  if (coupling_.active())
    plan.coupling = coupling_.name();
  find_symmetry(plan);
  return plan;
}


void AleSimulation::find_symmetry(ImpactPlan &plan) const
{
  const LayeredHead *head = impact_.mesh.head();
  if (head == nullptr)
    return;
  const double whole = head->n_cells_of_whole();
  plan.cost = plan.least_cost = head->n_cells() / whole;
  if (head->wedge().active())
    plan.wedge = std::string(1, "xyz"[head->wedge().axis]);
  std::array<bool, 3> would_do{};
  for (unsigned int d = 0; d < 3; ++d)
  {
    would_do[d] =
      impact_.motion_along(d) == 0. && !impact_.regions.depends_on_place();
    if (!head->is_halved()[d] && would_do[d])
      plan.least_cost *= 0.5;
  }
  const auto &brain = head->semi_axes().front();
  for (unsigned int d = 0; d < 3; ++d)
  {
    const unsigned int a = (d + 1) % 3, b = (d + 2) % 3;
    const double cost = head->n_cells_of_wedge(would_do[d]) / whole;
    if (would_do[a] && would_do[b] && brain[a] == brain[b] &&
        !coupling_.active() && cost < plan.least_cost)
    {
      plan.least_cost = cost;
      plan.least_cost_wedge = std::string(1, "xyz"[d]);
    }
  }
}


std::vector<Assumption> AleSimulation::plan()
{
  return impact_plan().plan();
}


std::vector<Assumption> AleSimulation::audit()
{
  const ContactMeasures contact = contact_.value_or(ContactMeasures());
  return impact_plan().audit(
    {recorders_.get<RegionHistory>().extremes().least_pressures(),
     recorders_.get<ContactHistory<AleSnapshot>>().contact(),
     contact.friction_work,
     contact.sliding_work,
     energies_.initial_kinetic,
     lagrange_.coupling().record().work,
     energies_.largest,
     time()});
}
} // namespace contrecoup::ale
