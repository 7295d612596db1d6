// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/kernel/galerkin_hanging.h>
#include <contrecoup/gas/octree/radial_nodes.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
GalerkinHanging<dim, Gas, Real>::GalerkinHanging(const LeafLayout &layout,
                                                 const Scheme &scheme,
                                                 const Gas &gas)
  : layout_(layout)
  , scheme_(scheme)
  , gas_(gas)
  , basis_(layout.n)
  , coarse_(layout.n_face_points)
  , mortar_(layout.n_face_points)
  , coarse_flux_(layout.n_face_points)
{
  for (unsigned int i = 0; i < layout.n; ++i)
    subcell_begin_.push_back(
      i == 0 ? 0. : subcell_begin_.back() + basis_.weights()[i - 1]);
  for (unsigned int part = 0; part < n_fine; ++part)
  {
    fine_[part].resize(layout.n_face_points);
    fine_flux_[part].resize(layout.n_face_points);
  }
}


template <int dim, typename Gas, typename Real>
typename GalerkinHanging<dim, Gas, Real>::Values
GalerkinHanging<dim, Gas, Real>::gather(const Real *state,
                                        const unsigned int *offsets,
                                        const unsigned int point) const
{
  Values u;
  for (unsigned int c = 0; c < nc; ++c)
    u[c].gather(state + layout_.value(c, point), offsets);
  return u;
}


template <int dim, typename Gas, typename Real>
unsigned int
GalerkinHanging<dim, Gas, Real>::fine_point(const HangingGroup<dim> &group,
                                            const unsigned int point) const
{
  if (dim == 1)
    return 0;
  return matched_face_point(group.match.orientation,
                            point % layout_.n,
                            dim == 3 ? point / layout_.n : 0,
                            layout_.n);
}


template <int dim, typename Gas, typename Real>
void GalerkinHanging<dim, Gas, Real>::compute(const HangingGroup<dim> &group,
                                              const BasicStage<Real> &stage,
                                              HangingData<dim, Real> &hanging)
{
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
  {
    coarse_[q] = gather(stage.in,
                        group.coarse_offset.data(),
                        layout_.face_point(group.coarse_face, q, 0));
    for (unsigned int part = 0; part < n_fine; ++part)
      fine_[part][q] =
        gather(stage.in,
               group.fine_offset[part].data(),
               layout_.face_point(group.match.face, fine_point(group, q), 0));
  }
  for (unsigned int part = 0; part < n_fine; ++part)
  {
    mortar_.fill(coarse_[0]);
    apply(
      [this](const unsigned int half) -> const auto & {
        return basis_.to_child(half);
      },
      part,
      coarse_[0],
      coarse_,
      mortar_);
    restore_positivity();
    part_fluxes(group, part);
  }
  const Values base = fine_flux_[0][0];
  coarse_flux_.fill(base);
  for (unsigned int part = 0; part < n_fine; ++part)
    apply(
      [this](const unsigned int half) -> const auto & {
        return basis_.from_child(half);
      },
      part,
      base,
      fine_flux_[part],
      coarse_flux_);
  if (group.is_radial)
    conserve_radially(group, base);
  store(group, hanging);
}


// Along the radius the nodes' areas grow. What the projection, made for equal
// ones, leaves of the difference between both sides' sums is spread evenly;
// it vanishes with equal fluxes.
template <int dim, typename Gas, typename Real>
void GalerkinHanging<dim, Gas, Real>::conserve_radially(
  const HangingGroup<dim> &group,
  const Values &base)
{
  const unsigned int n = layout_.n;
  Number inner;
  for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
    inner[lane] = group.inner_radius[lane];
  // In units of the coarse radial edge and of the area at its middle, which
  // holds for infinite radii too.
  const auto area = [&](const unsigned int i,
                        const Number &begin,
                        const double extent) -> Number {
    const Number from = begin + extent * subcell_begin_[i];
    const Number to = from + extent * basis_.weights()[i];
    const Number place = select_less(inner + begin,
                                     Number(extent * least_collocated_radius),
                                     Number((from + to) * 0.5),
                                     begin + extent * basis_.nodes()[i]);
    return (Number(1.) + (place - 0.5) / (inner + 0.5)) *
           (basis_.weights()[i] * extent);
  };
  Values missing;
  missing.fill(Number(0.));
  for (unsigned int q = 0; q < n; ++q)
  {
    const Number coarse = area(q, Number(0.), 1.);
    for (unsigned int c = 0; c < nc; ++c)
      missing[c] -= (coarse_flux_[q][c] - base[c]) * coarse;
    for (unsigned int part = 0; part < n_fine; ++part)
    {
      const Number fine = area(q, Number(0.5 * part), 0.5);
      for (unsigned int c = 0; c < nc; ++c)
        missing[c] += (fine_flux_[part][q][c] - base[c]) * fine;
    }
  }
  // All areas together make one.
  for (unsigned int q = 0; q < n; ++q)
    for (unsigned int c = 0; c < nc; ++c)
      coarse_flux_[q][c] += missing[c];
}


