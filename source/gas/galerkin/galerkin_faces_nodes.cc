// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/galerkin/galerkin_faces.h>
#include <contrecoup/gas/stage/kernel_instances.h>
#include <contrecoup/numerics/scheme/shear_factor.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::nodal_fluxes()
{
  if (!space_.is_collocated())
    set_nodal_axes();
  const bool is_boundary = batch_->kind == FaceBatch::Kind::boundary;
  for (unsigned int side = 0; side < 2; ++side)
    if (batch_->has(side))
      load_nodes(side);
  if (is_boundary)
    mirror_nodes();
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    std::array<Values, 2> trace;
    for (unsigned int side = 0; side < 2; ++side)
      trace[side] =
        node_along_axes(q,
                        any_share_ && batch_->has(side) ? subcell_trace(side, q)
                                                        : near_[side][q]);
    if (is_boundary)
    {
      const unsigned int outside = 1 - batch_->interior;
      trace[outside] = beyond_boundary(q, trace[batch_->interior], true);
      near_[outside][q] =
        space_.is_collocated() ? trace[outside] : axes_[q].from(trace[outside]);
    }
    const auto left = to_face_state<dim>(gas_, trace[0]);
    const auto right = to_face_state<dim>(gas_, trace[1]);
    const Number factor =
      needs_shear_factor_
        ? shear_factor_at(q, std::max(left.sound_speed, right.sound_speed))
        : Number(1.);
    flux_[q] =
      to_array<dim, Gas>(numerical_flux(scheme_.flux, left, right, factor));
  }
  if (space_.is_collocated())
    store_flux();
  else
    for (unsigned int side = 0; side < 2; ++side)
      if (batch_->has(side))
        blend_nodal(side);
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::set_nodal_axes()
{
  const Real *from =
    areas_.data() + std::size_t(batch_->record[0]) * dim * n_points_;
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    Vector area;
    for (unsigned int d = 0; d < dim; ++d)
      area[d].load(from + (d * n_points_ + q) * width);
    axes_[q] = FaceAxes<dim, Number>(area);
  }
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::load_nodes(const unsigned int side)
{
  const auto load = [&](const unsigned int q, const unsigned int depth) {
    const unsigned int point = layout_.face_point(
      batch_->face[side], space_.own_point(*batch_, side, q), depth);
    if (!space_.is_collocated())
      return to_primitive<dim>(gas_, conserved(side, point));
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] =
        reader_[side].read(stage_->in + layout_.value(component(c), point));
    return to_primitive<dim>(gas_, u);
  };
  const bool is_open =
    batch_->kind == FaceBatch::Kind::boundary &&
    boundary_.kind(batch_->boundary_id) == Boundary<dim>::Kind::open;
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    near_[side][q] = load(q, 0);
    if (any_share_)
      far_[side][q] = load(q, 1);
    if (is_open)
      opposite_[q] = load(q, layout_.n - 1);
  }
}


// Sets what the limiter sees beyond a boundary: at a wall the mirror image,
// else no slope.
template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::mirror_nodes()
{
  const unsigned int outside = 1 - batch_->interior;
  near_[outside] = near_[batch_->interior];
  if (boundary_.kind(batch_->boundary_id) != Boundary<dim>::Kind::wall)
    return;
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    Values mirrored = node_along_axes(q, near_[outside][q]);
    mirrored[C::velocity] = -mirrored[C::velocity];
    near_[outside][q] =
      space_.is_collocated() ? mirrored : axes_[q].from(mirrored);
  }
}


template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Values
GalerkinFaces<dim, Gas, Real>::subcell_trace(const unsigned int side,
                                             const unsigned int q) const
{
  const Values &own = near_[side][q];
  const unsigned int last = layout_.n - 1;
  const double sign = side == 0 ? 1. : -1.;
  Values trace;
  for (unsigned int c = 0; c < nc; ++c)
  {
    const Number across =
      (near_[1 - side][q][c] - own[c]) * (sign * subcells_.inverse_distance[0]);
    const Number within =
      (own[c] - far_[side][q][c]) * (sign * subcells_.inverse_distance[1]);
    const Number slope =
      side == 0
        ? limited_slope(
            scheme_.limiter, within, across, subcells_.slope_weights[last])
        : limited_slope(
            scheme_.limiter, across, within, subcells_.slope_weights[0]);
    trace[c] = own[c] + slope * (sign * subcells_.center[0]);
  }
  restore_if_inadmissible<dim>(gas_, own, trace);
  for (unsigned int c = 0; c < nc; ++c)
    trace[c] = own[c] + share_ * (trace[c] - own[c]);
  return trace;
}


// Positions of a boundary's nodes on boxes; on mapped leaves the quadrature
// points stand for the nodes.
template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Places
GalerkinFaces<dim, Gas, Real>::node_places(const unsigned int q) const
{
  if (!space_.is_collocated())
    return interior_->access().quadrature_point(
      space_.quadrature_point(*batch_, q));
  const unsigned int point =
    layout_.face_point(batch_->face[batch_->interior], q, 0);
  dealii::Point<dim> reference;
  for (unsigned int d = 0; d < dim; ++d)
    reference[d] = basis_.nodes()[point / layout_.stride(d) % layout_.n];
  Places result;
  for (unsigned int lane = 0; lane < batch_->n_filled; ++lane)
  {
    const auto place =
      leaf_box(space_.mesh(), batch_->leaf[batch_->interior][lane])
        .place(reference);
    for (unsigned int d = 0; d < dim; ++d)
      result[d][lane] = place[d];
  }
  return result;
}


