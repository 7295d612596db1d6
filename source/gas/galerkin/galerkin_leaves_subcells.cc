// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/deal_ii/releases.h>
#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/galerkin/galerkin_leaves.h>
#include <contrecoup/gas/stage/kernel_instances.h>
#include <contrecoup/numerics/scheme/shear_factor.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::add_subcell_terms(const Real *state)
{
  if (!space_.is_collocated())
    set_subcell_areas();
  find_neighbors();
  subcell_rate_.fill(Number(0.));
  for (unsigned int direction = 0; direction < dim; ++direction)
  {
    for (unsigned int line = 0; line < layout_.n_face_points; ++line)
      subcell_line(direction, line, state);
    if (direction == 0 && radial_.any_near_axis())
      for (unsigned int i = 0; i < nc * n_points_; ++i)
        rate_[i] +=
          radial_.near_axis() * subcell_rate_[i] / volume_[i % n_points_];
  }
  if (!any_blending_)
    return;
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const Number inverse = Number(1.) / volume_[q];
    for (unsigned int c = 0; c < nc; ++c)
    {
      Number &rate = rate_[c * n_points_ + q];
      rate += blending_ * (subcell_rate_[c * n_points_ + q] * inverse - rate);
    }
  }
}


// The weak form takes the part along one direction of what a uniform flux adds
// to a node out of one subcell's face and into the next.
template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::set_subcell_areas()
{
  metric_->reinit(index_);
  Number *const gradients = metric_->access().begin_gradients();
  for (unsigned int direction = 0; direction < dim; ++direction)
  {
    for (unsigned int q = 0; q < n_points_; ++q)
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int d = 0; d < dim; ++d)
          gradients[gradient_index<dim>(k, d, q, n_points_)] =
            d == direction
              ? Number(metric_->access().inverse_jacobian(q)[k][d] *
                       metric_->access().JxW(q))
              : Number(0.);
    metric_->integrate(dealii::EvaluationFlags::gradients);
    std::copy_n(metric_->access().begin_dof_values(),
                dim * n_points_,
                area_[direction].data());
    const unsigned int stride = layout_.stride(direction);
    for (unsigned int i = 0; i < dim * n_points_; ++i)
    {
      area_[direction][i] = -area_[direction][i];
      if ((i / stride) % layout_.n > 0)
        area_[direction][i] += area_[direction][i - stride];
    }
  }
}


