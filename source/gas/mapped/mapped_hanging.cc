// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/mapped/mapped_hanging.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
MappedHanging<dim, Gas, Real>::MappedHanging(
  const OperatorContext<dim> &context,
  const Gas &gas,
  PrimitiveField<dim, Gas, Real> &primitives)
  : Base(context, gas, primitives)
{}


template <int dim, typename Gas, typename Real>
void MappedHanging<dim, Gas, Real>::reinit(
  const LeafMesh<dim> &mesh,
  const std::vector<HangingGroup<dim>> &groups)
{
  areas_.resize(groups.size() * n_fine * layout_.n_face_points);
  for (unsigned int g = 0; g < groups.size(); ++g)
    measure(mesh, groups[g], g);
}


template <int dim, typename Gas, typename Real>
void MappedHanging<dim, Gas, Real>::measure(const LeafMesh<dim> &mesh,
                                            const HangingGroup<dim> &group,
                                            const unsigned int index)
{
  const unsigned int n = layout_.n, n_points = layout_.n_face_points;
  for (unsigned int part = 0; part < n_fine; ++part)
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const unsigned int own = Base::fine_point(group, q);
      for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
      {
        const auto outward =
          outward_area<dim>(mesh.stored_cell(group.fine_leaf[part][lane]),
                            group.match.face,
                            (own % n + 0.5) / n,
                            (own / n + 0.5) / n);
        for (unsigned int d = 0; d < dim; ++d)
          area(index, part, q)[d][lane] = -outward[d] / n_points;
      }
    }
}


template <int dim, typename Gas, typename Real>
void MappedHanging<dim, Gas, Real>::compute(const unsigned int index,
                                            const HangingGroup<dim> &group,
                                            const BasicStage<Real> &stage,
                                            HangingData<dim, Real> &hanging)
{
  Base::prepare(group, stage);
  for (Values &sum : coarse_flux_)
    sum.fill(Number(0.));
  for (unsigned int part = 0; part < n_fine; ++part)
    part_fluxes(index, group, part);
  Base::store(group, hanging);
}


template <int dim, typename Gas, typename Real>
void MappedHanging<dim, Gas, Real>::part_fluxes(const unsigned int index,
                                                const HangingGroup<dim> &group,
                                                const unsigned int part)
{
  const double coarse_sign = group.coarse_face % 2 ? 1. : -1.;
  const double fine_sign = group.match.face % 2 ? -1. : 1.;
  std::array<double, dim - 1> distance;
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
  {
    const unsigned int at = Base::coarse_point(part, q, distance);
    const FaceAxes<dim, Number> axes(area(index, part, q));
    Values inside, outside;
    Base::reconstruct(part, q, inside, outside);
    const Values flux =
      flux_between(part, q, axes.to(inside), axes.to(outside));
    const Values coarse = integral(
      axes, flux, exerted_pressure(coarse_[0][at], Base::coarse_progress_[at]));
    const Values fine = integral(
      axes,
      flux,
      exerted_pressure(fine_[part][0][q], Base::fine_progress_[part][q]));
    for (unsigned int c = 0; c < nc; ++c)
    {
      coarse_flux_[at][c] += coarse[c] * coarse_sign;
      fine_flux_[part][q][c] = fine[c] * fine_sign;
    }
  }
}


template <int dim, typename Gas, typename Real>
typename MappedHanging<dim, Gas, Real>::Values
MappedHanging<dim, Gas, Real>::flux_between(const unsigned int part,
                                            const unsigned int q,
                                            const Values &inside,
                                            const Values &outside) const
{
  auto coarse = to_face_state<dim>(gas_, inside);
  auto fine = to_face_state<dim>(gas_, outside);
  Base::apply_burn_pressure(part, q, coarse, fine);
  return to_array<dim, Gas>(
    numerical_flux(scheme_.flux, coarse, fine, Number(1.)));
}


template <int dim, typename Gas, typename Real>
typename MappedHanging<dim, Gas, Real>::Values
MappedHanging<dim, Gas, Real>::integral(const FaceAxes<dim, Number> &axes,
                                        Values flux,
                                        const Number &own)
{
  flux[C::momentum] -= own;
  Values result = axes.from(flux);
  for (Number &value : result)
    value *= axes.area;
  return result;
}


template <int dim, typename Gas, typename Real>
typename MappedHanging<dim, Gas, Real>::Number
MappedHanging<dim, Gas, Real>::exerted_pressure(const Values &state,
                                                const Number &progress) const
{
  if (burn_ == nullptr)
    return state[C::pressure];
  return burn_->pressure(state[C::pressure],
                         burn_->fraction(progress, state[C::density]));
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class MappedHanging<dim, Gas, Real>
CONTRECOUP_FOR_MAPPED_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