template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Values
GalerkinFaces<dim, Gas, Real>::beyond_boundary(const unsigned int q,
                                               const Values &inside,
                                               const bool is_node) const
{
  using Kind = typename Boundary<dim>::Kind;
  const Kind kind = boundary_.kind(batch_->boundary_id);
  Values outside = inside;
  if (kind == Kind::wall)
  {
    outside[C::velocity] = -inside[C::velocity];
    return outside;
  }
  if (kind == Kind::open)
  {
    // Beyond an open end of a box the gas is that of the leaf's other end:
    // what comes in with the state at the end itself would make a polynomial
    // grow. A jump that leaves is cut off at the end, not at a leaf's
    // distance (with two subcells not wholly, as in finite volumes).
    const Number share = share_ * (layout_.n == 2 ? 0.7 : 1.);
    if (space_.is_collocated())
      for (unsigned int c = 0; c < nc; ++c)
        outside[c] = opposite_[q][c] + share * (inside[c] - opposite_[q][c]);
    return outside;
  }
  return given_state(q, inside, is_node);
}


template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Values
GalerkinFaces<dim, Gas, Real>::given_state(const unsigned int q,
                                           const Values &inside,
                                           const bool is_node) const
{
  const Places places =
    is_node ? node_places(q) : Places(interior_->access().quadrature_point(q));
  Values unit;
  unit.fill(Number(0.));
  unit[C::velocity] = batch_->interior == 0 ? 1. : -1.;
  const Values normals = from_axes(q, unit);
  // Lanes without a face stay as they are inside, which is as good as any.
  Values values = from_axes(q, inside);
  for (unsigned int lane = 0; lane < batch_->n_filled; ++lane)
  {
    GasState<dim> state;
    dealii::Tensor<1, dim> normal;
    dealii::Point<dim> point;
    state.density = values[C::density][lane];
    state.pressure = values[C::pressure][lane];
    for (unsigned int d = 0; d < dim; ++d)
    {
      state.velocity[d] = values[C::velocity + d][lane];
      normal[d] = normals[C::velocity + d][lane];
      point[d] = places[d][lane];
    }
    if constexpr (Gas::has_products)
      state.products = values[C::products][lane];
    state = boundary_.outside(
      batch_->boundary_id, state, normal, point, stage_->time);
    values[C::density][lane] = state.density;
    values[C::pressure][lane] = state.pressure;
    for (unsigned int d = 0; d < dim; ++d)
      values[C::velocity + d][lane] = state.velocity[d];
    if constexpr (Gas::has_products)
      values[C::products][lane] = state.products;
  }
  return along_axes(q, values);
}


template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Number
GalerkinFaces<dim, Gas, Real>::shear_factor_at(const unsigned int q,
                                               const Number &speed) const
{
  Number transverse(0.);
  for (unsigned int side = 0; side < 2; ++side)
    if (batch_->has(side))
      transverse = std::min(transverse, compression(side, q));
  const Number across = node_along_axes(q, near_[1][q])[C::velocity] -
                        node_along_axes(q, near_[0][q])[C::velocity];
  return shear_factor(share_, speed, across, transverse);
}


// The most negative velocity difference along the face between the node and
// its neighbours on its own leaf's face.
template <int dim, typename Gas, typename Real>
typename GalerkinFaces<dim, Gas, Real>::Number
GalerkinFaces<dim, Gas, Real>::compression(const unsigned int side,
                                           const unsigned int q) const
{
  Number smallest(0.);
  unsigned int stride = 1;
  const unsigned int normal = batch_->face[batch_->interior] / 2;
  for (unsigned int along = 0; along < dim; ++along)
  {
    if (along == normal)
      continue;
    const auto difference = [&](const unsigned int a, const unsigned int b) {
      const unsigned int axis = (along + dim - normal) % dim;
      if (space_.is_collocated())
        return near_[side][b][C::velocity + axis] -
               near_[side][a][C::velocity + axis];
      Vector tangent = node_places(b) - node_places(a);
      tangent *= Number(1.) / std::sqrt(tangent * tangent);
      Number result(0.);
      for (unsigned int d = 0; d < dim; ++d)
        result +=
          (near_[side][b][C::velocity + d] - near_[side][a][C::velocity + d]) *
          tangent[d];
      return result;
    };
    const unsigned int index = (q / stride) % layout_.n;
    if (index > 0)
      smallest = std::min(smallest, difference(q - stride, q));
    if (index + 1 < layout_.n)
      smallest = std::min(smallest, difference(q, q + stride));
    stride *= layout_.n;
  }
  return smallest;
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::store_flux()
{
  Real *const to = record(batch_->interior);
  for (unsigned int q = 0; q < n_points_; ++q)
    for (unsigned int c = 0; c < nc; ++c)
      flux_[q][c].store(to + (component(c) * n_points_ + q) * width);
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::blend_nodal(const unsigned int side)
{
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const Values flux = outflow(side, q);
    Real *to = record(side) + space_.own_point(*batch_, side, q) * width;
    for (unsigned int c = 0; c < nc; ++c, to += n_points_ * width)
    {
      Number other;
      other.load(to);
      other += share_ * (flux[c] * axes_[q].area - other);
      other.store(to);
    }
  }
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real)                 \
  template void GalerkinFaces<dim, Gas, Real>::nodal_fluxes(); \
  template void GalerkinFaces<dim, Gas, Real>::store_flux();   \
  template std::array<Lanes<Real>, n_conserved<dim, Gas>>      \
  GalerkinFaces<dim, Gas, Real>::beyond_boundary(              \
    const unsigned int,                                        \
    const std::array<Lanes<Real>, n_conserved<dim, Gas>> &,    \
    const bool) const

CONTRECOUP_FOR_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
