// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/mapped/mapped_leaf_kernel.h>
#include <contrecoup/gas/stage/kernel_instances.h>
#include <contrecoup/numerics/scheme/shear_factor.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
MappedLeafKernel<dim, Gas, Real>::MappedLeafKernel(
  const OperatorContext<dim> &context,
  const Gas &gas,
  const Metric &metric)
  : Base(context, gas, std::vector<double>())
  , leaf_metric_(metric)
  , beyond_(2 * dim * n_beyond * layout_.n_face_points)
{}


template <int dim, typename Gas, typename Real>
void MappedLeafKernel<dim, Gas, Real>::fill_beyond(
  const Number *primitive,
  const HangingData<dim, Real> &hanging)
{
  primitive_ = primitive;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    fill_neighbors(face);
  wall_.fill(Number(0.));
  for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
       ++s)
    if (s->kind == SpecialFace::Kind::boundary)
      fill_boundary_lane(*s);
    else
      fill_hanging_lane(*s, hanging);
}


template <int dim, typename Gas, typename Real>
void MappedLeafKernel<dim, Gas, Real>::fill_hanging_lane(
  const SpecialFace &special,
  const HangingData<dim, Real> &hanging)
{
  for (unsigned int c = 0; c < nc; ++c)
  {
    const Real *halo = hanging.halo(special.index, Base::slot_of(special), c);
    for (unsigned int line = 0; line < layout_.n_face_points; ++line)
      for (unsigned int depth = 0; depth < n_beyond; ++depth)
        beyond(special.face, line, depth)[c][special.lane] = halo[line];
  }
}


template <int dim, typename Gas, typename Real>
void MappedLeafKernel<dim, Gas, Real>::fill_neighbors(const unsigned int face)
{
  const unsigned int n = layout_.n;
  const auto &neighbors = mesh_.neighbors(batch_, face);
  const auto &matches = mesh_.matches(batch_, face);
  std::array<unsigned int, Base::width> offsets;
  for (unsigned int line = 0; line < layout_.n_face_points; ++line)
    for (unsigned int depth = 0; depth < n_beyond; ++depth)
    {
      for (unsigned int lane = 0; lane < Base::width; ++lane)
      {
        const unsigned int q =
          matched_face_point(matches[lane].orientation, line % n, line / n, n);
        offsets[lane] =
          layout_.offset(neighbors[lane]) +
          layout_.value(
            0,
            layout_.face_point(matches[lane].face, q, std::min(depth, n - 1)));
      }
      Values u;
      for (unsigned int c = 0; c < nc; ++c)
        u[c].gather(in_ + layout_.value(c, 0), offsets.data());
      beyond(face, line, depth) = to_primitive<dim>(gas_, u);
    }
}


template <int dim, typename Gas, typename Real>
GasState<dim>
MappedLeafKernel<dim, Gas, Real>::primitive_lane(const unsigned int point,
                                                 const unsigned int lane) const
{
  const auto value = [&](const unsigned int c) {
    return primitive_[c * layout_.n_points + point][lane];
  };
  GasState<dim> state;
  state.density = value(C::density);
  for (unsigned int d = 0; d < dim; ++d)
    state.velocity[d] = value(C::velocity + d);
  state.pressure = value(C::pressure);
  if constexpr (Gas::has_products)
    state.products = value(C::products);
  return state;
}


template <int dim, typename Gas, typename Real>
void MappedLeafKernel<dim, Gas, Real>::fill_boundary_lane(
  const SpecialFace &special)
{
  const unsigned int lane = special.lane;
  const unsigned int layer = special.face % 2 ? layout_.n : 0;
  // A wall mirrors layer by layer; other boundaries repeat the first.
  const bool wall = is_wall(special);
  wall_[special.face][lane] = wall;
  for (unsigned int line = 0; line < layout_.n_face_points; ++line)
  {
    const Vector &area = leaf_metric_.area(special.face / 2, layer, line);
    const Vector center =
      leaf_metric_.face_center(special.face / 2, layer, line);
    dealii::Tensor<1, dim> normal;
    dealii::Point<dim> place;
    for (unsigned int d = 0; d < dim; ++d)
    {
      normal[d] = special.face % 2 ? area[d][lane] : -area[d][lane];
      place[d] = center[d][lane];
    }
    normal /= normal.norm();
    for (unsigned int depth = 0; depth < n_beyond; ++depth)
    {
      const unsigned int point = layout_.face_point(
        special.face, line, wall ? std::min(depth, layout_.n - 1) : 0);
      const GasState<dim> state = boundary_.outside(
        special.index, primitive_lane(point, lane), normal, place, time_);
      Values &outside = beyond(special.face, line, depth);
      outside[C::density][lane] = state.density;
      for (unsigned int d = 0; d < dim; ++d)
        outside[C::velocity + d][lane] = state.velocity[d];
      outside[C::pressure][lane] = state.pressure;
      if constexpr (Gas::has_products)
        outside[C::products][lane] = state.products;
    }
  }
}


