// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lane_math.h>
#include <contrecoup/gas/face_frame.h>
#include <contrecoup/gas/mapped_finite_volume_kernel.h>
#include <contrecoup/gas/velocity_slope.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup::gas
{
namespace
{
  /// Primitive values with the velocity along the axes of @p frame.
  template <int dim, typename Number, std::size_t nc>
  DEAL_II_ALWAYS_INLINE inline std::array<Number, nc>
  in_frame(const FaceFrame<dim, Number> &frame,
           const std::array<Number, nc> &values)
  {
    constexpr unsigned int first = Component<dim>::momentum;
    std::array<Number, nc> result = values;
    for (unsigned int d = 0; d < dim; ++d)
    {
      result[first + d] = values[first] * frame.axes[d][0];
      for (unsigned int e = 1; e < dim; ++e)
        result[first + d] += values[first + e] * frame.axes[d][e];
    }
    return result;
  }
} // namespace


template <int dim, typename Gas>
MappedFiniteVolumeKernel<dim, Gas>::MappedFiniteVolumeKernel(
  const LeafMesh<dim> &mesh,
  const LeafLayout &layout,
  const Scheme &scheme,
  const Gas &gas,
  const Boundary<dim> &boundary)
  : Base(mesh, layout, scheme, gas, boundary, std::vector<double>())
  , metric_(layout.n)
  , primitive_(nc * layout.n_points)
  , residual_(nc * layout.n_points)
  , factor_(nc * layout.n_points)
  , below_(nc * layout.n_points)
  , above_(nc * layout.n_points)
  , ghosts_(2 * dim * ghosts * layout.n_face_points)
  , line_(layout.n + 2 * ghosts)
  , left_(layout.n + 1)
  , right_(layout.n + 1)
  , flux_(layout.n + 1)
  , normal_stress_(layout.n + 1)
{}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::update(const unsigned int batch,
                                                const Stage &stage,
                                                const HangingData<dim> &)
{
  Base::bind(batch, stage);
  metric_.reinit(mesh_, batch);
  load(stage.in);
  fill_ghosts();
  if (scheme_.gradient_limiter)
    limit_gradients();
  residual_.fill(Number(0.));
  for (unsigned int direction = 0; direction < dim; ++direction)
    sweep(direction);
  finish(stage);
  if (stage.signal_rate != nullptr)
  {
    load(stage.out);
    store_sensors(stage);
  }
  else
    Base::sensor_.store(stage.sensor_out + batch * W);
}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::analyse(const unsigned int batch,
                                                 const Stage &stage)
{
  Base::bind_burn(batch, stage);
  metric_.reinit(mesh_, batch);
  load(stage.out);
  store_sensors(stage);
}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::load(const double *state)
{
  const double *values = state + batch_ * layout_.batch_size();
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c].load(values + layout_.value(c, q));
    const Values p = to_primitive<dim>(gas_, u);
    for (unsigned int c = 0; c < nc; ++c)
      primitive_[c * layout_.n_points + q] = p[c];
  }
}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::fill_ghosts()
{
  for (unsigned int face = 0; face < 2 * dim; ++face)
    fill_neighbors(face);
  wall_.fill(Number(0.));
  for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
       ++s)
    fill_boundary_lane(*s);
}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::fill_neighbors(const unsigned int face)
{
  const unsigned int n = layout_.n;
  const auto &neighbors = mesh_.neighbors(batch_, face);
  const auto &matches = mesh_.matches(batch_, face);
  std::array<unsigned int, W> offsets;
  for (unsigned int line = 0; line < layout_.n_face_points; ++line)
    for (unsigned int depth = 0; depth < ghosts; ++depth)
    {
      for (unsigned int lane = 0; lane < W; ++lane)
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
        u[c].gather(Base::in_ + layout_.value(c, 0), offsets.data());
      ghost(face, line, depth) = to_primitive<dim>(gas_, u);
    }
}


