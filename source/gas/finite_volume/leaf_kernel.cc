// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/finite_volume/leaf_kernel.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
LeafKernel<dim, Gas, Real>::LeafKernel(const OperatorContext<dim> &context,
                                       const Gas &gas,
                                       const std::vector<double> &positions)
  : mesh_(context.mesh)
  , layout_(context.layout)
  , scheme_(context.scheme)
  , gas_(gas)
  , boundary_(context.boundary)
  , positions_(positions)
  , line_progress_(layout_.n + 2)
{}


template <int dim, typename Gas, typename Real>
void LeafKernel<dim, Gas, Real>::bind(const unsigned int batch,
                                      const BasicStage<Real> &stage)
{
  batch_ = batch;
  time_ = stage.time;
  in_ = stage.in;
  bounds_velocity_slopes_ = stage.bound_velocity_slopes;
  sensor_.load(stage.sensor + batch * width);
  Number any = sensor_;
  for (unsigned int face = 0; face < 2 * dim; ++face)
  {
    const unsigned int *neighbors = mesh_.neighbors(batch, face);
    neighbors_[face].reinit(neighbors, layout_);
    for (unsigned int lane = 0; lane < width; ++lane)
      neighbor_sensor_[face][lane] = stage.sensor[neighbors[lane]];
    any = std::max(any, neighbor_sensor_[face]);
  }
  needs_shear_factor_ =
    dim > 1 && has_shear_factor(scheme_.flux) && largest_lane(any) > 0.;
  bind_burn(batch, stage);
  find_leaving(any);
}


template <int dim, typename Gas, typename Real>
void LeafKernel<dim, Gas, Real>::bind_burn(const unsigned int batch,
                                           const BasicStage<Real> &stage)
{
  batch_ = batch;
  burn_ = nullptr;
  if (stage.burn == nullptr)
    return;
  bool any = false;
  for (unsigned int lane = 0; lane < width; ++lane)
  {
    any = any || stage.burn->burns[batch * width + lane];
    for (unsigned int face = 0; face < 2 * dim; ++face)
      any = any || stage.burn->burns[mesh_.neighbors(batch, face)[lane]];
  }
  if (any)
    burn_ = stage.burn;
}


template <int dim, typename Gas, typename Real>
typename LeafKernel<dim, Gas, Real>::Number
LeafKernel<dim, Gas, Real>::progress(const unsigned int point,
                                     const double time) const
{
  Number result;
  for (unsigned int lane = 0; lane < width; ++lane)
    result[lane] = burn_->progress(batch_ * width + lane, point, time);
  return result;
}


template <int dim, typename Gas, typename Real>
void LeafKernel<dim, Gas, Real>::fill_progress(const unsigned int direction,
                                               const unsigned int line)
{
  for (unsigned int i = 0; i < layout_.n; ++i)
    line_progress_[i + 1] =
      progress(layout_.face_point(2 * direction, line, i), time_);
  fill_progress_beyond(2 * direction, line);
  fill_progress_beyond(2 * direction + 1, line);
}


template <int dim, typename Gas, typename Real>
void LeafKernel<dim, Gas, Real>::fill_progress_beyond(const unsigned int face,
                                                      const unsigned int line)
{
  const unsigned int n = layout_.n;
  Number &beyond = line_progress_[face % 2 ? n + 1 : 0];
  const auto &matches = mesh_.matches(batch_, face);
  for (unsigned int lane = 0; lane < width; ++lane)
  {
    const unsigned int q =
      dim == 1
        ? 0
        : matched_face_point(matches[lane].orientation, line % n, line / n, n);
    beyond[lane] = burn_->progress(mesh_.neighbors(batch_, face)[lane],
                                   layout_.face_point(matches[lane].face, q, 0),
                                   time_);
  }
  // Walls and open ends show the gas its own image; everything else comes
  // from outside of the charge. Hanging faces bring their own fluxes.
  using Kind = typename Boundary<dim>::Kind;
  for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
       ++s)
    if (s->face == face && s->kind == SpecialFace::Kind::boundary)
    {
      const Kind kind = boundary_.kind(s->index);
      beyond[s->lane] = kind == Kind::wall || kind == Kind::open
                          ? line_progress_[face % 2 ? n : 1][s->lane]
                          : 1.;
    }
}


template <int dim, typename Gas, typename Real>
void LeafKernel<dim, Gas, Real>::find_leaving(const Number &shock)
{
  leaving_.fill(Number(0.));
  any_leaving_.fill(false);
  for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
       ++s)
    if (s->kind == SpecialFace::Kind::boundary &&
        boundary_.kind(s->index) == Boundary<dim>::Kind::open &&
        shock[s->lane] > 0.)
    {
      leaving_[s->face / 2][s->lane] = 1.;
      any_leaving_[s->face / 2] = true;
    }
}


template <int dim, typename Gas, typename Real>
void LeafKernel<dim, Gas, Real>::widen_open_flux(const unsigned int direction,
                                                 const Values &left,
                                                 const Values &right,
                                                 Values &flux) const
{
  const Values wide =
    to_array<dim, Gas>(numerical_flux(RiemannFlux::rusanov,
                                      to_face_state<dim>(gas_, left),
                                      to_face_state<dim>(gas_, right),
                                      Number(1.)));
  for (unsigned int c = 0; c < nc; ++c)
    flux[c] = select_less(Number(0.), leaving_[direction], wide[c], flux[c]);
}


template <int dim, typename Gas, typename Real>
void LeafKernel<dim, Gas, Real>::fill_boundary(const SpecialFace &special,
                                               const unsigned int line,
                                               const Values &inside,
                                               Values &outside) const
{
  const unsigned int direction = special.face / 2;
  const unsigned int lane = special.lane;
  const unsigned int leaf = batch_ * width + lane;
  dealii::Tensor<1, dim> normal;
  normal[direction] = special.face % 2 ? 1. : -1.;

  dealii::Point<dim> point;
  unsigned int q = line;
  for (unsigned int d = 0; d < dim; ++d)
  {
    double position = special.face % 2;
    if (d != direction)
    {
      position = positions_[q % layout_.n];
      q /= layout_.n;
    }
    point[d] =
      mesh_.origins(leaf / double_width)[d][leaf % double_width] +
      mesh_.extents(leaf / double_width)[d][leaf % double_width] * position;
  }

  GasState<dim> state;
  state.density = inside[C::density][lane];
  state.pressure = inside[C::pressure][lane];
  for (unsigned int d = 0; d < dim; ++d)
    state.velocity[(direction + d) % dim] = inside[C::velocity + d][lane];
  if constexpr (Gas::has_products)
    state.products = inside[C::products][lane];
  state = boundary_.outside(special.index, state, normal, point, time_);
  outside[C::density][lane] = state.density;
  outside[C::pressure][lane] = state.pressure;
  for (unsigned int d = 0; d < dim; ++d)
    outside[C::velocity + d][lane] = state.velocity[(direction + d) % dim];
  if constexpr (Gas::has_products)
    outside[C::products][lane] = state.products;
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class LeafKernel<dim, Gas, Real>
CONTRECOUP_FOR_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
