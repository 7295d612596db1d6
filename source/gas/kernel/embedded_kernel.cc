// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/kernel/embedded_kernel.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup::gas
{
namespace
{
  /// One where positive, else zero.
  template <typename Number>
  Number positive(const Number &x)
  {
    return select_less(Number(0.), x, Number(1.), Number(0.));
  }
} // namespace


template <int dim, typename Gas, typename Real>
EmbeddedKernel<dim, Gas, Real>::EmbeddedKernel(const LeafMesh<dim> &mesh,
                                               const LeafLayout &layout,
                                               const Scheme &scheme,
                                               const Gas &gas,
                                               const Boundary<dim> &boundary,
                                               const CutLeaves<dim> &cut_leaves)
  : Base(mesh, layout, scheme, gas, boundary)
  , cut_leaves_(cut_leaves)
{}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::reinit()
{
  openings_of_batch_.assign(mesh_.n_batches(), -1);
  all_openings_.clear();
  for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
  {
    if (!cut_leaves_.is_cut(batch))
      continue;
    openings_of_batch_[batch] = static_cast<int>(all_openings_.size());
    Openings openings;
    openings.fraction.resize(layout_.n_points);
    if (cut_leaves_.treatment() == RigidBody::Treatment::staircase)
      openings.volume.resize(layout_.n_points);
    for (auto &faces : openings.face)
      faces.resize((layout_.n + 1) * layout_.n_face_points);
    for (auto &faces : openings.beyond)
      faces.resize(layout_.n_face_points);
    for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch); ++lane)
      take(batch * Base::width + lane, lane, openings);
    if (cut_leaves_.treatment() == RigidBody::Treatment::embedded)
      pack_walls(batch, openings);
    all_openings_.push_back(std::move(openings));
  }
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::take(const unsigned int leaf,
                                          const unsigned int lane,
                                          Openings &to) const
{
  const auto *shape = cut_leaves_.shape(leaf);
  const Real all = cut_leaves_.fractions().is_open(leaf) ? 1. : 0.;
  for (unsigned int q = 0; q < layout_.n_points; ++q)
    to.fraction[q][lane] = shape == nullptr ? all : Real(shape->fraction[q]);
  for (unsigned int q = 0; q < to.volume.size(); ++q)
    to.volume[q][lane] = cut_leaves_.cell_volume({leaf, q});
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int f = 0; f < to.face[d].size(); ++f)
      to.face[d][f][lane] = shape == nullptr ? all : Real(shape->opening[d][f]);
  for (unsigned int face = 0; face < 2 * dim; ++face)
    for (unsigned int line = 0; line < layout_.n_face_points; ++line)
      to.beyond[face][line][lane] =
        cut_leaves_.inner_opening_beyond(leaf, face, line);
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::pack_walls(const unsigned int batch,
                                                Openings &openings) const
{
  unsigned int n_filled = Base::width;
  for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch); ++lane)
  {
    const unsigned int leaf = batch * Base::width + lane;
    if (cut_leaves_.shape(leaf) == nullptr)
      continue;
    const auto size = leaf_box(mesh_, leaf).extents / double(layout_.n);
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      dealii::Tensor<1, dim> wall = cut_leaves_.wall({leaf, q});
      for (unsigned int d = 0; d < dim; ++d)
        wall[d] /= size[d];
      const double area = wall.norm();
      if (!(area > 0.) || cut_leaves_.fractions()(leaf, q) == 0.)
        continue;
      if (n_filled == Base::width)
      {
        n_filled = 0;
        openings.walls.emplace_back();
        WallPack &empty = openings.walls.back();
        empty.area = Number(0.);
        empty.volume = Number(0.);
        empty.normal.fill(Number(0.));
        empty.point.fill(q);
        empty.lane.fill(lane);
        empty.offset.fill(q * Base::width + lane);
      }
      WallPack &walls = openings.walls.back();
      walls.point[n_filled] = q;
      walls.lane[n_filled] = lane;
      walls.offset[n_filled] = q * Base::width + lane;
      for (unsigned int d = 0; d < dim; ++d)
        walls.normal[d][n_filled] = wall[d] / area;
      walls.area[n_filled] = area;
      walls.volume[n_filled] = cut_leaves_.cell_volume({leaf, q});
      ++n_filled;
    }
  }
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::update(
  const unsigned int batch,
  const BasicStage<Real> &stage,
  const HangingData<dim, Real> &hanging)
{
  Base::bind(batch, stage);
  bind_openings(batch);
  Base::load(stage.in);
  Base::residual_.fill(Number(0.));
  Base::bind_radii();
  for (unsigned int direction = 0; direction < dim; ++direction)
    sweep_openings(direction, hanging);
  add_walls();
  write(stage);
  if (stage.wall_force != nullptr)
    add_wall_force(stage);
  Base::sensor_.store(stage.sensor_out + batch * Base::width);
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::sweep_openings(
  const unsigned int direction,
  const HangingData<dim, Real> &hanging)
{
  for (unsigned int line = 0; line < layout_.n_face_points; ++line)
  {
    Base::fill_line(direction, line);
    Base::fill_line_ends(direction, line, hanging);
    if (Base::burn_ != nullptr)
      Base::fill_progress(direction, line);
    if (Base::needs_shear_factor())
      Base::fill_compression(direction, line);
    fill_touch(direction, line);
    Base::template reconstruct<true>();
    Base::line_fluxes(direction);
    Base::replace_hanging_fluxes(
      direction, line, hanging, Base::flux_[0], Base::flux_[layout_.n]);
    add_open_fluxes(direction, line);
  }
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::fill_touch(const unsigned int direction,
                                                const unsigned int line)
{
  const int n = layout_.n;
  for (int f = 0; f <= n; ++f)
    Base::touch(f) = positive(opening(direction, f, line));
  Base::touch(-1) = positive(openings_->beyond[2 * direction][line]);
  Base::touch(n + 1) = positive(openings_->beyond[2 * direction + 1][line]);
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::add_open_fluxes(
  const unsigned int direction,
  const unsigned int line)
{
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  for (unsigned int i = 0; i < layout_.n; ++i)
  {
    Number low = opening(direction, i, line);
    Number high = opening(direction, i + 1, line);
    Number inverse = inverse_size(direction);
    if constexpr (dim == 2)
      if (direction == 0 && !Base::radial_.is_plane())
      {
        low *= Base::radial_.area(i);
        high *= Base::radial_.area(i + 1);
        inverse = Base::radial_.inverse_volume(i);
      }
    for (unsigned int c = 0; c < nc; ++c)
    {
      // The pressure of the cell itself exerts no net force on it: left out,
      // a gas at rest keeps every bit.
      const Number base = c == C::momentum
                            ? Base::exerted_pressure(i, Base::cell(i))
                            : Number(0.);
      Base::residual_[rotated_component<dim>(c, direction) * layout_.n_points +
                      first + i * stride] +=
        ((Base::flux_[i][c] - base) * low -
         (Base::flux_[i + 1][c] - base) * high) *
        inverse;
    }
  }
}


template <int dim, typename Gas, typename Real>
const typename EmbeddedKernel<dim, Gas, Real>::Number &
EmbeddedKernel<dim, Gas, Real>::opening_of(const unsigned int point,
                                           const unsigned int direction,
                                           const unsigned int side) const
{
  const unsigned int s = layout_.stride(direction);
  return opening(direction,
                 point / s % layout_.n + side,
                 point % s + point / (s * layout_.n) * s);
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::add_walls()
{
  wall_force_.fill(Number(0.));
  wall_area_.fill(Number(0.));
  for (const WallPack &walls : openings_->walls)
    add_embedded_walls(walls);
  if (cut_leaves_.treatment() == RigidBody::Treatment::staircase)
    for (unsigned int q = 0; q < layout_.n_points; ++q)
      add_staircase_wall(q);
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::add_embedded_walls(const WallPack &walls)
{
  Values inside;
  for (unsigned int c = 0; c < nc; ++c)
    inside[c].gather(
      reinterpret_cast<const Real *>(&Base::primitive_[c * layout_.n_points]),
      walls.offset.data());
  Number progress(0.);
  if (Base::burn_ != nullptr)
    for (unsigned int i = 0; i < Base::width; ++i)
      progress[i] = Base::burn_->progress(
        batch_ * Base::width + walls.lane[i], walls.point[i], Base::time_);
  Number speed(0.);
  for (unsigned int d = 0; d < dim; ++d)
    speed += inside[C::momentum + d] * walls.normal[d];
  const Number pressure = wall_pressure(inside, speed, progress);
  const Number excess =
    (pressure - exerted_pressure(inside, progress)) * walls.area;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const Number change = excess * walls.normal[d];
    Number *residual = &Base::residual_[(C::momentum + d) * layout_.n_points];
    for (unsigned int i = 0; i < Base::width; ++i)
      residual[walls.point[i]][walls.lane[i]] -= change[i];
    const Number area = walls.normal[d] * walls.area * walls.volume;
    wall_force_[d] += pressure * area;
    wall_area_[d] += area;
  }
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::add_staircase_wall(
  const unsigned int point)
{
  Values inside;
  for (unsigned int c = 0; c < nc; ++c)
    inside[c] = Base::primitive_[c * layout_.n_points + point];
  Number progress(0.);
  if (Base::burn_ != nullptr)
    progress = Base::progress(point, Base::time_);
  const Number own = exerted_pressure(inside, progress);
  const Number is_gas = positive(openings_->fraction[point]);
  const Number &volume = openings_->volume[point];
  for (unsigned int d = 0; d < dim; ++d)
  {
    const Number low = is_gas - opening_of(point, d, 0) * is_gas;
    const Number high = is_gas - opening_of(point, d, 1) * is_gas;
    if (!(largest_lane(Number(low + high)) > 0.))
      continue;
    const Number speed = inside[C::momentum + d];
    const Number below = wall_pressure(inside, -speed, progress);
    const Number above = wall_pressure(inside, speed, progress);
    Base::residual_[(C::momentum + d) * layout_.n_points + point] +=
      ((below - own) * low - (above - own) * high) * inverse_size(d);
    const Number area = inverse_size(d) * volume;
    wall_force_[d] += (above * high - below * low) * area;
    wall_area_[d] += (high - low) * area;
  }
}


template <int dim, typename Gas, typename Real>
typename EmbeddedKernel<dim, Gas, Real>::Number
EmbeddedKernel<dim, Gas, Real>::wall_pressure(Values inside,
                                              const Number &speed,
                                              const Number &progress) const
{
  for (unsigned int d = 0; d < dim; ++d)
    inside[C::momentum + d] = Number(0.);
  Values image = inside;
  inside[C::momentum] = speed;
  image[C::momentum] = -speed;
  auto left = to_face_state<dim>(Base::gas_, inside);
  auto right = to_face_state<dim>(Base::gas_, image);
  if (Base::burn_ != nullptr)
  {
    Base::burn_->template hold_back<dim>(progress, left);
    Base::burn_->template hold_back<dim>(progress, right);
  }
  return to_array<dim, Gas>(
    numerical_flux(Base::scheme_.flux, left, right, Number(1.)))[C::momentum];
}


template <int dim, typename Gas, typename Real>
typename EmbeddedKernel<dim, Gas, Real>::Number
EmbeddedKernel<dim, Gas, Real>::exerted_pressure(const Values &inside,
                                                 const Number &progress) const
{
  const Number &pressure = inside[C::energy];
  if (Base::burn_ == nullptr)
    return pressure;
  return Base::burn_->pressure(
    pressure, Base::burn_->fraction(progress, inside[C::density]));
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::write(const BasicStage<Real> &stage)
{
  const Real *in = stage.in + batch_ * layout_.batch_size();
  const Real *start = stage.start + batch_ * layout_.batch_size();
  Real *out = stage.out + batch_ * layout_.batch_size();
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    const Number &fraction = openings_->fraction[q];
    const Number rate = select_less(
      Number(0.), fraction, Number(Number(stage.step) / fraction), Number(0.));
    for (unsigned int c = 0; c < nc; ++c)
    {
      Number u, old;
      u.load(in + layout_.value(c, q));
      u += Base::residual_[c * layout_.n_points + q] * rate;
      if (stage.a != 0.)
      {
        old.load(start + layout_.value(c, q));
        u += (old - u) * stage.a;
      }
      u.store(out + layout_.value(c, q));
    }
  }
  Base::fill_padding(out);
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::add_wall_force(
  const BasicStage<Real> &stage) const
{
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int lane = 0; lane < Base::width; ++lane)
    {
      (*stage.wall_force)[d] += stage.weight * double(wall_force_[d][lane]);
      (*stage.wall_force)[3 + d] += stage.weight * double(wall_area_[d][lane]);
    }
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::conclude(const unsigned int batch,
                                              const BasicStage<Real> &stage)
{
  batch_ = batch;
  const Real *out = stage.out + batch * layout_.batch_size();
  Number smallest(1.);
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c].load(out + layout_.value(c, q));
    smallest = std::min(smallest, is_admissible<dim>(Base::gas_, u));
  }
  Base::report(smallest, stage);
  Base::fill_padding(stage.out + batch * layout_.batch_size());
  if (stage.signal_rate != nullptr)
    analyse(batch, stage);
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::analyse(const unsigned int batch,
                                             const BasicStage<Real> &stage)
{
  Base::bind_burn(batch, stage);
  bind_openings(batch);
  Base::load(stage.out);
  const Number rate = Base::largest_rate(stage);
  const auto where_open = [this](const unsigned int d, const unsigned int q) {
    return positive(opening_of(q, d, 1));
  };
  Base::store_sensors(rate, Base::largest_jump(where_open), stage);
}


template class EmbeddedKernel<2, IdealGas>;
template class EmbeddedKernel<3, IdealGas>;
template class EmbeddedKernel<3, IdealGas, float>;
template class EmbeddedKernel<2, MieGrueneisen>;
template class EmbeddedKernel<3, MieGrueneisen>;
template class EmbeddedKernel<3, MieGrueneisen, float>;
} // namespace contrecoup::gas
