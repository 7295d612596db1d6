// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/finite_volume/embedded_kernel.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/stage/kernel_instances.h>

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


/// One where the face between a point and the next is open, else zero.
template <int dim, typename Gas, typename Real>
struct EmbeddedKernel<dim, Gas, Real>::OpenFaces
{
  Number operator()(const unsigned int direction,
                    const unsigned int point) const
  {
    return positive(kernel.opening_of(point, direction, 1));
  }

  const EmbeddedKernel &kernel;
};


template <int dim, typename Gas, typename Real>
EmbeddedKernel<dim, Gas, Real>::EmbeddedKernel(
  const OperatorContext<dim> &context,
  const Gas &gas,
  PrimitiveField<dim, Gas, Real> &primitives)
  : mesh_(context.mesh)
  , layout_(context.layout)
  , scheme_(context.scheme)
  , gas_(gas)
  , cut_leaves_(*context.cut_leaves)
  , radial_(radial_exponent(context.mesh.coarse_mesh().geometry()), layout_.n)
  , sweep_(context, gas, primitives)
  , state_analysis_(context.mesh, context.layout, gas, sweep_.leaves())
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
      take(batch * width + lane, lane, openings);
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
  to.is_cut[lane] = shape == nullptr ? 0. : 1.;
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
  unsigned int n_filled = width;
  for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch); ++lane)
  {
    const unsigned int leaf = batch * width + lane;
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
      if (n_filled == width)
      {
        n_filled = 0;
        openings.walls.emplace_back();
        WallPack &empty = openings.walls.back();
        empty.area = Number(0.);
        empty.volume = Number(0.);
        empty.normal.fill(Number(0.));
        empty.point.fill(q);
        empty.lane.fill(lane);
        empty.offset.fill(Primitives::index(0, q) + lane);
      }
      WallPack &walls = openings.walls.back();
      walls.point[n_filled] = q;
      walls.lane[n_filled] = lane;
      walls.offset[n_filled] = Primitives::index(0, q) + lane;
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
  sweep_.bind(batch, stage);
  batch_ = batch;
  burn_ = sweep_.leaves().burn();
  bind_openings(batch);
  for (unsigned int direction = 0; direction < dim; ++direction)
    sweep(direction, hanging);
  add_walls(stage.time);
  write(stage);
  if (stage.results.wall_force != nullptr)
    add_wall_force(stage);
  sweep_.leaves().sensor().store(stage.results.sensor + batch * width);
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::sweep(
  const unsigned int direction,
  const HangingData<dim, Real> &hanging)
{
  CutFaces<Number> faces;
  faces.stride = layout_.n_face_points;
  faces.inverse_size = inverse_size(direction);
  faces.has_unequal_areas = openings_->is_cut;
  if constexpr (dim == 2)
    if (direction == 0 && !radial_.is_plane())
    {
      radial_.reinit(mesh_.origins(batch_)[0], mesh_.extents(batch_)[0]);
      faces.weights = &radial_;
      faces.has_unequal_areas = Number(1.);
    }
  sweep_.sweep(direction, hanging, [&](const unsigned int line) {
    faces.opening = &opening(direction, 0, line);
    for (unsigned int side = 0; side < 2; ++side)
      faces.beyond[side] = &openings_->beyond[2 * direction + side][line];
    return faces;
  });
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
void EmbeddedKernel<dim, Gas, Real>::add_walls(const double time)
{
  wall_force_.fill(Number(0.));
  wall_area_.fill(Number(0.));
  for (const WallPack &walls : openings_->walls)
    add_embedded_walls(walls, time);
  if (cut_leaves_.treatment() == RigidBody::Treatment::staircase)
    for (unsigned int q = 0; q < layout_.n_points; ++q)
      add_staircase_wall(q, time);
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::add_embedded_walls(const WallPack &walls,
                                                        const double time)
{
  Values inside;
  for (unsigned int c = 0; c < nc; ++c)
    inside[c].gather(sweep_.primitive() + Primitives::index(c, 0),
                     walls.offset.data());
  Number progress(0.);
  if (burn_ != nullptr)
    for (unsigned int i = 0; i < width; ++i)
      progress[i] =
        burn_->progress(batch_ * width + walls.lane[i], walls.point[i], time);
  Number speed(0.);
  for (unsigned int d = 0; d < dim; ++d)
    speed += inside[C::velocity + d] * walls.normal[d];
  const Number pressure = wall_pressure(inside, speed, progress);
  const Number excess =
    (pressure - exerted_pressure(inside, progress)) * walls.area;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const Number change = excess * walls.normal[d];
    for (unsigned int i = 0; i < width; ++i)
      sweep_.rate(C::momentum + d, walls.point[i])[walls.lane[i]] -= change[i];
    const Number area = walls.normal[d] * walls.area * walls.volume;
    wall_force_[d] += pressure * area;
    wall_area_[d] += area;
  }
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::add_staircase_wall(
  const unsigned int point,
  const double time)
{
  Values inside;
  for (unsigned int c = 0; c < nc; ++c)
    inside[c].load(sweep_.primitive() + Primitives::index(c, point));
  Number progress(0.);
  if (burn_ != nullptr)
    progress = sweep_.leaves().progress(point, time);
  const Number own = exerted_pressure(inside, progress);
  const Number is_gas = positive(openings_->fraction[point]);
  const Number &volume = openings_->volume[point];
  for (unsigned int d = 0; d < dim; ++d)
  {
    const Number low = is_gas - opening_of(point, d, 0) * is_gas;
    const Number high = is_gas - opening_of(point, d, 1) * is_gas;
    if (!(largest_lane(Number(low + high)) > 0.))
      continue;
    const Number speed = inside[C::velocity + d];
    const Number below = wall_pressure(inside, -speed, progress);
    const Number above = wall_pressure(inside, speed, progress);
    sweep_.rate(C::momentum + d, point) +=
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
    inside[C::velocity + d] = Number(0.);
  Values image = inside;
  inside[C::velocity] = speed;
  image[C::velocity] = -speed;
  auto left = to_face_state<dim>(gas_, inside);
  auto right = to_face_state<dim>(gas_, image);
  if (burn_ != nullptr)
  {
    burn_->template apply_burn_pressure<dim>(progress, left);
    burn_->template apply_burn_pressure<dim>(progress, right);
  }
  return to_array<dim, Gas>(
    numerical_flux(scheme_.flux, left, right, Number(1.)))[C::momentum];
}


template <int dim, typename Gas, typename Real>
typename EmbeddedKernel<dim, Gas, Real>::Number
EmbeddedKernel<dim, Gas, Real>::exerted_pressure(const Values &inside,
                                                 const Number &progress) const
{
  const Number &pressure = inside[C::pressure];
  if (burn_ == nullptr)
    return pressure;
  return burn_->pressure(pressure,
                         burn_->fraction(progress, inside[C::density]));
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::write(const BasicStage<Real> &stage)
{
  const Real *in = stage.in + batch_ * layout_.batch_size();
  const Real *start = stage.start + batch_ * layout_.batch_size();
  Real *out = stage.results.state + batch_ * layout_.batch_size();
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    const Number &fraction = openings_->fraction[q];
    const Number rate = select_less(
      Number(0.), fraction, Number(Number(stage.step) / fraction), Number(0.));
    for (unsigned int c = 0; c < nc; ++c)
    {
      Number u, old;
      u.load(in + layout_.value(c, q));
      u += sweep_.rate(c, q) * rate;
      if (stage.a != 0.)
      {
        old.load(start + layout_.value(c, q));
        u += (old - u) * stage.a;
      }
      u.store(out + layout_.value(c, q));
    }
  }
  state_analysis_.fill_padding(batch_, out);
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::add_wall_force(
  const BasicStage<Real> &stage) const
{
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      (*stage.results.wall_force)[d] +=
        stage.weight * double(wall_force_[d][lane]);
      (*stage.results.wall_force)[3 + d] +=
        stage.weight * double(wall_area_[d][lane]);
    }
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::conclude(const unsigned int batch,
                                              const BasicStage<Real> &stage)
{
  bind_openings(batch);
  state_analysis_.conclude(batch, stage, OpenFaces{*this});
}


template <int dim, typename Gas, typename Real>
void EmbeddedKernel<dim, Gas, Real>::analyse(const unsigned int batch,
                                             const BasicStage<Real> &stage)
{
  bind_openings(batch);
  state_analysis_.analyse(batch, stage, OpenFaces{*this});
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class EmbeddedKernel<dim, Gas, Real>
CONTRECOUP_FOR_MAPPED_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
