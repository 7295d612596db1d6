// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/run/gas_simulation.h>

namespace contrecoup::gas
{
template <int dim>
void GasSimulation<dim>::refine_octree()
{
  mesh_.triangulation().refine_global(coarse_mesh_.initial_refinement());
  mesh_.rebuild();
  adaptation_->refine_fine_box();
  adaptation_->refine_at_body();
}


template <int dim>
void GasSimulation<dim>::fit_mesh_to_initial_state()
{
  while (adaptation_->refine_where(
    [this](const unsigned int leaf) { return wants_initial_refinement(leaf); }))
    ;
  // The sensor then sees what distances alone cannot tell.
  for (unsigned int level = 0; level < adaptation_parameters_.most_level;
       ++level)
  {
    set_initial_state(true);
    stepper_->update_ghosts(field_);
    if (!adaptation_->adapt(field_))
      break;
    mesh_changed();
  }
}


template <int dim>
bool GasSimulation<dim>::wants_initial_refinement(const unsigned int leaf) const
{
  const LeafBox<dim> box = leaf_box(mesh_, leaf);
  if (const auto *profile = initial_state_.profile())
    return is_steep_in(*profile, box, layout_.n);
  const dealii::Point<dim> centre =
    box.origin + dealii::Tensor<1, dim>(box.extents * 0.5);
  const double reach = 0.5 * box.extents.norm() * (1. + 1e-10);
  if (charges_.signed_distance(centre) < reach)
    return true;
  const double distance = initial_state_.distance_to_feature(centre);
  // Smooth fields have no features to go by; the sensor finds their shape.
  return distance > 0. && distance < reach;
}


template <int dim>
bool GasSimulation<dim>::adapt()
{
  if (!adaptation_parameters_.active || !adaptation_pace_.is_due())
    return false;
  adaptation_pace_.restart(time_);
  stepper_->update_ghosts(field_);
  const bool changed =
    adaptation_->adapt(field_, maps_, time_, &stepper_->quiet_leaves());
  if (changed)
    mesh_changed();
  else
    update_front_shares();
  return changed;
}


template <int dim>
void GasSimulation<dim>::update_front_shares()
{
  if (adaptation_parameters_.active)
    stepper_->set_front_shares(
      adaptation_->front_shares(adaptation_pace_.start()));
}


#define CONTRECOUP_INSTANTIATE(dim)                              \
  template void GasSimulation<dim>::refine_octree();             \
  template void GasSimulation<dim>::fit_mesh_to_initial_state(); \
  template void GasSimulation<dim>::update_front_shares();       \
  template bool GasSimulation<dim>::adapt()

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