template <int dim, typename Gas, typename Real>
template <typename Matrices>
void GalerkinHanging<dim, Gas, Real>::apply(const Matrices &matrices,
                                            const unsigned int part,
                                            const Values &base,
                                            const Trace &from,
                                            Trace &to) const
{
  const unsigned int n = layout_.n;
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    for (unsigned int p = 0; p < layout_.n_face_points; ++p)
    {
      double factor = 1.;
      if (dim > 1)
        factor *= matrices(part % 2)(q % n, p % n);
      if (dim > 2)
        factor *= matrices(part / 2)(q / n, p / n);
      for (unsigned int c = 0; c < nc; ++c)
        to[q][c] += (from[p][c] - base[c]) * factor;
    }
}


template <int dim, typename Gas, typename Real>
void GalerkinHanging<dim, Gas, Real>::restore_positivity()
{
  const Number one(1.);
  Number good(1.);
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    good = std::min(good, is_admissible<dim>(gas_, mortar_[q]));
  if (!any_less(good, one))
    return;
  // An interpolated trace that leaves the admissible set is replaced by
  // its mean over the mortar, a convex combination if the set holds it,
  // else by the coarse node's own value.
  Values mean;
  mean.fill(Number(0.));
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    for (unsigned int c = 0; c < nc; ++c)
      mean[c] += mortar_[q][c] * (1. / layout_.n_face_points);
  const Number mean_is_good = is_admissible<dim>(gas_, mean);
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    for (unsigned int c = 0; c < nc; ++c)
      mortar_[q][c] =
        select_less(good,
                    one,
                    select_less(mean_is_good, one, coarse_[q][c], mean[c]),
                    mortar_[q][c]);
}


template <int dim, typename Gas, typename Real>
void GalerkinHanging<dim, Gas, Real>::part_fluxes(
  const HangingGroup<dim> &group,
  const unsigned int part)
{
  const unsigned int direction = group.coarse_face / 2;
  const bool coarse_is_left = group.coarse_face % 2;
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
  {
    const Values coarse = to_primitive<dim>(gas_, mortar_[q]);
    const Values fine = to_primitive<dim>(gas_, fine_[part][q]);
    Values left, right;
    for (unsigned int c = 0; c < nc; ++c)
    {
      const unsigned int from = rotated_component<dim>(c, direction);
      left[c] = coarse_is_left ? coarse[from] : fine[from];
      right[c] = coarse_is_left ? fine[from] : coarse[from];
    }
    const Values flux =
      to_array<dim, Gas>(numerical_flux(scheme_.flux,
                                        to_face_state<dim>(gas_, left),
                                        to_face_state<dim>(gas_, right),
                                        Number(1.)));
    for (unsigned int c = 0; c < nc; ++c)
      fine_flux_[part][q][rotated_component<dim>(c, direction)] = flux[c];
  }
}


template <int dim, typename Gas, typename Real>
void GalerkinHanging<dim, Gas, Real>::store(
  const HangingGroup<dim> &group,
  HangingData<dim, Real> &hanging) const
{
  for (unsigned int lane = 0; lane < group.n_filled; ++lane)
    for (unsigned int c = 0; c < nc; ++c)
      for (unsigned int q = 0; q < layout_.n_face_points; ++q)
      {
        hanging.flux(group.face[lane], 0, c)[q] = coarse_flux_[q][c][lane];
        for (unsigned int part = 0; part < n_fine; ++part)
          hanging.flux(group.face[lane], 1 + part, c)[fine_point(group, q)] =
            fine_flux_[part][q][c][lane];
      }
}


template class GalerkinHanging<1, IdealGas>;
template class GalerkinHanging<2, IdealGas>;
template class GalerkinHanging<3, IdealGas>;
template class GalerkinHanging<3, IdealGas, float>;
template class GalerkinHanging<1, MieGrueneisen>;
template class GalerkinHanging<2, MieGrueneisen>;
template class GalerkinHanging<3, MieGrueneisen>;
template class GalerkinHanging<3, MieGrueneisen, float>;
} // namespace contrecoup::gas
