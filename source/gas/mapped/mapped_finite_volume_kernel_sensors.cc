// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/mapped/mapped_finite_volume_kernel.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::store_sensors(
  const BasicStage<Real> &stage)
{
  largest_signal_rate(stage.end_time)
    .store(stage.results.signal_rate + batch_ * Base::width);
  if (Base::burn_ != nullptr)
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      Number &pressure = primitive_[C::pressure * layout_.n_points + q];
      pressure = Base::burn_->pressure(pressure, burned(q, stage.end_time));
    }
  shock_sensor().store(stage.results.sensor + batch_ * Base::width);
}


template <int dim, typename Gas, typename Real>
typename MappedFiniteVolumeKernel<dim, Gas, Real>::Number
MappedFiniteVolumeKernel<dim, Gas, Real>::burned(const unsigned int point,
                                                 const double time) const
{
  return Base::burn_->fraction(Base::progress(point, time), primitive_[point]);
}


// Half the sum over the faces of (|u . S| + c |S|) / V, which is
// sum_d (|u_d| + c) / h_d of a box; over n, as if the leaf had one subcell.
template <int dim, typename Gas, typename Real>
typename MappedFiniteVolumeKernel<dim, Gas, Real>::Number
MappedFiniteVolumeKernel<dim, Gas, Real>::largest_signal_rate(
  const double time) const
{
  const unsigned int n_points = layout_.n_points;
  Number largest(0.);
  for (unsigned int q = 0; q < n_points; ++q)
  {
    Number products(0.);
    if constexpr (Gas::has_products)
      products = primitive_[C::products * n_points + q];
    Number sound_speed = std::sqrt(std::max(
      gas_.sound_speed_squared(
        primitive_[q], primitive_[C::pressure * n_points + q], products),
      Number(0.)));
    if (Base::burn_ != nullptr)
      sound_speed =
        std::max(sound_speed,
                 Number((Number(1.) - burned(q, time)) * Base::burn_->speed));
    Number sum(0.);
    for (unsigned int direction = 0; direction < dim; ++direction)
    {
      const unsigned int s = layout_.stride(direction);
      const unsigned int layer = (q / s) % layout_.n;
      const unsigned int line = q % s + (q / (s * layout_.n)) * s;
      for (unsigned int side = 0; side < 2; ++side)
      {
        const Vector &area = metric_.area(direction, layer + side, line);
        Number normal(0.);
        for (unsigned int d = 0; d < dim; ++d)
          normal += primitive_[(C::velocity + d) * n_points + q] * area[d];
        sum += std::abs(normal) + sound_speed * std::sqrt(area * area);
      }
    }
    largest = std::max(largest, Number(sum * 0.5 / metric_.volume(q)));
  }
  return largest * (1. / layout_.n);
}


template <int dim, typename Gas, typename Real>
typename MappedFiniteVolumeKernel<dim, Gas, Real>::Number
MappedFiniteVolumeKernel<dim, Gas, Real>::shock_sensor() const
{
  // A jump of the pressure by a tenth in compressed gas counts as a shock.
  const double threshold = 0.1;
  const unsigned int n_points = layout_.n_points;
  Number shock(0.);
  for (unsigned int direction = 0; direction < dim; ++direction)
  {
    const unsigned int s = layout_.stride(direction);
    for (unsigned int line = 0; line < layout_.n_face_points; ++line)
      for (unsigned int i = 0; i + 1 < layout_.n; ++i)
      {
        const unsigned int q = layout_.face_point(2 * direction, line, i);
        const Number *p = &primitive_[C::pressure * n_points + q];
        const Vector &area = metric_.area(direction, i + 1, line);
        Number divergence(0.);
        for (unsigned int d = 0; d < dim; ++d)
        {
          const Number *u = &primitive_[(C::velocity + d) * n_points + q];
          divergence += (u[s] - u[0]) * area[d];
        }
        const Number jump =
          std::abs(p[s] - p[0]) - std::min(p[0], p[s]) * threshold;
        shock = std::max(shock,
                         select_less(divergence, Number(0.), jump, Number(0.)));
      }
  }
  return select_less(Number(0.), shock, Number(1.), Number(0.));
}


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::limit_gradients()
{
  const int n = layout_.n;
  below_.fill(Number(0.));
  above_.fill(Number(0.));
  factor_.fill(Number(1.));
  for (unsigned int direction = 0; direction < dim; ++direction)
    for (unsigned int line = 0; line < layout_.n_face_points; ++line)
    {
      fill_line(direction, line);
      for (int i = 0; i < n; ++i)
        for (unsigned int c = 0; c < nc; ++c)
        {
          const unsigned int k =
            c * layout_.n_points + layout_.face_point(2 * direction, line, i);
          const Number back = cell(i - 1)[c] - cell(i)[c];
          const Number ahead = cell(i + 1)[c] - cell(i)[c];
          below_[k] = std::min(below_[k], std::min(back, ahead));
          above_[k] = std::max(above_[k], std::max(back, ahead));
        }
    }
  for (unsigned int direction = 0; direction < dim; ++direction)
    for (unsigned int line = 0; line < layout_.n_face_points; ++line)
    {
      fill_line(direction, line);
      for (int i = 0; i < n; ++i)
        limit_increments(i, layout_.face_point(2 * direction, line, i));
    }
}


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::limit_increments(
  const int i,
  const unsigned int point)
{
  // Changes below this part of the value (of the velocity: of the sound
  // speed) are a plateau for the limiters that know one.
  const double plateau = 1e-3;
  const Values &here = cell(i);
  Number products(0.);
  if constexpr (Gas::has_products)
    products = here[C::products];
  const Number speed_squared = std::max(
    gas_.sound_speed_squared(here[C::density], here[C::pressure], products),
    Number(0.));
  for (unsigned int c = 0; c < nc; ++c)
  {
    const unsigned int k = c * layout_.n_points + point;
    const bool is_velocity = c >= C::velocity && c < C::pressure;
    const Number square =
      (is_velocity ? speed_squared : here[c] * here[c]) * (plateau * plateau);
    const Number increment = (cell(i + 1)[c] - cell(i - 1)[c]) * 0.25;
    for (const Number &change : {increment, Number(-increment)})
      factor_[k] = std::min(
        factor_[k],
        gradient_limiter_factor(
          *scheme_.gradient_limiter, below_[k], above_[k], change, square));
  }
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class MappedFiniteVolumeKernel<dim, Gas, Real>
CONTRECOUP_FOR_MAPPED_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