template <int dim, typename Gas>
GasState<dim> MappedFiniteVolumeKernel<dim, Gas>::primitive_lane(
  const unsigned int point,
  const unsigned int lane) const
{
  const auto value = [&](const unsigned int c) {
    return primitive_[c * layout_.n_points + point][lane];
  };
  GasState<dim> state;
  state.density = value(C::density);
  for (unsigned int d = 0; d < dim; ++d)
    state.velocity[d] = value(C::momentum + d);
  state.pressure = value(C::energy);
  if constexpr (Gas::has_products)
    state.products = value(C::products);
  return state;
}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::fill_boundary_lane(
  const SpecialFace &special)
{
  const unsigned int lane = special.lane;
  const unsigned int layer = special.face % 2 ? layout_.n : 0;
  // A wall mirrors layer by layer; other boundaries repeat the first.
  const bool is_wall =
    Base::boundary_.kind(special.index) == Boundary<dim>::Kind::wall;
  wall_[special.face][lane] = is_wall;
  for (unsigned int line = 0; line < layout_.n_face_points; ++line)
  {
    const Vector &area = metric_.area(special.face / 2, layer, line);
    const Vector &center = metric_.face_center(special.face / 2, layer, line);
    dealii::Tensor<1, dim> normal;
    dealii::Point<dim> place;
    for (unsigned int d = 0; d < dim; ++d)
    {
      normal[d] = special.face % 2 ? area[d][lane] : -area[d][lane];
      place[d] = center[d][lane];
    }
    normal /= normal.norm();
    for (unsigned int depth = 0; depth < ghosts; ++depth)
    {
      const unsigned int point = layout_.face_point(
        special.face, line, is_wall ? std::min(depth, layout_.n - 1) : 0);
      const GasState<dim> state = Base::boundary_.outside(
        special.index, primitive_lane(point, lane), normal, place, Base::time_);
      Values &outside = ghost(special.face, line, depth);
      outside[C::density][lane] = state.density;
      for (unsigned int d = 0; d < dim; ++d)
        outside[C::momentum + d][lane] = state.velocity[d];
      outside[C::energy][lane] = state.pressure;
      if constexpr (Gas::has_products)
        outside[C::products][lane] = state.products;
    }
  }
}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::sweep(const unsigned int direction)
{
  for (unsigned int line = 0; line < layout_.n_face_points; ++line)
  {
    fill_line(direction, line);
    if (Base::burn_ != nullptr)
      Base::fill_progress(direction, line);
    reconstruct(direction, line);
    line_fluxes(direction, line);
    add_flux_differences(direction, line);
  }
}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::fill_line(const unsigned int direction,
                                                   const unsigned int line)
{
  const int n = layout_.n;
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  for (unsigned int c = 0; c < nc; ++c)
  {
    const Number *values = &primitive_[c * layout_.n_points + first];
    for (int i = 0; i < n; ++i)
      cell(i)[c] = values[i * stride];
  }
  for (int depth = 0; depth < ghosts; ++depth)
  {
    cell(-1 - depth) = ghost(2 * direction, line, depth);
    cell(n + depth) = ghost(2 * direction + 1, line, depth);
  }
}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::reconstruct(
  const unsigned int direction,
  const unsigned int line)
{
  const int n = layout_.n;
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  for (int i = -1; i <= n; ++i)
  {
    Values half = {}, inner = {};
    for (unsigned int c = 0; c < nc && scheme_.linear; ++c)
    {
      const Number backward = cell(i)[c] - cell(i - 1)[c];
      const Number forward = cell(i + 1)[c] - cell(i)[c];
      half[c] = limited_slope(scheme_.limiter, backward, forward) * 0.5;
      if (scheme_.gradient_limiter && i >= 0 && i < n)
        inner[c] = (backward + forward) *
                   factor_[c * layout_.n_points + first + i * stride] * 0.25;
    }
    if (Base::careful_)
    {
      limit_velocity_slope<dim>(gas_, cell(i), half);
      limit_velocity_slope<dim>(gas_, cell(i), inner);
    }
    if (!scheme_.gradient_limiter)
      inner = half;
    Values low, high;
    for (unsigned int c = 0; c < nc; ++c)
    {
      low[c] = cell(i)[c] - (i > 0 && i < n ? inner : half)[c];
      high[c] = cell(i)[c] + (i >= 0 && i + 1 < n ? inner : half)[c];
    }
    restore_if_inadmissible<dim>(gas_, cell(i), low);
    restore_if_inadmissible<dim>(gas_, cell(i), high);
    if (i >= 0)
      right_[i] = low;
    if (i < n)
      left_[i + 1] = high;
  }
}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::line_fluxes(
  const unsigned int direction,
  const unsigned int line)
{
  const unsigned int n = layout_.n;
  for (unsigned int f = 0; f <= n; ++f)
  {
    const FaceFrame<dim, Number> frame(metric_.area(direction, f, line));
    Values left = in_frame(frame, left_[f]);
    Values right = in_frame(frame, right_[f]);
    mirror_at_walls(direction, f, left, right);
    auto left_state = to_face_state<dim>(gas_, left);
    auto right_state = to_face_state<dim>(gas_, right);
    if (Base::burn_ != nullptr)
      Base::hold_back(f, left_state, right_state);
    Number theta(1.);
    if (Base::needs_shear_factor())
    {
      Number shock = Base::sensor_;
      if (f == 0 || f == n)
        shock = std::max(
          shock, Base::neighbor_sensor_[2 * direction + (f == 0 ? 0 : 1)]);
      theta = Base::gated_shear_factor(
        shock,
        std::max(left_state.sound_speed, right_state.sound_speed),
        in_frame(frame, cell(f))[C::momentum] -
          in_frame(frame, cell(int(f) - 1))[C::momentum],
        compression(direction, f, line));
    }
    Values flux = to_array<dim, Gas>(
      numerical_flux(scheme_.flux, left_state, right_state, theta));
    // Faces to other leaves keep the flux that the neighbour computes too.
    if (Base::any_open(direction) && f > 0 && f < n && Base::burn_ == nullptr)
      Base::widen_open_flux(direction,
                            in_frame(frame, cell(int(f) - 1)),
                            in_frame(frame, cell(f)),
                            flux);
    normal_stress_[f] = flux[C::momentum];
    for (unsigned int c = 0; c < nc; ++c)
      flux_[f][c] = flux[c] * frame.area;
    for (unsigned int d = 0; d < dim; ++d)
    {
      Number stress(0.);
      for (unsigned int e = 1; e < dim; ++e)
        stress += flux[C::momentum + e] * frame.axes[e][d];
      flux_[f][C::momentum + d] = stress * frame.area;
    }
  }
}


