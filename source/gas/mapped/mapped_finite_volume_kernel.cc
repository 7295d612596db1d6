// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/finite_volume/velocity_slope.h>
#include <contrecoup/gas/mapped/mapped_finite_volume_kernel.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
MappedFiniteVolumeKernel<dim, Gas, Real>::MappedFiniteVolumeKernel(
  const OperatorContext<dim> &context,
  const Gas &gas)
  : Base(context, gas, metric_)
  , metric_(layout_.n)
  , primitive_(nc * layout_.n_points)
  , residual_(nc * layout_.n_points)
  , factor_(nc * layout_.n_points)
  , below_(nc * layout_.n_points)
  , above_(nc * layout_.n_points)
  , line_(layout_.n + 2 * n_beyond)
  , left_(layout_.n + 1)
  , right_(layout_.n + 1)
  , flux_(layout_.n + 1)
  , normal_stress_(layout_.n + 1)
{}


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::update(
  const unsigned int batch,
  const BasicStage<Real> &stage,
  const HangingData<dim, Real> &hanging)
{
  Base::bind(batch, stage);
  metric_.reinit(mesh_, batch);
  load(stage.in);
  Base::fill_beyond(primitive_.data(), hanging);
  if (scheme_.gradient_limiter)
    limit_gradients();
  residual_.fill(Number(0.));
  for (unsigned int direction = 0; direction < dim; ++direction)
    sweep(direction, hanging);
  finish(stage);
  if (stage.results.signal_rate != nullptr)
  {
    load(stage.results.state);
    store_sensors(stage);
  }
  else
    Base::sensor_.store(stage.results.sensor + batch * Base::width);
}


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::analyse(
  const unsigned int batch,
  const BasicStage<Real> &stage)
{
  Base::bind_burn(batch, stage);
  metric_.reinit(mesh_, batch);
  load(stage.results.state);
  store_sensors(stage);
}


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::load(const Real *state)
{
  const Real *values = state + batch_ * layout_.batch_size();
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


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::sweep(
  const unsigned int direction,
  const HangingData<dim, Real> &hanging)
{
  for (unsigned int line = 0; line < layout_.n_face_points; ++line)
  {
    fill_line(direction, line);
    if (Base::burn_ != nullptr)
      Base::fill_progress(direction, line);
    reconstruct(direction, line);
    line_fluxes(direction, line);
    take_hanging_fluxes(direction, line, hanging);
    add_flux_differences(direction, line);
  }
}


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::fill_line(
  const unsigned int direction,
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
  for (int depth = 0; depth < n_beyond; ++depth)
  {
    cell(-1 - depth) = Base::beyond(2 * direction, line, depth);
    cell(n + depth) = Base::beyond(2 * direction + 1, line, depth);
  }
}


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::reconstruct(
  const unsigned int direction,
  const unsigned int line)
{
  const int n = layout_.n;
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  for (int i = -1; i <= n; ++i)
  {
    Values half = {}, inner = {};
    for (unsigned int c = 0; c < nc && scheme_.linear_reconstruction; ++c)
    {
      const Number backward = cell(i)[c] - cell(i - 1)[c];
      const Number forward = cell(i + 1)[c] - cell(i)[c];
      half[c] = limited_slope(scheme_.limiter, backward, forward) * 0.5;
      if (scheme_.gradient_limiter && i >= 0 && i < n)
        inner[c] = (backward + forward) *
                   factor_[c * layout_.n_points + first + i * stride] * 0.25;
    }
    if (Base::bounds_velocity_slopes_)
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


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::line_fluxes(
  const unsigned int direction,
  const unsigned int line)
{
  const unsigned int n = layout_.n;
  for (unsigned int f = 0; f <= n; ++f)
  {
    const FaceFrame<dim, Number> frame(metric_.area(direction, f, line));
    const Values flux = Base::face_flux(direction,
                                        f,
                                        line,
                                        frame,
                                        {{left_[f], right_[f]}},
                                        {{cell(int(f) - 1), cell(f)}},
                                        Base::sensor_);
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


// They are what remains besides the pressure of the cell itself.
template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::take_hanging_fluxes(
  const unsigned int direction,
  const unsigned int line,
  const HangingData<dim, Real> &hanging)
{
  const unsigned int n = layout_.n;
  for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
       ++s)
    if (s->face / 2 == direction && s->kind != SpecialFace::Kind::boundary)
    {
      const unsigned int f = s->face % 2 ? n : 0, i = s->face % 2 ? n - 1 : 0;
      for (unsigned int c = 0; c < nc; ++c)
        flux_[f][c][s->lane] =
          hanging.flux(s->index, Base::slot_of(*s), c)[line];
      normal_stress_[f][s->lane] = Base::exerted_pressure(i, cell(i))[s->lane];
    }
}


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::add_flux_differences(
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


template <int dim, typename Gas, typename Real>
void MappedFiniteVolumeKernel<dim, Gas, Real>::finish(
  const BasicStage<Real> &stage)
{
  const Real *in = stage.in + batch_ * layout_.batch_size();
  const Real *start = stage.start + batch_ * layout_.batch_size();
  Real *out = stage.results.state + batch_ * layout_.batch_size();
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
      *stage.results.unphysical_leaf = batch_ * Base::width + lane;
  for (unsigned int lane = n_filled; lane < Base::width; ++lane)
    for (std::size_t i = 0; i < layout_.batch_size(); i += Base::width)
      out[i + lane] = out[i];
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class MappedFiniteVolumeKernel<dim, Gas, Real>
CONTRECOUP_FOR_MAPPED_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