// The limiters work on velocity components along the axes, so that the two
// traces at a slanted wall are no exact mirror images by themselves; what
// would leak through it is kept in by mirroring the inner one.
template <int dim, typename Gas, typename Real>
void MappedLeafKernel<dim, Gas, Real>::mirror_at_walls(
  const unsigned int direction,
  const unsigned int layer,
  Values &left,
  Values &right) const
{
  if (layer != 0 && layer != layout_.n)
    return;
  const Number &wall = wall_[2 * direction + (layer == 0 ? 0 : 1)];
  if (!any_less(Number(0.), wall))
    return;
  const Values &inside = layer == 0 ? right : left;
  Values &outside = layer == 0 ? left : right;
  for (unsigned int c = 0; c < nc; ++c)
    outside[c] = select_less(
      Number(0.), wall, c == C::velocity ? -inside[c] : inside[c], outside[c]);
}


template <int dim, typename Gas, typename Real>
const typename MappedLeafKernel<dim, Gas, Real>::Number &
MappedLeafKernel<dim, Gas, Real>::velocity(const unsigned int direction,
                                           const unsigned int line,
                                           const int i,
                                           const unsigned int component) const
{
  const int n = layout_.n;
  if (i < 0)
    return beyond(2 * direction, line, 0)[C::velocity + component];
  if (i >= n)
    return beyond(2 * direction + 1, line, 0)[C::velocity + component];
  return primitive_[(C::velocity + component) * layout_.n_points +
                    layout_.face_point(2 * direction, line, i)];
}


// The most negative velocity difference along the face, of the cells on both
// sides of it and their neighbours within their leaves.
template <int dim, typename Gas, typename Real>
typename MappedLeafKernel<dim, Gas, Real>::Number
MappedLeafKernel<dim, Gas, Real>::compression(const unsigned int direction,
                                              const unsigned int layer,
                                              const unsigned int line) const
{
  Number smallest(0.);
  unsigned int stride = 1;
  for (unsigned int along = 0; along < dim; ++along)
  {
    if (along == direction)
      continue;
    const Vector tangent = leaf_metric_.tangent(direction, layer, line, along);
    const unsigned int index = (line / stride) % layout_.n;
    for (int i = int(layer) - 1; i <= int(layer); ++i)
    {
      const auto difference = [&](const unsigned int a, const unsigned int b) {
        Number result(0.);
        for (unsigned int d = 0; d < dim; ++d)
          result +=
            (velocity(direction, b, i, d) - velocity(direction, a, i, d)) *
            tangent[d];
        return result;
      };
      if (index > 0)
        smallest = std::min(smallest, difference(line - stride, line));
      if (index + 1 < layout_.n)
        smallest = std::min(smallest, difference(line, line + stride));
    }
    stride *= layout_.n;
  }
  return smallest;
}


template <int dim, typename Gas, typename Real>
typename MappedLeafKernel<dim, Gas, Real>::Values
MappedLeafKernel<dim, Gas, Real>::face_flux(const unsigned int direction,
                                            const unsigned int layer,
                                            const unsigned int line,
                                            const FaceFrame<dim, Number> &frame,
                                            const std::array<Values, 2> &traces,
                                            const std::array<Values, 2> &points,
                                            const Number &inner_shock) const
{
  Values left = in_frame(frame, traces[0]);
  Values right = in_frame(frame, traces[1]);
  mirror_at_walls(direction, layer, left, right);
  auto left_state = to_face_state<dim>(gas_, left);
  auto right_state = to_face_state<dim>(gas_, right);
  if (Base::burn_ != nullptr)
    Base::apply_burn_pressure(layer, left_state, right_state);
  const bool is_inside = layer > 0 && layer < layout_.n;
  Number factor(1.);
  if (Base::needs_shear_factor())
  {
    Number shock = inner_shock;
    if (!is_inside)
      shock = std::max(sensor_,
                       neighbor_sensor_[2 * direction + (layer == 0 ? 0 : 1)]);
    factor =
      shear_factor(shock,
                   std::max(left_state.sound_speed, right_state.sound_speed),
                   Number(in_frame(frame, points[1])[C::velocity] -
                          in_frame(frame, points[0])[C::velocity]),
                   compression(direction, layer, line));
  }
  Values flux = to_array<dim, Gas>(
    numerical_flux(scheme_.flux, left_state, right_state, factor));
  // Faces to other leaves keep the flux that the neighbour computes too.
  if (Base::any_leaving(direction) && is_inside && Base::burn_ == nullptr)
    Base::widen_open_flux(
      direction, in_frame(frame, points[0]), in_frame(frame, points[1]), flux);
  return flux;
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class MappedLeafKernel<dim, Gas, Real>
CONTRECOUP_FOR_MAPPED_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
