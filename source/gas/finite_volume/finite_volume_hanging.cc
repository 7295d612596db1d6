// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/finite_volume/finite_volume_hanging.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
FiniteVolumeHanging<dim, Gas, Real>::FiniteVolumeHanging(
  const OperatorContext<dim> &context,
  const Gas &gas,
  PrimitiveField<dim, Gas, Real> &primitives)
  : Base(context, gas, primitives)
  , first_flux_(layout_.n_face_points)
{}


template <int dim, typename Gas, typename Real>
void FiniteVolumeHanging<dim, Gas, Real>::compute(
  const HangingGroup<dim> &group,
  const BasicStage<Real> &stage,
  HangingData<dim, Real> &hanging,
  const HangingOpenings<dim, Real> *openings)
{
  Base::prepare(group, stage, openings);
  for (unsigned int part = 0; part < n_fine; ++part)
    part_fluxes(group, part);
  average_fluxes(group);
  if (openings_ != nullptr)
    average_open_fluxes(group);
  Base::store(group, hanging);
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeHanging<dim, Gas, Real>::part_fluxes(
  const HangingGroup<dim> &group,
  const unsigned int part)
{
  const unsigned int direction = group.coarse_face / 2;
  const bool coarse_is_left = group.coarse_face % 2;
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
  {
    Values inside, outside;
    Base::reconstruct(part, q, inside, outside);
    Values left, right;
    for (unsigned int c = 0; c < nc; ++c)
    {
      const unsigned int from = rotated_component<dim>(c, direction);
      left[c] = coarse_is_left ? inside[from] : outside[from];
      right[c] = coarse_is_left ? outside[from] : inside[from];
    }
    auto left_state = to_face_state<dim>(gas_, left);
    auto right_state = to_face_state<dim>(gas_, right);
    Base::apply_burn_pressure(part,
                              q,
                              coarse_is_left ? left_state : right_state,
                              coarse_is_left ? right_state : left_state);
    const Values flux = to_array<dim, Gas>(
      numerical_flux(scheme_.flux, left_state, right_state, Number(1.)));
    for (unsigned int c = 0; c < nc; ++c)
      fine_flux_[part][q][rotated_component<dim>(c, direction)] = flux[c];
  }
}


template <int dim, typename Gas, typename Real>
typename FiniteVolumeHanging<dim, Gas, Real>::Number
FiniteVolumeHanging<dim, Gas, Real>::inner_radii(
  const HangingGroup<dim> &group) const
{
  Number result;
  for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
    result[lane] = group.inner_radius[lane];
  return result;
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeHanging<dim, Gas, Real>::average_fluxes(
  const HangingGroup<dim> &group)
{
  const Number inner = inner_radii(group);
  std::array<double, dim == 1 ? 1 : dim - 1> distance{};
  for (unsigned int part = 0; part < n_fine; ++part)
    for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    {
      const unsigned int at = Base::coarse_point(part, q, distance);
      const Values &flux = fine_flux_[part][q];
      const bool is_first = std::all_of(distance.begin(),
                                        distance.end(),
                                        [](const double x) { return x <= 0.; });
      if (is_first)
      {
        coarse_flux_[at] = flux;
        first_flux_[at] = flux;
        continue;
      }
      // Areas grow with the radius. Measured from the first flux, equal
      // fluxes have just that mean, to the last bit.
      const Number area =
        relative_radius(inner, layout_.n, at % layout_.n, distance[0]) *
        (1. / n_fine);
      for (unsigned int c = 0; c < nc; ++c)
        coarse_flux_[at][c] += (flux[c] - first_flux_[at][c]) * area;
    }
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeHanging<dim, Gas, Real>::average_open_fluxes(
  const HangingGroup<dim> &group)
{
  const Number inner = inner_radii(group);
  dealii::AlignedVector<Values> &mean = Base::open_mean_;
  mean.fill(Values());
  open_sum_.fill(Number(0.));
  std::array<double, dim == 1 ? 1 : dim - 1> distance{};
  for (unsigned int part = 0; part < n_fine; ++part)
    for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    {
      const unsigned int at = Base::coarse_point(part, q, distance);
      const Number open =
        openings_->opening[part][q] *
        relative_radius(inner, layout_.n, at % layout_.n, distance[0]);
      const Values &flux = fine_flux_[part][q];
      // The first one that is open is taken as it is: equal fluxes have just
      // that mean, to the last bit.
      const Number is_first =
        select_less(Number(0.), open_sum_[at], Number(0.), Number(1.));
      open_sum_[at] += open;
      const Number share =
        select_less(Number(0.), open, Number(open / open_sum_[at]), Number(0.));
      for (unsigned int c = 0; c < nc; ++c)
        mean[at][c] =
          select_less(Number(0.),
                      is_first,
                      flux[c],
                      Number(mean[at][c] + (flux[c] - mean[at][c]) * share));
    }
  Base::take_in_cut_lanes(coarse_flux_);
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class FiniteVolumeHanging<dim, Gas, Real>
CONTRECOUP_FOR_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