template <int dim, typename Gas, typename Real>
FaceAxes<dim, typename GalerkinLeaves<dim, Gas, Real>::Number>
GalerkinLeaves<dim, Gas, Real>::subcell_face(const unsigned int direction,
                                             const unsigned int line,
                                             const unsigned int f) const
{
  const unsigned int point = layout_.face_point(2 * direction, line, f - 1);
  if (direction == 0 && !radial_.is_plane())
    return {direction, radial_area(line, f)};
  if (space_.is_collocated())
    return {direction,
            volume_[point] / (extents_[direction] * subcells_.weight[f - 1])};
  Vector area;
  for (unsigned int d = 0; d < dim; ++d)
    area[d] = area_[direction][d * n_points_ + point];
  return FaceAxes<dim, Number>(area);
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::subcell_line(const unsigned int direction,
                                                  const unsigned int line,
                                                  const Real *state)
{
  const unsigned int n = layout_.n, n_face_points = layout_.n_face_points;
  load_line(direction, line, state);
  set_slopes();
  for (unsigned int c = 0; c < nc; ++c)
  {
    const auto outflow = [&](const unsigned int face) {
      return outflow_[(face * nc + c) * n_face_points + line];
    };
    flux_[0][c] = -outflow(2 * direction);
    flux_[n][c] = outflow(2 * direction + 1);
  }
  for (unsigned int f = 1; f < n; ++f)
    flux_[f] = subcell_flux(direction, line, f);
  for (unsigned int i = 0; i < n; ++i)
  {
    const unsigned int point = layout_.face_point(2 * direction, line, i);
    for (unsigned int c = 0; c < nc; ++c)
      subcell_rate_[c * n_points_ + point] += flux_[i][c] - flux_[i + 1][c];
  }
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::load_line(const unsigned int direction,
                                               const unsigned int line,
                                               const Real *state)
{
  const unsigned int n = layout_.n;
  for (unsigned int i = 0; i < n; ++i)
    line_[i + 1] = node(primitive_, layout_.face_point(2 * direction, line, i));
  line_[0] = beyond(2 * direction, line, state);
  line_[n + 1] = beyond(2 * direction + 1, line, state);
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::find_neighbors()
{
  for (unsigned int face = 0; face < 2 * dim; ++face)
  {
    FaceNeighbors &beside = beside_[face];
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      const unsigned int leaf = batch_->leaf[lane];
      beside.leaf[lane] = neighbor(face, lane);
      beside.match[lane] = mesh_.matches(leaf / width, face)[leaf % width];
    }
    beside.reader.reinit(beside.leaf.data(), layout_);
    beside.is_absent = 0.;
    beside.sign = 1.;
    beside.any_absent = false;
  }
  for (unsigned int lane = 0; lane < batch_->n_filled; ++lane)
  {
    const unsigned int leaf = batch_->leaf[lane], batch = leaf / width;
    for (auto s = mesh_.special_begin(batch); s != mesh_.special_end(batch);
         ++s)
    {
      if (s->lane != leaf % width)
        continue;
      beside_[s->face].is_absent[lane] = 1.;
      beside_[s->face].any_absent = true;
      if (space_.is_collocated() && is_boundary(*s, Boundary<dim>::Kind::wall))
        beside_[s->face].sign[lane] = -1.;
    }
  }
}


// The neighbour's node next to the face; a wall mirrors on boxes, and at other
// ends without an equal neighbour the last subcell has no slope.
template <int dim, typename Gas, typename Real>
typename GalerkinLeaves<dim, Gas, Real>::Values
GalerkinLeaves<dim, Gas, Real>::beyond(const unsigned int face,
                                       const unsigned int line,
                                       const Real *state) const
{
  const unsigned int n = layout_.n;
  const FaceNeighbors &beside = beside_[face];
  Values u;
  if (space_.is_collocated())
  {
    const unsigned int point = layout_.face_point(face ^ 1U, line, 0);
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = beside.reader.read(state + layout_.value(c, point));
  }
  else
  {
    std::array<unsigned int, width> offset;
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      const FaceMatch match = beside.match[lane];
      const unsigned int q =
        matched_face_point(match.orientation, line % n, line / n, n);
      offset[lane] = layout_.offset(beside.leaf[lane]) +
                     layout_.value(0, layout_.face_point(match.face, q, 0));
    }
    for (unsigned int c = 0; c < nc; ++c)
      u[c].gather(state + layout_.value(c, 0), offset.data());
  }
  Values result = to_primitive<dim>(gas_, u);
  if (!beside.any_absent)
    return result;
  const Values &end = line_[face % 2 ? n : 1];
  for (unsigned int c = 0; c < nc; ++c)
    result[c] = select_less(Number(0.), beside.is_absent, end[c], result[c]);
  result[C::velocity + face / 2] *= beside.sign;
  return result;
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::set_slopes()
{
  for (unsigned int c = 0; c < nc; ++c)
  {
    Number backward =
      (line_[1][c] - line_[0][c]) * subcells_.inverse_distance[0];
    for (unsigned int i = 0; i < layout_.n; ++i)
    {
      const Number forward =
        (line_[i + 2][c] - line_[i + 1][c]) * subcells_.inverse_distance[i + 1];
      slope_[i + 1][c] = limited_slope(
        scheme_.limiter, backward, forward, subcells_.slope_weights[i]);
      backward = forward;
    }
  }
}


template <int dim, typename Gas, typename Real>
typename GalerkinLeaves<dim, Gas, Real>::Values
GalerkinLeaves<dim, Gas, Real>::subcell_flux(const unsigned int direction,
                                             const unsigned int line,
                                             const unsigned int f) const
{
  std::array<Values, 2> trace;
  for (unsigned int side = 0; side < 2; ++side)
  {
    const unsigned int i = f - 1 + side;
    for (unsigned int c = 0; c < nc; ++c)
      trace[side][c] =
        line_[i + 1][c] +
        slope_[i + 1][c] * (subcells_.face[f] - subcells_.center[i]);
    restore_if_inadmissible<dim>(gas_, line_[i + 1], trace[side]);
  }
  const FaceAxes<dim, Number> axes = subcell_face(direction, line, f);
  const auto left = to_face_state<dim>(gas_, axes.to(trace[0]));
  const auto right = to_face_state<dim>(gas_, axes.to(trace[1]));
  Number factor(1.);
  if (dim > 1 && has_shear_factor(scheme_.flux))
  {
    const Values before = axes.to(line_[f]), behind = axes.to(line_[f + 1]);
    factor = shear_factor(
      blending_,
      std::max(left.sound_speed, right.sound_speed),
      Number(behind[C::velocity] - before[C::velocity]),
      std::min(
        compression(direction, layout_.face_point(2 * direction, line, f - 1)),
        compression(direction, layout_.face_point(2 * direction, line, f))));
  }
  Values flux =
    to_array<dim, Gas>(numerical_flux(scheme_.flux, left, right, factor));
  flux[C::momentum] -= reference_pressure_;
  flux = axes.from(flux);
  for (Number &value : flux)
    value *= axes.area;
  return flux;
}


// The most negative velocity difference across other directions between a
// node and its neighbours on the leaf.
template <int dim, typename Gas, typename Real>
typename GalerkinLeaves<dim, Gas, Real>::Number
GalerkinLeaves<dim, Gas, Real>::compression(const unsigned int direction,
                                            const unsigned int point) const
{
  Number smallest(0.);
  for (unsigned int along = 0; along < dim; ++along)
  {
    if (along == direction)
      continue;
    Vector tangent;
    if (!space_.is_collocated())
    {
      tangent = invert(phi_->access().inverse_jacobian(point))[along];
      tangent *= Number(1.) / std::sqrt(tangent * tangent);
    }
    const auto difference = [&](const unsigned int a, const unsigned int b) {
      if (space_.is_collocated())
        return Number(primitive_[(C::velocity + along) * n_points_ + b] -
                      primitive_[(C::velocity + along) * n_points_ + a]);
      Number result(0.);
      for (unsigned int d = 0; d < dim; ++d)
        result += (primitive_[(C::velocity + d) * n_points_ + b] -
                   primitive_[(C::velocity + d) * n_points_ + a]) *
                  tangent[d];
      return result;
    };
    const unsigned int stride = layout_.stride(along);
    const unsigned int index = (point / stride) % layout_.n;
    if (index > 0)
      smallest = std::min(smallest, difference(point - stride, point));
    if (index + 1 < layout_.n)
      smallest = std::min(smallest, difference(point, point + stride));
  }
  return smallest;
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template void GalerkinLeaves<dim, Gas, Real>::add_subcell_terms(const Real *)

CONTRECOUP_FOR_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