// The limiters work on velocity components along the axes, so that the two
// traces at a slanted wall are no exact mirror images by themselves; what
// would leak through it is kept in by mirroring the inner one.
template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::mirror_at_walls(
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
      Number(0.), wall, c == C::momentum ? -inside[c] : inside[c], outside[c]);
}


template <int dim, typename Gas>
const typename MappedFiniteVolumeKernel<dim, Gas>::Number &
MappedFiniteVolumeKernel<dim, Gas>::velocity(const unsigned int direction,
                                             const unsigned int line,
                                             const int i,
                                             const unsigned int component) const
{
  const int n = layout_.n;
  if (i < 0)
    return ghost(2 * direction, line, 0)[C::momentum + component];
  if (i >= n)
    return ghost(2 * direction + 1, line, 0)[C::momentum + component];
  return primitive_[(C::momentum + component) * layout_.n_points +
                    layout_.face_point(2 * direction, line, i)];
}


// The most negative velocity difference along the face, of the cells on both
// sides of it and their neighbours within their leaves.
template <int dim, typename Gas>
typename MappedFiniteVolumeKernel<dim, Gas>::Number
MappedFiniteVolumeKernel<dim, Gas>::compression(const unsigned int direction,
                                                const unsigned int layer,
                                                const unsigned int line) const
{
  Number smallest(0.);
  unsigned int stride = 1;
  for (unsigned int along = 0; along < dim; ++along)
  {
    if (along == direction)
      continue;
    const Vector tangent = metric_.tangent(direction, layer, line, along);
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


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::add_flux_differences(
  const unsigned int direction,
  const unsigned int line)
{
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  for (unsigned int i = 0; i < layout_.n; ++i)
  {
    Number *residual = &residual_[first + i * stride];
    for (unsigned int c = 0; c < nc; ++c)
      residual[c * layout_.n_points] += flux_[i][c] - flux_[i + 1][c];
    // The pressure of the cell itself exerts no net force on it: left out,
    // a gas at rest keeps every bit.
    const Number own = Base::exerted_pressure(i, cell(i));
    const Number low = normal_stress_[i] - own;
    const Number high = normal_stress_[i + 1] - own;
    const Vector force = metric_.area(direction, i, line) * low -
                         metric_.area(direction, i + 1, line) * high;
    for (unsigned int d = 0; d < dim; ++d)
      residual[(C::momentum + d) * layout_.n_points] += force[d];
  }
}


template <int dim, typename Gas>
void MappedFiniteVolumeKernel<dim, Gas>::finish(const Stage &stage)
{
  const double *in = stage.in + batch_ * layout_.batch_size();
  const double *start = stage.start + batch_ * layout_.batch_size();
  double *out = stage.out + batch_ * layout_.batch_size();
  Number smallest(1.);
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    const Number rate = Number(stage.step) / metric_.volume(q);
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
    {
      u[c].load(in + layout_.value(c, q));
      u[c] += residual_[c * layout_.n_points + q] * rate;
      if (stage.a != 0.)
      {
        Number old;
        old.load(start + layout_.value(c, q));
        u[c] += (old - u[c]) * stage.a;
      }
      u[c].store(out + layout_.value(c, q));
    }
    smallest = std::min(smallest, is_admissible<dim>(gas_, u));
  }
  const unsigned int n_filled = mesh_.n_filled_lanes(batch_);
  for (unsigned int lane = 0; lane < n_filled; ++lane)
    if (!(smallest[lane] > 0.))
      *stage.unphysical_leaf = batch_ * W + lane;
  for (unsigned int lane = n_filled; lane < W; ++lane)
    for (std::size_t i = 0; i < layout_.batch_size(); i += W)
      out[i + lane] = out[i];
}


template class MappedFiniteVolumeKernel<2, IdealGas>;
template class MappedFiniteVolumeKernel<3, IdealGas>;
template class MappedFiniteVolumeKernel<2, MieGrueneisen>;
template class MappedFiniteVolumeKernel<3, MieGrueneisen>;
} // namespace contrecoup::gas
