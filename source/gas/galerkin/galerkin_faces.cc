// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/galerkin/galerkin_faces.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
using dealii::EvaluationFlags::values;


template <int dim, typename Gas, typename Real>
GalerkinFaces<dim, Gas, Real>::GalerkinFaces(
  const Space &space,
  const OperatorContext<dim> &context,
  const Gas &gas)
  : space_(space)
  , layout_(context.layout)
  , scheme_(context.scheme)
  , gas_(gas)
  , boundary_(context.boundary)
  , subcells_(layout_.n)
  , basis_(layout_.n)
  , n_points_(layout_.n_face_points)
  , axes_(n_points_)
  , opposite_(n_points_)
  , flux_(n_points_)
  , line_(layout_.n)
  , fine_radius_(space.radial_exponent(), layout_.n)
  , coarse_radius_(fine_radius_)
{
  for (unsigned int side = 0; side < 2; ++side)
  {
    near_[side].resize(n_points_);
    far_[side].resize(n_points_);
  }
  const dealii::QGauss<1> gauss(layout_.n);
  for (unsigned int k = 0; k < to_gauss_.size(); ++k)
  {
    to_gauss_[k].reinit(layout_.n, layout_.n);
    from_gauss_[k].reinit(layout_.n, layout_.n);
    for (unsigned int i = 0; i < layout_.n; ++i)
    {
      const double x = gauss.point(i)[0];
      const auto values = basis_.values(k == 0 ? x : 0.5 * (x + k - 1.));
      for (unsigned int j = 0; j < layout_.n; ++j)
        to_gauss_[k](i, j) = from_gauss_[k](j, i) = values[j];
    }
  }
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::reinit()
{
  fluxes_.resize(space_.n_values(nc));
  if (space_.is_collocated())
    return;
  interior_ = Evaluation::make(space_.matrix_free(), layout_.n - 1, true);
  exterior_ = Evaluation::make(space_.matrix_free(), layout_.n - 1, false);
  if constexpr (dim > 1)
    measure_areas();
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::measure_areas()
{
  areas_.resize(space_.n_values(dim));
  const auto &faces = space_.faces();
  first_hanging_ = std::find_if(faces.begin(),
                                faces.end(),
                                [](const FaceBatch &batch) {
                                  return batch.kind == FaceBatch::Kind::hanging;
                                }) -
                   faces.begin();
  hanging_areas_.resize((faces.size() - first_hanging_) * n_points_);
  if constexpr (dim > 1)
    for (unsigned int b = first_hanging_; b < faces.size(); ++b)
      measure_hanging_areas(b);
  for (unsigned int b = 0; b < first_hanging_; ++b)
    for (unsigned int side = 0; side < 2; ++side)
    {
      const FaceBatch &batch = faces[b];
      if (!batch.has(side))
        continue;
      const bool is_interior = side == batch.interior;
      dealii::FEFaceEvaluation<dim, -1, 0, dim, Real, Number> evaluation(
        space_.matrix_free(), is_interior);
      evaluation.reinit(batch.evaluation);
      for (unsigned int q = 0; q < evaluation.n_q_points; ++q)
        evaluation.submit_value(
          evaluation.get_normal_vector(q) * Number(is_interior ? 1. : -1.), q);
      evaluation.integrate(values);
      Real *to =
        areas_.data() + std::size_t(batch.record[side]) * dim * n_points_;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int q = 0; q < n_points_; ++q, to += width)
          evaluation
            .begin_dof_values()[d * layout_.n_points +
                                layout_.face_point(batch.face[side], q, 0)]
            .store(to);
    }
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::compute(const unsigned int face_batch,
                                            const BasicStage<Real> &stage)
{
  bind(face_batch, stage);
  const bool is_hanging = batch_->kind == FaceBatch::Kind::hanging;
  if (is_hanging && space_.is_collocated())
    hanging_fluxes();
  else if (is_hanging)
  {
    if constexpr (dim > 1)
      mapped_hanging_fluxes();
  }
  else if (!space_.is_collocated())
    interpolated_fluxes();
  if (!is_hanging && (space_.is_collocated() || any_share_))
    nodal_fluxes();
}


// The faces' leaves lie in few batches, next to one another in the lanes.
template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::prefetch(const unsigned int face_batch,
                                             const Real *state) const
{
  const FaceBatch &faces = space_.faces()[face_batch];
  for (unsigned int side = 0; side < 2; ++side)
    for (unsigned int lane = 0; lane < faces.n_filled; ++lane)
    {
      const unsigned int leaf_batch = faces.leaf[side][lane] / width;
      if (lane > 0 && leaf_batch == faces.leaf[side][lane - 1] / width)
        continue;
      const Real *const batch = state + leaf_batch * layout_.batch_size();
      for (unsigned int q = 0; q < n_points_; ++q)
      {
        const unsigned int point = layout_.face_point(faces.face[side], q, 0);
        for (unsigned int c = 0; c < nc; ++c)
          __builtin_prefetch(batch + layout_.value(c, point), 0, 2);
      }
    }
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::bind(const unsigned int face_batch,
                                         const BasicStage<Real> &stage)
{
  index_ = face_batch;
  batch_ = &space_.faces()[face_batch];
  stage_ = &stage;
  if (!space_.is_collocated() && batch_->kind != FaceBatch::Kind::hanging)
    interior_->reinit(batch_->evaluation);
  share_ = Number(0.);
  for (unsigned int side = 0; side < 2; ++side)
  {
    reader_[side].reinit(batch_->leaf[side].data(), layout_);
    for (unsigned int lane = 0; lane < width; ++lane)
      share_[lane] =
        std::max(share_[lane], stage.sensor[batch_->leaf[side][lane]]);
  }
  // At open ends of distorted leaves an extrapolated polynomial would grow.
  if (!space_.is_collocated() && batch_->kind == FaceBatch::Kind::boundary &&
      boundary_.kind(batch_->boundary_id) == Boundary<dim>::Kind::open)
    share_ = Number(1.);
  any_share_ = scheme_.blending && any_less(Number(0.), share_);
  needs_shear_factor_ = dim > 1 && any_share_ && has_shear_factor(scheme_.flux);
}


template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Values
GalerkinFaces<dim, Gas, Real>::conserved(const unsigned int side,
                                         const unsigned int point) const
{
  Values u;
  for (unsigned int c = 0; c < nc; ++c)
    u[c] = reader_[side].read(stage_->in + layout_.value(c, point));
  return u;
}


template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Values
GalerkinFaces<dim, Gas, Real>::along_axes(const unsigned int q,
                                          const Values &values) const
{
  if (!space_.is_collocated())
    return axes_[q].to(values);
  Values result;
  for (unsigned int c = 0; c < nc; ++c)
    result[c] = values[component(c)];
  return result;
}


template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Values
GalerkinFaces<dim, Gas, Real>::from_axes(const unsigned int q,
                                         const Values &values) const
{
  if (!space_.is_collocated())
    return axes_[q].from(values);
  Values result;
  for (unsigned int c = 0; c < nc; ++c)
    result[component(c)] = values[c];
  return result;
}


template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Values
GalerkinFaces<dim, Gas, Real>::outflow(const unsigned int side,
                                       const unsigned int q) const
{
  Values flux = flux_[q];
  flux[C::momentum] -= reference_pressure_[side];
  if (side == 1)
    for (Number &value : flux)
      value = -value;
  return from_axes(q, flux);
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::interpolated_fluxes()
{
  const bool is_boundary = batch_->kind == FaceBatch::Kind::boundary;
  if (!is_boundary)
    exterior_->reinit(batch_->evaluation);
  for (unsigned int q = 0; q < n_points_; ++q)
    axes_[q] = FaceAxes<dim, Number>(interior_->access().get_normal_vector(q));
  for (unsigned int side = 0; side < 2; ++side)
    if (batch_->has(side))
      interpolate(side);
  const unsigned int inside = batch_->interior;
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    if (is_boundary)
      near_[1 - inside][q] = beyond_boundary(q, near_[inside][q], false);
    flux_[q] = flux(near_[0][q], near_[1][q]);
  }
  for (unsigned int side = 0; side < 2; ++side)
    if (batch_->has(side))
      integrate(side);
}


// Differences are interpolated, so that equal values stay what they are, to
// the last bit.
template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::interpolate(const unsigned int side)
{
  Evaluation &phi = evaluation(side);
  reference_pressure_[side] =
    to_primitive<dim>(gas_, conserved(side, 0))[C::pressure];
  const unsigned int face = batch_->face[side];
  const Values base = conserved(side, layout_.face_point(face, 0, 0));
  Number *const dofs = phi.access().begin_dof_values();
  std::fill(dofs, dofs + nc * layout_.n_points, Number(0.));
  Values mean = base;
  for (unsigned int q = 1; q < n_points_; ++q)
  {
    const unsigned int point = layout_.face_point(face, q, 0);
    const Values u = conserved(side, point);
    for (unsigned int c = 0; c < nc; ++c)
    {
      dofs[c * layout_.n_points + point] = u[c] - base[c];
      mean[c] += (u[c] - base[c]) * (1. / n_points_);
    }
  }
  phi.evaluate(values);
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const auto difference = phi.access().get_value(q);
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = base[c] + difference[c];
    near_[side][q] = along_axes(q, admissible_primitive(u, mean));
  }
}


template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Values
GalerkinFaces<dim, Gas, Real>::admissible_primitive(Values u,
                                                    const Values &mean) const
{
  const Number one(1.);
  const Number good = is_admissible<dim>(gas_, u);
  if (any_less(good, one))
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = select_less(good, one, mean[c], u[c]);
  return to_primitive<dim>(gas_, u);
}


template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Values
GalerkinFaces<dim, Gas, Real>::flux(const Values &left,
                                    const Values &right) const
{
  return to_array<dim, Gas>(numerical_flux(scheme_.flux,
                                           to_face_state<dim>(gas_, left),
                                           to_face_state<dim>(gas_, right),
                                           Number(1.)));
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::integrate(const unsigned int side)
{
  Evaluation &phi = evaluation(side);
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const Values flux = outflow(side, q);
    dealii::Tensor<1, nc, Number> value;
    for (unsigned int c = 0; c < nc; ++c)
      value[c] = flux[c];
    phi.access().submit_value(value, q);
  }
  phi.integrate(values);
  Real *to = record(side);
  for (unsigned int c = 0; c < nc; ++c)
    for (unsigned int q = 0; q < n_points_; ++q, to += width)
      phi.access()
        .begin_dof_values()[c * layout_.n_points +
                            layout_.face_point(batch_->face[side], q, 0)]
        .store(to);
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class GalerkinFaces<dim, Gas, Real>
CONTRECOUP_FOR_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
